// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/outline/outline_list.hpp>
#include <arcspan/smooth_outlines.hpp>
#include <arcspan/span/depth.hpp>

#include <arcspan_tools/render/render.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/processor_time.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace arcspan::tools {

/// Whether the pipeline smooths outlines in pixels of this format.
[[nodiscard]] bool can_smooth(const PixelChoice& pixels);

/// The outlines of a job whose parts have neighbours, found once for all bands. Blended parts are smoothed
/// each by itself after it is drawn, the others together before the first of them.
class JobOutlines {
 public:
  /// Finds them, unless the job has none. The job must outlive the object.
  explicit JobOutlines(const RenderJob& job);

  [[nodiscard]] bool empty() const { return groups_.empty(); }
  /// Rows that a band has more than those that are shown, above and below together.
  [[nodiscard]] std::int32_t margin() const { return empty() ? 0 : 2; }
  /// The first row to draw of a band that shows rows from `first` on.
  [[nodiscard]] std::int32_t first_row(std::int32_t first) const {
    return empty() || first == 0 ? first : first - 1;
  }

  /// Smooths what is complete after part `part` of the job is drawn. `store` has bounds() and
  /// smooth(OutlineList, DepthBuffer), which is smooth_frame().
  template <class Store>
  void smooth_after(std::size_t part, Store& store, const DepthBuffer& depth, RenderStats& stats) {
    for (const Group& group : groups_) {
      if (group.last_part != part) continue;
      const double start = processor_milliseconds();
      gap_bytes_ = std::max(gap_bytes_, store.smooth(group.outlines, depth));
      stats.smooth_milliseconds += processor_milliseconds() - start;
    }
  }

  /// Adds the time of finding the outlines and the sizes to the figures of a picture of so many draws.
  void finish(std::int32_t repeats, RenderStats& stats) const;

 private:
  /// Parts that are smoothed together.
  struct Group {
    explicit Group(std::size_t edges) : memory(edges), outlines(memory) {}

    std::vector<OutlineEdge> memory;
    OutlineList outlines;
    std::size_t last_part = 0;
  };

  void add(const RenderJob& job, std::size_t part, Group& group);

  std::vector<Group> groups_;
  std::vector<TriangleSide> sides_;  ///< of one part after another
  double find_milliseconds_ = 0;
  std::size_t gap_bytes_ = 0;  ///< of the band that needs most
};

/// Smooths outlines in a framebuffer, unless its format has too few levels. Returns the bytes of the gaps
/// that were needed.
template <class Frame>
std::size_t smooth_frame(const OutlineList& outlines, Frame& frame, const DepthBuffer& depth) {
  using Gap = OutlineGap<typename Frame::Format>;
  if constexpr (!arcspan::detail::kCanBlend<typename Frame::Format>) return 0;
  constexpr std::int16_t kUntouched = std::numeric_limits<std::int16_t>::min();
  const Rect bounds = frame.bounds();
  const auto pixels = static_cast<std::size_t>(bounds.width()) * static_cast<std::size_t>(bounds.height());
  std::vector<Gap> gaps(std::min<std::size_t>(4 * pixels, std::numeric_limits<std::uint16_t>::max()));
  for (Gap& gap : gaps) gap.x = kUntouched;
  const Status status = smooth_outlines(outlines, frame, depth, std::span<Gap>(gaps));
  // With more gaps than the pipeline numbers they are blended in several goes.
  if (!ok(status) && status != Status::kBufferTooSmall) throw Failure("outlines", to_string(status));
  const auto used =
      std::count_if(gaps.begin(), gaps.end(), [](const Gap& gap) { return gap.x != kUntouched; });
  return static_cast<std::size_t>(used) * sizeof(Gap);
}

}  // namespace arcspan::tools
