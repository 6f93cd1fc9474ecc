// SPDX-License-Identifier: MIT
#include <arcspan/version.hpp>

namespace arcspan {

const char* version() { return ARCSPAN_VERSION_TEXT; }

}  // namespace arcspan
