// SPDX-License-Identifier: MIT
#include <tests/firmware/cost_figure.hpp>
#include <tests/frames/figure.hpp>

namespace arcspan {
namespace {

constexpr std::size_t kMostVertices = 4096;

constexpr auto kFigure = scenes::make_figure();
static_assert(kFigure.positions.size() <= kMostVertices);

}  // namespace

bool make_character_mesh(MeshView& mesh) { return ok(kFigure.view(mesh)); }

}  // namespace arcspan
