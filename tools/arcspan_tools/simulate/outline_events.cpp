// SPDX-License-Identifier: MIT
#include <arcspan/draw/triangle_sides.hpp>
#include <arcspan/outline/edge_finder.hpp>
#include <arcspan/outline/exchange.hpp>
#include <arcspan/outline/ink_walk.hpp>
#include <arcspan/shading/unlit.hpp>

#include <arcspan_tools/simulate/outline_events.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <cstdlib>
#include <span>
#include <utility>

namespace arcspan::tools {
namespace {

using Sink = hal::Framebuffer<Rgb565>;
using Gap = OutlineGap<Rgb565>;

/// The list of gaps that smoothing blends, which counts how often a gap is put into it, and how often the
/// depth of a pixel is between those of the ends of the edge.
struct CountedGaps : arcspan::detail::GapList<Sink> {
  using GapList::GapList;

  bool may_be_own(std::uint16_t stored) const {
    const bool own = GapList::may_be_own(stored);
    if (!own && !is_known_) count(stored);
    is_known_ = false;
    return own;
  }
  Outer outer_of(std::uint16_t stored, std::uint32_t pixel) const {
    const Outer outer = GapList::outer_of(stored, pixel);
    if (GapList::may_be_own(stored)) count(outer.depth);
    is_known_ = true;
    return outer;
  }
  void put(std::uint32_t pixel, const arcspan::detail::GapOutline& outline, Outer outer, std::uint16_t* at,
           const std::uint16_t* inner) {
    ++puts;
    GapList::put(pixel, outline, outer, at, inner);
  }

  const OutlineEdge* edge = nullptr;
  double puts = 0;
  mutable double between = 0;

 private:
  void count(std::uint16_t depth) const {
    const auto [nearest, farthest] = std::minmax(edge->from.z, edge->to.z);
    if (depth >= nearest && depth < farthest) ++between;
  }

  mutable bool is_known_ = false;  ///< OutlineSmoother::put() asks for a pixel once more
};

/// The pixels that are inked, which counts what is asked of it.
struct CountedInk : arcspan::detail::InkPixels<Sink> {
  using InkPixels::InkPixels;

  std::uint16_t depth_of(const arcspan::detail::OutlinePixel& at) const {
    ++tests;
    return InkPixels::depth_of(at);
  }
  void put(const arcspan::detail::OutlinePixel& at, std::uint32_t share) {
    ++(share == kWhole ? whole : parts);
    InkPixels::put(at, share);
  }

  mutable double tests = 0;
  double whole = 0;
  double parts = 0;
};

bool is_beside(std::int32_t a, std::int32_t b, std::int32_t least, std::int32_t most) {
  return (a < 16 * least && b < 16 * least) || (a > 16 * most && b > 16 * most);
}

/// An edge as it is walked in a band, by rows or by columns.
struct WalkedEdge {
  bool is_near = false;  ///< it may reach the band from the side
  double all_rows = 0;
  double end_rows = 0;  ///< of these, beyond the ends of the edge
};

/// `ink_width` is the width of an inked outline; 0 for an inked crease, and for smoothing. What is near is as
/// in OutlineInker.
WalkedEdge walked(const OutlineEdge& edge, const Rect& rect, std::int32_t ink_width) {
  constexpr std::int32_t kReach = 2 * OutlineInk::kWidest;
  const bool steep = std::abs(edge.to.y - edge.from.y) >= std::abs(edge.to.x - edge.from.x);
  if (steep ? is_beside(edge.from.x, edge.to.x, rect.left - kReach, rect.right + kReach)
            : is_beside(edge.from.y, edge.to.y, rect.top - kReach, rect.bottom + kReach))
    return {};
  RasterPosition top = steep ? edge.from : arcspan::detail::exchanged(edge.from);
  RasterPosition bottom = steep ? edge.to : arcspan::detail::exchanged(edge.to);
  if (top.y > bottom.y) std::swap(top, bottom);
  const RowRange band = steep ? RowRange{rect.top, rect.bottom} : RowRange{rect.left, rect.right};
  WalkedEdge found{true, 0, 0};
  for (arcspan::detail::InkWalk walk(top, bottom, band, !steep, 0, ink_width); !walk.done(); walk.next()) {
    ++found.all_rows;
    if (walk.row() < first_row_at(top.y) || walk.row() >= first_row_at(bottom.y)) ++found.end_rows;
  }
  return found;
}

/// Counts what is done in a band, and does it.
class BandCounter {
 public:
  BandCounter(Sink& sink, OutlineEvents& events) : sink_(sink), events_(events), gaps_(kMostGaps) {}

