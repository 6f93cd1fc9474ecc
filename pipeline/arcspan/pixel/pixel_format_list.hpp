// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/mono.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/rgb888.hpp>

/// Every pixel format of the library, once: `entry(name, Type)`, where `name` is what people write on a
/// command line. Tools, tests and checks are made from this list; firmware includes the header of its format.
#define ARCSPAN_FOR_EACH_PIXEL_FORMAT(entry) \
  entry(rgb565, Rgb565) entry(rgb888, Rgb888) entry(gray8, Gray8) entry(gray4, Gray4) entry(mono, Mono)
