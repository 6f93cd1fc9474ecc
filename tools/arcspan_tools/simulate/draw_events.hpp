// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace arcspan::tools {

/// An event of drawing, such as a row or a transformed vertex: how often it happens.
struct CostTerm {
  std::string name;  ///< the key of its weight in docs/estimates.json
  double amount = 0;
};

/// What happens while meshes are drawn, by what takes instructions: each event runs through the same code
/// every time, or nearly so.
struct DrawEvents {
  /// Triangles of one loop over pixels.
  struct Path {
    double triangles = 0;  ///< but for dark ones
    double spans = 0;      ///< rows with pixels
    double pixels = 0;     ///< hidden ones included
    double written = 0;
    double segments = 0;  ///< of Segment
  };
  /// The paths of a method are numbered as its Prepared::path; others have the first alone.
  static constexpr std::size_t kPaths = 6;

  double calls = 0;
  double vertices = 0;         ///< transformed, all of a mesh
  double wanted_vertices = 0;  ///< transformed one by one, because planes told which are seen
  double forgotten = 0;        ///< entries of the cache that are reset for that
  double shaded_vertices = 0;
  double faces = 0;           ///< shaded face normals
  double planes = 0;          ///< face planes tested
  double row_triangles = 0;   ///< whose rows are found, for a picture in bands
  double row_fronts = 0;      ///< those of them that are not culled
  double row_entries = 0;     ///< rows of triangles compared with a band
  double batches = 0;         ///< rows of batches compared with a band
  double triangles = 0;       ///< whose area is tested
  double facing = 0;          ///< the same, but their planes say that they may face the camera
  double fronts = 0;          ///< of `triangles` not culled, whichever side they show
  double facing_fronts = 0;   ///< the same of `facing`
  double clipped = 0;         ///< across a clip plane
  double clip_steps = 0;      ///< corners compared with a plane
  double clip_cuts = 0;       ///< new corners on a plane
  double clip_corners = 0;    ///< of what clipping leaves of these
  double in_view = 0;         ///< fronts within the band
  double backs = 0;           ///< those of them that show their back
  double small_rows = 0;      ///< of small triangles, with or without pixels
  double small_empty = 0;     ///< small triangles without pixels, but with rows
  double small_rowless = 0;   ///< small triangles between the centres of two rows
  double small_halves = 0;    ///< small triangles with rows above and below their middle vertex
  double small_dark = 0;      ///< small triangles with pixels that no light reaches
  double small_levelled = 0;  ///< small triangles with pixels whose texture has several levels
  double refused = 0;         ///< small triangles that have to be drawn by rows
  double rows = 0;            ///< stepped to, of other triangles
  double halves = 0;          ///< their parts above and below the middle vertex
  double edges = 0;           ///< edges along which their planes are stepped
  double dark = 0;            ///< other triangles that no light reaches
  double levelled = 0;        ///< other triangles whose texture has several levels
  double perspective_edges = 0;
  double perspective_triangles = 0;
  double perspective_spans = 0;
  double pieces = 0;      ///< of rows that are linear in a texture in perspective
  double new_levels = 0;  ///< pieces that change the mip level
  double masked = 0;      ///< pixels in front that are left out, because their texels are transparent
  double shiny = 0;       ///< pixels written with a highlight
  double tinted = 0;      ///< pixels of Arc within the reach of a highlight that is coloured or black
  std::array<Path, kPaths> small{};
  std::array<Path, kPaths> large{};
  std::array<Path, kPaths> perspective{};  ///< the pixels of large triangles in perspective, and nothing else

  /// Those that happened.
  [[nodiscard]] std::vector<CostTerm> terms() const;
};

}  // namespace arcspan::tools
