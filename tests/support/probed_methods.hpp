// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/vertex/raster_vertex.hpp>

#include <tests/support/probe.hpp>
#include <tests/support/run_list.hpp>

#include <array>
#include <string_view>

// The methods of the literature with Probe, instantiated once for all tests that compare them.
namespace arcspan::test {

/// A triangle as a method gets it: points on the screen and unit normals.
struct ProbedTriangle {
  std::array<RasterPosition, 3> points{};
  std::array<Direction, 3> normals{};
};

/// Draws a triangle into the bounds of `runs`, whose middle is the origin: a sample per pixel is appended to
/// `*probe.samples`, a run per row to `runs`.
using DrawProbed = void (*)(const ProbedTriangle& triangle, const Probe& probe, RunList& runs);

/// The function of a method of shading_method_list.hpp. Dichotomy with segments of other lengths than 8
/// pixels has that length at the end of its name: dichotomy-quadratic-2, -4 and -16, dichotomy-cubic-16.
/// Throws std::out_of_range if there is no such method.
[[nodiscard]] DrawProbed probed_method(std::string_view name);

}  // namespace arcspan::test
