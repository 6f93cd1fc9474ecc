// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/render/render.hpp>

#include <cstdint>
#include <memory>

namespace arcspan::tools {

/// One picture drawn by several threads: each has a band of the rows for itself, with depth buffer and vertex
/// cache; mesh, transform and illumination are shared, and nobody writes to them. Nothing is locked. Bands
/// have the same height until balance() is called. Shading is arc, the format rgb565 with depth, the
/// highlight Phong's of one light.
class ParallelBands {
 public:
  /// Throws Failure if the job has no light or more than one, or another highlight.
  ParallelBands(const RenderJob& job, std::uint32_t threads);
  ~ParallelBands();
  ParallelBands(const ParallelBands&) = delete;
  ParallelBands& operator=(const ParallelBands&) = delete;

  /// The times of a frame: the fastest of those that were drawn, since waiting for a core is no property of
  /// ours.
  struct FrameTime {
    double wall = 0;     ///< milliseconds from the common beginning to the end of the last band
    double busiest = 0;  ///< milliseconds of processor time of the band that needs most
  };

  /// Clears and draws `repeats` frames one after the other, all threads beginning each together; the times
  /// are of drawing alone.
  [[nodiscard]] FrameTime draw(std::int32_t repeats);
  /// Moves the borders between bands by what the threads took for the last frames, as a program would that
  /// draws many.
  void balance(std::int32_t rounds);
  [[nodiscard]] Image image() const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace arcspan::tools
