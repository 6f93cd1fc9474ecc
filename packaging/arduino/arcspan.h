// SPDX-License-Identifier: MIT
// Header for sketches. Arduino finds a library by a header in its src folder.
#pragma once

#if __cplusplus < 202002L
#error \
    "arcspan needs C++20: choose a core that compiles it, or write compiler.cpp.extra_flags=-std=gnu++20 into platform.local.txt"
// No such file: it ends the compilation here, where thousands of errors would follow.
#include "arcspan needs -std=gnu++20, or take the library arcspan_c"
#endif

// Old cores define these names as macros, which the headers of the C++ library do not survive.
#pragma push_macro("abs")
#pragma push_macro("max")
#pragma push_macro("min")
#pragma push_macro("round")
#pragma push_macro("word")
#undef abs
#undef max
#undef min
#undef round
#undef word

#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/lighting/colour_coefficients.hpp>
#include <arcspan/mesh/mesh_binary.hpp>
#include <arcspan/overlay/caption.hpp>
#include <arcspan/overlay/needle.hpp>
#include <arcspan/overlay/rectangle.hpp>
#include <arcspan/pixel/pixel_format_list.hpp>
#include <arcspan/scene.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/version.hpp>

#include <arcspan_display.h>

#pragma pop_macro("abs")
#pragma pop_macro("max")
#pragma pop_macro("min")
#pragma pop_macro("round")
#pragma pop_macro("word")
