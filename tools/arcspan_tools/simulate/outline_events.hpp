// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/render/job_outlines.hpp>
#include <arcspan_tools/render/render.hpp>
#include <arcspan_tools/simulate/count_events.hpp>
#include <arcspan_tools/simulate/draw_events.hpp>

#include <vector>

namespace arcspan::tools {

/// What happens while outlines are found, inked and smoothed, by what takes instructions.
struct OutlineEvents {
  // Once for each object: find_sides(), in bands, and OutlineList::add() or CurvedOutlines::find().
  double objects = 0;
  double banded_objects = 0;
  double vertices = 0;
  double wanted_vertices = 0;  ///< transformed one by one, because planes told which are seen
  double forgotten = 0;        ///< entries of the cache that are reset for that
  double planes = 0;           ///< face planes tested
  double triangles = 0;        ///< whose side is found by their corners
  double plain = 0;            ///< triangles that are passed at once
  double differing = 0;        ///< the others
  double listed = 0;           ///< edges
  double tried_curves = 0;     ///< silhouettes, if they may be curved
  double curves = 0;
  // Once for each band.
  double bands = 0;
  double edges = 0;    ///< looked at
  double walks = 0;    ///< edges that have rows in the band
  double rows = 0;     ///< stepped to
  double gaps = 0;     ///< that nothing hides
  double entries = 0;  ///< of the list
  double blended = 0;  ///< pixels
  double ink_bands = 0;
  double ink_edges = 0;
  double near_ink_edges = 0;  ///< that may reach the band
  double ink_walks = 0;
  double ink_rows = 0;
  double ink_end_rows = 0;  ///< beyond the ends of edges
  double crease_walks = 0;
  double crease_rows = 0;
  double ink_tests = 0;    ///< of depths
  double ink_whole = 0;    ///< pixels that are ink
  double ink_parts = 0;    ///< pixels put into the list, again or not
  double ink_entries = 0;  ///< of the list

  /// Those that happened.
  [[nodiscard]] std::vector<CostTerm> terms() const;
};

/// The events of the outlines of a job, whose parts are drawn in `picture`.
[[nodiscard]] OutlineEvents count_outlines(const RenderJob& job, JobOutlines& outlines,
                                           EventPicture& picture);

}  // namespace arcspan::tools
