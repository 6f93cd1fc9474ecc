// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/linux_host/result.hpp>

#include <cstdint>

namespace arcspan::linux_host::drm {

/// Shows the framebuffer `framebuffer` on the lit CRTC `crtc` of the card `fd` from the next refresh on, and
/// waits for it. `flipped` is false if the driver cannot do this; the visible picture is then as before.
/// kTimeout if it does not happen within a second, kTransferFailed if the card cannot be read.
Result flip_page(int fd, std::uint32_t crtc, std::uint32_t framebuffer, bool& flipped);

}  // namespace arcspan::linux_host::drm
