// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/argb8888.hpp>
#include <arcspan/pixel/bgr888.hpp>
#include <arcspan/pixel/gray2.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/mono.hpp>
#include <arcspan/pixel/rgb332.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/rgb565_swapped.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/pixel/xrgb8888.hpp>

/// The list of all pixel formats: `entry(name, Type)` for each, with `name` as on the tools' command lines.
/// Tools and tests are made from this list. Firmware includes only the header of its format.
#define ARCSPAN_FOR_EACH_PIXEL_FORMAT(entry)                                                            \
  entry(rgb565, Rgb565) entry(rgb888, Rgb888) entry(gray8, Gray8) entry(gray4, Gray4) entry(mono, Mono) \
      entry(rgb565_swapped, Rgb565Swapped) entry(bgr888, Bgr888) entry(xrgb8888, Xrgb8888)              \
          entry(argb8888, Argb8888) entry(rgb332, Rgb332) entry(gray2, Gray2)
