// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/read_mtl.hpp>
#include <arcspan_tools/mesh/file/side_files.hpp>
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace arcspan::tools {

/// The statements of an OBJ file that say to which part a face belongs: o, g and usemtl.
class ObjLooks {
 public:
  /// Reads the material libraries (mtllib), which are looked for with `files`.
  void read_libraries(const std::vector<Readings>& libraries, const SideFiles& files);

  /// Takes the current line if it is one of these statements.
  void note(const TextLines& lines);

  /// The number of the look that a face has which comes now.
  [[nodiscard]] std::uint32_t current();

  /// All looks by number, with their materials and textures; adds to `warnings` what is missing or not drawn.
  [[nodiscard]] std::vector<PartLook> finish(const SideFiles& files, std::vector<std::string>& warnings);

 private:
  /// The names of a part and that of its material.
  using Key = std::pair<std::vector<std::string>, std::string>;

  [[nodiscard]] std::string material_name();

  MtlMaterials materials_;
  std::set<std::string> missing_;    ///< libraries
  std::set<std::string> undefined_;  ///< materials
  std::vector<std::string> object_;
  std::vector<std::string> groups_;
  Readings material_{""};
  std::map<Key, std::uint32_t> numbers_;
  bool changed_ = true;
  std::uint32_t current_ = 0;
};

}  // namespace arcspan::tools