  /// As the stores of JobOutlines::finish_after() have it.
  void finish_outlines(const OutlineList& outlines, const OutlineLook& look, const DepthBuffer& depth,
                       SmoothCost&) {
    if (outlines.edges().empty()) return;
    const arcspan::detail::Scissor scissor(outlines.viewport(), sink_.bounds());
    if (scissor.rect().empty()) return;
    const Rect rect = arcspan::detail::relative_to(scissor.origin(), scissor.rect());
    if (look.ink) ink(outlines.edges(), *look.ink, scissor, rect, depth);
    if (look.smooth) smooth(outlines, scissor, rect, depth);
  }

 private:
  static constexpr std::size_t kMostGaps = 65535;

  void smooth(const OutlineList& outlines, const arcspan::detail::Scissor& scissor, const Rect& rect,
              const DepthBuffer& depth) {
    for (Gap& gap : gaps_) gap.x = kUntouched;
    CountedGaps list(sink_, depth, gaps_);
    arcspan::detail::OutlineSmoother<CountedGaps> smoother(scissor, depth, list);
    for (const OutlineEdge& edge : outlines.edges()) {
      list.edge = &edge;
      smoother.smooth(edge);
    }
    list.apply();
    ++events_.bands;
    events_.edges += static_cast<double>(outlines.edges().size());
    for (const OutlineEdge& edge : outlines.edges()) {
      // Smoothing tests both directions, without a reach.
      if (is_beside(edge.from.x, edge.to.x, rect.left, rect.right) ||
          is_beside(edge.from.y, edge.to.y, rect.top, rect.bottom))
        continue;
      const WalkedEdge found = walked(edge, rect, 0);
      if (found.all_rows > 0) ++events_.walks;
      events_.rows += found.all_rows;
    }
    events_.gaps += list.puts;
    events_.between += list.between;
    for (const Gap& gap : gaps_) {
      if (gap.x == kUntouched) break;
      ++events_.entries;
      const auto outline = arcspan::detail::GapOutline::of(gap.outline);
      events_.blended +=
          static_cast<int>(outline.of_outer() != 0) + static_cast<int>(outline.of_inner() != 0);
    }
  }

  void ink(std::span<const OutlineEdge> edges, const OutlineInk& ink, const arcspan::detail::Scissor& scissor,
           const Rect& rect, const DepthBuffer& depth) {
    for (Gap& gap : gaps_) gap.x = kUntouched;
    CountedInk pixels(sink_, depth, ink.colour, gaps_);
    arcspan::detail::OutlineInker<CountedInk> inker(scissor, depth, ink.width, pixels);
    ++events_.ink_bands;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      ++events_.ink_edges;
      if (!arcspan::detail::is_crease(edges, i)) {
        inker.ink_outline(edges[i]);
        count_ink(walked(edges[i], rect, ink.width), events_.ink_walks, events_.ink_rows);
        continue;
      }
      if (ink.creases) {
        inker.ink_crease(edges[i]);
        count_ink(walked(edges[i], rect, 0), events_.crease_walks, events_.crease_rows);
      }
      ++i;
    }
    pixels.apply();
    events_.ink_tests += pixels.tests;
    events_.ink_whole += pixels.whole;
    events_.ink_parts += pixels.parts;
    events_.ink_entries += static_cast<double>(
        std::find_if(gaps_.begin(), gaps_.end(), [](const Gap& gap) { return gap.x == kUntouched; }) -
        gaps_.begin());
  }

  void count_ink(const WalkedEdge& edge, double& walks, double& rows) {
    if (edge.is_near) ++events_.near_ink_edges;
    if (edge.all_rows > 0) ++walks;
    rows += edge.all_rows - edge.end_rows;
    events_.ink_end_rows += edge.end_rows;
  }

  static constexpr std::int16_t kUntouched = -1;

