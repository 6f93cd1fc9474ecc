// SPDX-License-Identifier: MIT
// Compiles the header-only parts of hal/ once for every format, so that the built object can be checked.
#include <arcspan/hal/framebuffer.hpp>

namespace arcspan::hal {

template class Framebuffer<Rgb565>;
template class Framebuffer<Rgb888>;
template class Framebuffer<Gray8>;
template class Framebuffer<Gray4>;
template class Framebuffer<Mono>;

}  // namespace arcspan::hal
