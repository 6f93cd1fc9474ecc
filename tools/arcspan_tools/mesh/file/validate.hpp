// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/load.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::tools {

/// The largest number of corners of a face. The loader library's time grows with the square of that number
/// or faster.
inline constexpr std::int64_t kMostCorners = 4096;

/// A mesh file as the loader library is to get it.
struct ScreenedMesh {
  std::string text;
  std::vector<std::string> warnings;  ///< as in MeshData
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
/// is there. Lines that do not matter to a shape (materials, groups, texture coordinates) are left out where
/// the format allows it, with a warning if they would change the picture. Throws a Failure that names the
/// line.
[[nodiscard]] ScreenedMesh screened(std::string_view bytes, MeshFormat format, const std::string& subject);

[[nodiscard]] ScreenedMesh screened_obj(std::string_view bytes, const std::string& subject);
[[nodiscard]] ScreenedMesh screened_ply(std::string_view bytes, const std::string& subject);
[[nodiscard]] ScreenedMesh screened_stl(std::string_view bytes, const std::string& subject);
[[nodiscard]] ScreenedMesh screened_off(std::string_view bytes, const std::string& subject);

}  // namespace arcspan::tools
