// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/side_files.hpp>
#include <arcspan_tools/mesh/gltf/json_view.hpp>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::tools {

/// A glTF file of version 2.0 (.gltf or .glb) or 1.0 (.gltf), with its buffers. Lists are arrays in 2.0 and
/// objects in 1.0; elements refer to each other by index or by name. Throws a Failure that names the place.
class GltfFile {
 public:
  GltfFile(std::string_view bytes, std::string subject, SideFiles files);
  GltfFile(const GltfFile&) = delete;
  GltfFile& operator=(const GltfFile&) = delete;

  [[nodiscard]] int version() const { return version_; }
  [[nodiscard]] JsonView root() const { return {json_, subject_}; }
  [[nodiscard]] const std::string& subject() const { return subject_; }

  /// The element of a list of the root that `id`, an index or a name, refers to.
  [[nodiscard]] JsonView element(const char* list, const JsonView& id) const;
  /// Bytes of a buffer view, from `offset` on.
  [[nodiscard]] std::string_view view_bytes(const JsonView& view, std::size_t offset);
  /// Bytes of an element of `images`; nothing if it is in a file that cannot be read.
  [[nodiscard]] std::optional<std::string> image_bytes(const JsonView& image);

 private:
  void read_binary(std::string_view bytes);
  void parse(std::string_view text);
  void check_extensions() const;
  const std::string& buffer(const JsonView& id);
  [[nodiscard]] std::optional<std::string> find_uri(const JsonView& uri) const;
  [[nodiscard]] std::string read_uri(const JsonView& uri) const;

  std::string subject_;
  SideFiles files_;
  nlohmann::json json_;
  int version_ = 2;
  std::string chunk_;                           ///< the buffer within a .glb
  std::map<std::string, std::string> buffers_;  ///< by place
};

}  // namespace arcspan::tools
