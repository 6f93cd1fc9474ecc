# SPDX-License-Identifier: MIT
# The pictures that examples send, equal on the host and on all boards: look at the frames (ARCSPAN_GLASS, see
# host/simulated_devices.hpp) before you change one.
set(golden_of_walker "bytes: 3076413, hash: 1228050043")
