// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/compare/comparison.hpp>

#include <string>
#include <vector>

/// A method that only claims_report measures.
struct MeasuredVariant {
  std::string shading;
  arcspan::tools::RenderFunction* render;
};
std::vector<MeasuredVariant> measured_variants();

/// Measures what the papers say of speed and prints it; `self` is this program, which is run under valgrind
/// for each mesh, as `self --draw MESH SHADING SEGMENT_BITS [SHADING SEGMENT_BITS]...`. Where times are left
/// out it prints "untimed" for them.
void print_speed(const std::string& self, arcspan::tools::Timing timing);

/// Draws once, for valgrind.
void draw_once(const std::string& shading, const std::string& mesh, int segment_bits);
