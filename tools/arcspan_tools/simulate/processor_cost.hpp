// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/texture/texture_binary.hpp>

#include <arcspan_tools/render/render.hpp>
#include <arcspan_tools/simulate/draw_events.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What a processor takes to draw a picture: events of drawing it (DrawEvents), each times a weight of
/// docs/estimates.json in instructions, which scripts/simulate-estimates fits to drawings on emulated boards.
namespace arcspan::tools {

/// The core whose costs `arcspan simulate` prints, a Cortex-M3, by its name in docs/estimates.json.
inline constexpr std::string_view kSimulatedCore = "mps2-an385";

/// The weights of what is done with outlines.
inline constexpr const char* kOutlineWeights = "outlines";

/// The events of a part, or of all outlines, and the name of the weights that they are multiplied by.
struct PartEvents {
  std::string weights;
  std::vector<CostTerm> terms;
};

/// The events of drawing the parts of a job by a method, those with textures by its textured form (of
/// GreyGouraud for gouraud) with texels of `layout`, and at last those of its outlines, if it has some.
/// Nothing if there are several lights, toon light by arc, or an effect or a method without weights.
[[nodiscard]] std::optional<std::vector<PartEvents>> picture_events(
    std::string_view shading, const RenderJob& job, TexelLayout layout = TexelLayout::kPalette8);

/// Instructions that a core takes for these events; nothing if it has no weights for them.
[[nodiscard]] std::optional<double> instructions_on(std::string_view core,
                                                    const std::vector<PartEvents>& picture);

/// Instructions that a core takes to draw a job with vertices that are kept, and in bands the rows of
/// triangles, without clearing; nothing where either of the two above has nothing.
[[nodiscard]] std::optional<double> draw_instructions(std::string_view core, std::string_view shading,
                                                      const RenderJob& job);

/// A cost of posing a character or of clearing on a core: an entry of its list "pose", such as "joint".
[[nodiscard]] double pose_cost(std::string_view core, const std::string& name);

}  // namespace arcspan::tools
