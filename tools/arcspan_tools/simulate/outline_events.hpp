// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/render/job_outlines.hpp>
#include <arcspan_tools/render/render.hpp>
#include <arcspan_tools/simulate/count_events.hpp>
#include <arcspan_tools/simulate/draw_events.hpp>

#include <vector>

namespace arcspan::tools {

/// How often each step of finding, inking and smoothing outlines is done, for an estimate of instructions.
struct OutlineEvents {
  // Once for each object: find_sides(), if the picture is drawn in bands, then OutlineList::add() or
  // CurvedOutlines::add().
  double objects = 0;
  double banded_objects = 0;
  double triangles = 0;     ///< whose side is that of their rows, which drawing keeps
  double scanned = 0;       ///< triangles whose neighbours are compared
  double uncommon = 0;      ///< of these: without one or two distances of a byte, or with marks
  double distances = 0;     ///< bytes of the numbers of these neighbours
  double differing = 0;     ///< triangles whose edges are looked at one by one
  double listed = 0;        ///< edges
  double tried_curves = 0;  ///< silhouettes, if they may be curved
  double curves = 0;
  // Once for each band. Lists are those of gaps and of ink.
  double bands = 0;
  double edges = 0;    ///< of the outlines
  double walks = 0;    ///< edges that have rows in the band
  double rows = 0;     ///< of these walks
  double between = 0;  ///< depths between those of an edge's ends, which are compared with that of a row
  double gaps = 0;     ///< put into the list, which may refuse them
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
  double ink_tests = 0;    ///< of pixels, whether ink may cover them
  double ink_whole = 0;    ///< pixels that are ink
  double ink_parts = 0;    ///< pixels that ink covers in part, each time that they are put into the list
  double ink_entries = 0;  ///< of the list

  /// Those that happened.
  [[nodiscard]] std::vector<CostTerm> terms() const;
};

/// The events of the outlines of a job, whose parts are drawn in `picture`.
[[nodiscard]] OutlineEvents count_outlines(const RenderJob& job, JobOutlines& outlines,
                                           EventPicture& picture);

}  // namespace arcspan::tools
