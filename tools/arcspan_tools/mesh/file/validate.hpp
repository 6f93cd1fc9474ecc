// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/mesh/file/side_files.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::tools {

/// The largest number of corners of a face. The loader library's time grows with the square of that number
/// or faster.
inline constexpr std::int64_t kMostCorners = 4096;

/// What a face of a file has besides its corners.
struct FaceTag {
  std::uint32_t look = 0;  ///< an index into ScreenedMesh::looks
  std::uint32_t smoothing = RawMesh::kSmooth;
  std::optional<Vec3> colour{};  ///< of the face itself, display values
};

/// A mesh file as the loader library is to get it, and the rest of it, which the library does not see.
struct ScreenedMesh {
  std::string text;
  MeshFormat format = MeshFormat::kObj;  ///< of `text`
  std::vector<std::string> warnings{};   ///< as in Model
  std::vector<PartLook> looks{1};
  /// Empty if all faces are alike; otherwise `text` is an OBJ whose corners have texture coordinates: the
  /// number of the face, from 0, and a number that is an index of both lists below.
  std::vector<FaceTag> faces{};
  /// Empty, or colours of corners, display values.
  std::vector<std::optional<Vec3>> vertex_colours{};
  /// Empty, or texture points of corners.
  std::vector<std::optional<Uv>> texture_points{};
};

/// Counts the triangles that faces become, before the loader library has to make them.
class TriangleCount {
 public:
  explicit TriangleCount(const std::string& subject) : subject_(subject) {}

  /// Throws a Failure when there are more than kMaxTriangles.
  void add_face(std::int64_t corners);

 private:
  std::string subject_;
  std::int64_t triangles_ = 0;
};

/// Checks the bytes of a mesh file before the loader library sees them, and returns what the library is to be
/// given. The library takes words for zeros, skips what it does not understand and has been seen to crash on
/// damaged files; after this every number is one and finite, every index exists and every announced element
/// is there. Materials, groups and colours are kept beside the text; what is not drawn (textures, curves) is
/// left out, with a warning. `files` reads the files that this one refers to. Throws a Failure that names the
/// line.
[[nodiscard]] ScreenedMesh screened(std::string_view bytes, MeshFormat format, const std::string& subject,
                                    const SideFiles& files);

[[nodiscard]] ScreenedMesh screened_obj(std::string_view bytes, const std::string& subject,
                                        const SideFiles& files);
[[nodiscard]] ScreenedMesh screened_ply(std::string_view bytes, const std::string& subject);
[[nodiscard]] ScreenedMesh screened_stl(std::string_view bytes, const std::string& subject);
[[nodiscard]] ScreenedMesh screened_off(std::string_view bytes, const std::string& subject);

}  // namespace arcspan::tools
