// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/model.hpp>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace arcspan::tools {

/// The names of picture files.
struct MtlTexture {
  std::string colour{};   ///< map_Kd
  std::string opacity{};  ///< map_d
};

/// The materials of MTL files, by name.
struct MtlMaterials {
  std::map<std::string, FileMaterial, std::less<>> by_name{};
  std::set<std::string, std::less<>> not_drawn{};  ///< statements that ask for what is not drawn
  /// The texture of each material that has one, by the material's name.
  std::map<std::string, MtlTexture, std::less<>> textures{};
  bool invisible = false;   ///< a material was fully transparent
  bool too_bright = false;  ///< a colour was above 1
};

/// Adds the materials of an MTL file. Kd is the colour, Ks and Ns the highlight, Ke the emission. Ka is the
/// ambient colour if its channels differ; grey ones, which exporters write without a meaning, leave it to Kd.
/// illum 0 is unlit, 1 has no highlight. d, or 1 - Tr, is the opacity. map_Kd is a texture; a Kd of black is
/// then taken for white, because it would hide it. Throws a Failure that names the line.
void read_mtl(std::string_view bytes, const std::string& subject, MtlMaterials& materials);

/// A line for each kind of content of `materials` that is not drawn.
[[nodiscard]] std::vector<std::string> warnings_of(const MtlMaterials& materials);

}  // namespace arcspan::tools
