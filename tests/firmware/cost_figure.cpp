// SPDX-License-Identifier: MIT
#include <tests/firmware/cost_character.hpp>
#include <tests/frames/figure.hpp>

namespace arcspan {
namespace {

constexpr auto kFigure = scenes::make_figure();
static_assert(kFigure.positions.size() <= kCharacterVertices);

}  // namespace

bool make_character_mesh(MeshView& mesh) { return ok(kFigure.view(mesh)); }

}  // namespace arcspan
