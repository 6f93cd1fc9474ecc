// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/ink_outlines.hpp>
#include <arcspan/outline/curved_outlines.hpp>
#include <arcspan/outline/outline_list.hpp>
#include <arcspan/smooth_outlines.hpp>
#include <arcspan/span/depth.hpp>

#include <arcspan_tools/render/any_format.hpp>
#include <arcspan_tools/render/render.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/processor_time.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace arcspan::tools {

/// Whether the pipeline smooths outlines in pixels of this format.
[[nodiscard]] bool can_smooth(const PixelChoice& pixels);

/// Inks and smooths outlines in a framebuffer, as far as its format has enough levels, and adds what that
/// takes to `cost`.
template <class Frame>
void finish_outlines(const OutlineList& outlines, const OutlineLook& look, Frame& frame,
                     const DepthBuffer& depth, SmoothCost& cost) {
  using Gap = OutlineGap<typename Frame::Format>;
  constexpr bool kSmooths = arcspan::detail::kCanBlend<typename Frame::Format>;
  constexpr std::int16_t kUntouched = std::numeric_limits<std::int16_t>::min();
  const Rect bounds = frame.bounds();
  const auto pixels = static_cast<std::size_t>(bounds.width()) * static_cast<std::size_t>(bounds.height());
  std::vector<Gap> gaps(std::min<std::size_t>(4 * pixels, std::numeric_limits<std::uint16_t>::max()));
  for (Gap& gap : gaps) gap.x = kUntouched;
  const double start = processor_milliseconds();
  Status status = Status::kOk;
  // With more gaps than the pipeline numbers they are blended in several goes.
  const auto done = [&status] { return ok(status) || status == Status::kBufferTooSmall; };
  if (look.ink) status = ink_outlines(outlines, *look.ink, frame, depth, std::span<Gap>(gaps));
  if (done() && kSmooths && look.smooth)
    status = smooth_outlines(outlines, frame, depth, std::span<Gap>(gaps));
  cost.milliseconds += processor_milliseconds() - start;
  if (!done()) throw Failure("outlines", to_string(status));
  const auto used =
      std::count_if(gaps.begin(), gaps.end(), [](const Gap& gap) { return gap.x != kUntouched; });
  cost.gap_bytes = std::max(cost.gap_bytes, static_cast<std::size_t>(used) * sizeof(Gap));
}

/// The outlines of a job whose parts have neighbours, found once for all bands. Those of blended parts are
/// finished each by itself after it is drawn, the others together before the first of them.
class JobOutlines {
 public:
  /// Finds them, unless the job has none. The job must outlive the object.
  explicit JobOutlines(const RenderJob& job);

  [[nodiscard]] bool empty() const { return groups_.empty(); }
  /// Rows that a band has more than those that are shown, above as well as below.
  [[nodiscard]] std::int32_t margin() const {
    if (empty()) return 0;
    return (look_.smooth ? 1 : 0) + (look_.ink && look_.ink->creases ? 1 : 0);
  }
  /// The first row to draw of a band that shows rows from `first` on.
  [[nodiscard]] std::int32_t first_row(std::int32_t first) const { return std::max(first - margin(), 0); }

  /// Inks and smooths what is complete after part `part` of the job is drawn. `store` has finish_outlines().
  template <class Store>
  void finish_after(std::size_t part, Store& store, const DepthBuffer& depth) {
    for (const OutlinedParts& group : groups_) {
      if (group.last_part == part) store.finish_outlines(group.outlines, look_, depth, cost_);
    }
  }

  /// The curves over the outlines of a part, to be drawn with it; empty unless they are wanted.
  [[nodiscard]] MeshView curves(std::size_t part) const {
    return part < curves_.size() ? curves_[part].found.mesh() : MeshView{};
  }

  /// The vertices of the largest of them.
  [[nodiscard]] std::size_t most_curve_vertices() const {
    std::size_t most = 0;
    for (const PartCurves& part : curves_) most = std::max(most, part.found.mesh().vertex_count());
    return most;
  }

  /// Adds the figures of a picture that was drawn so many times.
  void finish(std::int32_t repeats, RenderStats& stats) const;

 private:
  /// Parts whose outlines are finished together.
  struct OutlinedParts {
    explicit OutlinedParts(std::size_t edges) : memory(edges), outlines(memory) {}

    std::vector<OutlineEdge> memory;
    OutlineList outlines;
    std::size_t last_part = 0;
  };

  /// The curves of a part.
  struct PartCurves {
    static constexpr std::size_t kMost = MeshView::kMaxVertices / 3;

    std::unique_ptr<CurveMemory<kMost>> memory = std::make_unique<CurveMemory<kMost>>();
    CurvedOutlines found{*memory};
  };

  void add(const RenderJob& job, std::size_t part, OutlinedParts& group);

  OutlineLook look_;
  std::vector<OutlinedParts> groups_;
  std::vector<PartCurves> curves_;   ///< of each part, or none
  std::vector<TriangleSide> sides_;  ///< of one part after another
  double find_milliseconds_ = 0;
  SmoothCost cost_;
};

}  // namespace arcspan::tools
