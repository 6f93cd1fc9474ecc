// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/file_pictures.hpp>
#include <arcspan_tools/mesh/file/left_out.hpp>
#include <arcspan_tools/mesh/gltf/gltf_file.hpp>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace arcspan::tools {

/// How a material of glTF maps a texture: which coordinates it takes, and the transform of them that
/// KHR_texture_transform states.
struct GltfMapping {
  std::int64_t set = 0;  ///< TEXCOORD_0, TEXCOORD_1 ...
  Uv offset{};
  double rotation = 0;  ///< counter-clockwise, in radians
  Uv scale{1, 1};

  [[nodiscard]] Uv operator()(Uv point) const;
  friend bool operator==(const GltfMapping&, const GltfMapping&) = default;
};

/// Reads the mapping of a texture info, which is a member of a material such as baseColorTexture.
[[nodiscard]] GltfMapping read_gltf_mapping(const JsonView& info);

/// The textures of a glTF file, each picture once.
class GltfTextures {
 public:
  /// Gives a material the texture that `id`, an index or a name, refers to, with its sampler; none if its
  /// picture cannot be read. What its sampler asks for and is not drawn is added to `left_out`.
  void read(GltfFile& file, const JsonView& id, LeftOut& left_out, FileMaterial& material);

  /// Adds a line about pictures that could not be read.
  void warn(std::vector<std::string>& warnings) const { pictures_.warn(warnings); }

 private:
  [[nodiscard]] std::shared_ptr<const FileTexture> picture(GltfFile& file, const JsonView& source);

  FilePictures pictures_;
  std::set<std::string> known_;  ///< textures, by place
};

}  // namespace arcspan::tools