  Sink& sink_;
  OutlineEvents& events_;
  std::vector<Gap> gaps_;
};

/// Fills `sides`. In bands find_sides() takes them from the rows that drawing keeps; a whole picture gets
/// them from drawing it, at no cost that is counted here.
void find_counted_sides(const RenderPart& part, const ClipTransform& transform, bool in_bands,
                        std::vector<TriangleSide>& sides, OutlineEvents& events) {
  const Unlit::Lighting lighting = Unlit::lighting({});
  sides.resize(part.mesh.triangle_count());
  if (!ok(find_sides<Unlit>(part.mesh, transform, lighting, NoCache{}, sides, {part.two_sided})))
    throw Failure("simulate", "the sides of triangles cannot be found");
  ++events.objects;
  if (!in_bands) return;
  ++events.banded_objects;
  events.triangles += static_cast<double>(sides.size());
}

/// Counts which way detail::EdgeFinder takes for each triangle of a part; the tests are its own.
void count_neighbours(const MeshNeighbours& neighbours, const std::vector<TriangleSide>& sides,
                      OutlineEvents& events) {
  const std::uint8_t* at = neighbours.bytes();
  for (std::size_t i = 0; i < neighbours.triangle_count(); ++i) {
    const unsigned kinds = *at++;
    const std::uint8_t* const first = at;
    if (const unsigned distances = arcspan::detail::short_distances(kinds); distances != 1 && distances != 2)
      ++events.uncommon;
    bool differs = arcspan::detail::is_seen(sides[i]) && !arcspan::detail::has_ordinary_edges(kinds);
    for (unsigned edge = 0; edge < 3; ++edge)
      if (arcspan::detail::has_distance(arcspan::detail::edge_kind(kinds, edge)))
        differs |= sides[i + arcspan::detail::read_distance(at)] != sides[i];
    ++events.scanned;
    events.distances += static_cast<double>(at - first);
    if (differs) ++events.differing;
  }
}

/// Takes the edges of a part as OutlineList::add() does.
struct EdgeCounter {
  double count = 0;
  double silhouettes = 0;

  void put(std::size_t, std::size_t, bool is_silhouette) {
    ++count;
    if (is_silhouette) ++silhouettes;
  }
};

}  // namespace

OutlineEvents count_outlines(const RenderJob& job, JobOutlines& outlines, EventPicture& picture) {
  OutlineEvents events;
  std::vector<TriangleSide> sides;
  for (std::size_t i = 0; i < job.parts.size(); ++i) {
    const RenderPart& part = job.parts[i];
    find_counted_sides(part, job.transform, job.band_rows < job.transform.viewport().height, sides, events);
    count_neighbours(part.neighbours, sides, events);
    EdgeCounter edges;
    arcspan::detail::EdgeFinder<EdgeCounter>(part.mesh, sides, edges).find(part.neighbours.bytes());
    events.listed += edges.count;
    if (job.outlines.curved) events.tried_curves += edges.silhouettes;
    events.curves += static_cast<double>(outlines.curves(i).triangle_count());
  }
  picture.for_each_band([&](Sink& sink, const DepthBuffer& depth) {
    BandCounter counter(sink, events);
    for (std::size_t i = 0; i < job.parts.size(); ++i) outlines.finish_after(i, counter, depth);
  });
  return events;
}

std::vector<CostTerm> OutlineEvents::terms() const {
  std::vector<CostTerm> terms;
  for (const CostTerm& term : {CostTerm{"object", objects},
                               {"banded object", banded_objects},
                               {"triangle", triangles},
                               {"scanned triangle", scanned},
                               {"uncommon triangle", uncommon},
                               {"neighbour byte", distances},
                               {"differing triangle", differing},
                               {"listed edge", listed},
                               {"tried curve", tried_curves},
                               {"curve", curves},
                               {"band", bands},
                               {"edge", edges},
                               {"walk", walks},
                               {"row", rows},
                               {"compared depth", between},
                               {"gap", gaps},
                               {"entry", entries},
                               {"blended pixel", blended},
                               {"ink band", ink_bands},
                               {"ink edge", ink_edges},
                               {"near ink edge", near_ink_edges},
                               {"ink end row", ink_end_rows},
                               {"ink walk", ink_walks},
                               {"ink row", ink_rows},
                               {"crease walk", crease_walks},
                               {"crease row", crease_rows},
                               {"ink test", ink_tests},
                               {"ink pixel", ink_whole},
                               {"ink part", ink_parts},
                               {"ink entry", ink_entries}}) {
    if (term.amount != 0) terms.push_back(term);
  }
  return terms;
}

}  // namespace arcspan::tools
