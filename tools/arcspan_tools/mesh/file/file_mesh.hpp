// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/left_out.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace arcspan::tools {

/// The largest number of corners of a face, because the time of triangulation grows with its square.
inline constexpr std::int64_t kMostCorners = 4096;

// Kinds of what is left out.
inline constexpr const char* kWrongNormals = "normals that are not finite numbers";
inline constexpr const char* kWrongTexturePoints = "texture coordinates that are not finite numbers";
inline constexpr const char* kWrongColours = "vertex colours that are not finite numbers";
inline constexpr const char* kOpacityOfVertices = "opacity of vertices";

/// Counts the triangles that faces become, before they are made.
class TriangleCount {
 public:
  explicit TriangleCount(const std::string& subject) : subject_(subject) {}

  /// Throws a Failure when there are more than kMaxTriangles.
  void add_face(std::size_t corners);

 private:
  std::string subject_;
  std::size_t triangles_ = 0;
};

/// The lists of a mesh file, and faces whose corners are indices of them, as the readers fill them. What is
/// wrong with a position matters only if a face uses it; normals, texture points and colours that are wrong,
/// and faces with fewer than three corners, are left out.
class FileMesh {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  struct Corner {
    std::uint32_t position = 0;
    std::uint32_t normal = kNone;
    std::uint32_t texture_point = kNone;
  };
  /// What a face has besides its corners.
  struct FaceLook {
    std::uint32_t look = 0;  ///< an index into RawModel::looks
    std::uint32_t smoothing = RawMesh::kSmooth;
    std::optional<Vec3> colour{};  ///< as those of positions
  };

  explicit FileMesh(const std::string& subject) : subject_(subject), count_(subject) {}

  std::vector<std::optional<Vec3>> normals{};
  std::vector<std::optional<Uv>> texture_points{};
  /// Empty, or of each position: 0...1, or 0...255 if any is above 1.
  std::vector<std::optional<Vec3>> colours{};
  LeftOut left_out{};

  /// Adds the position that `read` returns, or keeps the Failure that it throws for the face that needs it.
  template <class Read>
  void add_position(const Read& read) {
    try {
      positions_.push_back(read());
    } catch (const Failure& failure) {
      wrong_.emplace(positions_.size(), failure);
      positions_.emplace_back();
    }
  }

  /// What `read` returns; nothing, counted as `kind`, if it throws a Failure.
  template <class Read>
  auto if_right(const char* kind, const Read& read) -> std::optional<decltype(read())> {
    try {
      return read();
    } catch (const Failure&) {
      left_out.add(kind);
      return std::nullopt;
    }
  }

  /// Adds a face. Its corners' positions are indices of positions that are there now or come later. Throws a
  /// Failure when there are too many triangles.
  void add_face(std::span<const Corner> corners, const FaceLook& look);

  [[nodiscard]] std::size_t position_count() const { return positions_.size(); }

  /// The triangles of all faces. `looks` are those that faces refer to. Throws a Failure if there is no face,
  /// or if a position that a face uses is wrong.
  [[nodiscard]] RawModel model(std::vector<PartLook> looks = {PartLook{}},
                               std::vector<std::string> warnings = {});

 private:
  struct Face {
    std::size_t first = 0;
    std::size_t size = 0;
    FaceLook look{};
  };

  /// Rounded to floats, as binary files have them: a text gives the same mesh, and rounding errors of doubles
  /// do not keep vertices apart.
  static Vec3 as_floats(const Vec3& v);
  /// Whether the positions of the faces keep their shape as floats.
  [[nodiscard]] bool fits_floats() const;
  void scale_colours();
  [[nodiscard]] const Vec3& position(std::uint32_t index) const;
  [[nodiscard]] RawMesh::Corner raw(const Corner& corner) const;
  [[nodiscard]] TriangleColour colour_of(const Face& face, const std::array<std::uint32_t, 3>& corners);

  std::string subject_;
  TriangleCount count_;
  std::vector<Vec3> positions_{};
  std::map<std::size_t, Failure> wrong_{};  ///< positions that are none
  std::vector<Corner> corners_{};
  std::vector<Face> faces_{};
};

}  // namespace arcspan::tools
