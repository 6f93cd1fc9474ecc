// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/left_out.hpp>
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::tools {

/// A material of an MTL file with the names of its picture files.
struct MtlEntry {
  FileMaterial look{};
  Readings colour_map{};   ///< map_Kd
  Readings opacity_map{};  ///< map_d
};

/// The materials of MTL files.
struct MtlMaterials {
  /// By their names as they are written, and these for each other reading of them.
  std::map<std::string, MtlEntry, std::less<>> by_name{};
  std::map<std::string, std::string, std::less<>> written_for{};
  LeftOut left_out{};       ///< what is not drawn of them
  bool invisible = false;   ///< a material was fully transparent
  bool too_bright = false;  ///< a colour was above 1
  std::size_t wrong = 0;    ///< statements that are none
  std::string first_wrong{};

  /// The material of a name, as it is written in the file if possible; null if there is none.
  [[nodiscard]] const MtlEntry* find(const Readings& name) const;
};

/// Adds the materials of an MTL file. Kd is the colour, Ks and Ns the highlight, Ke the emission. Ka is the
/// ambient colour if its channels differ; grey ones, which exporters write without a meaning, leave it to Kd.
/// illum 0 is unlit, 1 has no highlight. d, or 1 - Tr, is the opacity. map_Kd is a texture, clamped with
/// -clamp on; a Kd of black is then taken for white, because it would hide it. A wrong statement is left out
/// and counted. `folder` is the file's within that of the model, "" or with a slash at its end.
void read_mtl(std::string_view bytes, const std::string& subject, const std::string& folder,
              MtlMaterials& materials);

/// Adds a line for each kind of content of `materials` that is not drawn.
void warn_of(const MtlMaterials& materials, std::vector<std::string>& warnings);

}  // namespace arcspan::tools
