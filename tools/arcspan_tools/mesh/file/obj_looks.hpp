// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/side_files.hpp>
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace arcspan::tools {

/// The statements of an OBJ file that say to which part a face belongs: o, g, usemtl and mtllib.
class ObjLooks {
 public:
  /// Takes the current line if it is one of these.
  void note(const TextLines& lines);

  /// The number of the look that a face has which comes now.
  [[nodiscard]] std::uint32_t current();

  /// All looks by number, with their materials; adds to `warnings` what is missing or not drawn. Throws a
  /// Failure for a wrong MTL file.
  [[nodiscard]] std::vector<PartLook> finish(const SideFiles& files, std::vector<std::string>& warnings);

 private:
  /// The names of a part and that of its material.
  using Key = std::pair<std::vector<std::string>, std::string>;

  std::string object_;
  std::vector<std::string> groups_;
  std::string material_;
  std::vector<std::string> libraries_;
  std::map<Key, std::uint32_t> numbers_;
  bool changed_ = true;
  std::uint32_t current_ = 0;
};

}  // namespace arcspan::tools
