// SPDX-License-Identifier: MIT
// Header for sketches. Arduino finds a library by a header in its src folder.
#pragma once

#if __cplusplus < 202002L
#error "arcspan needs C++20: choose a core whose compiler flags have -std=gnu++20 or newer, or add the flag"
#endif

#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/mesh/mesh_binary.hpp>
#include <arcspan/pixel/pixel_format_list.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>
