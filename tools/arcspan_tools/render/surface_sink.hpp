// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/span/depth.hpp>

#include <arcspan_tools/render/any_format.hpp>
#include <arcspan_tools/render/span_counter.hpp>
#include <arcspan_tools/render/surface_operation.hpp>

#include <algorithm>
#include <cstdint>

namespace arcspan::tools {

/// What the cursors of a SurfaceSink write to.
struct SurfaceMemory {
  PixelStore* store;
  const DepthBuffer* depth;
};

/// The pipeline's view of pixels that are operated on when they are written. Nothing is read through it.
struct SurfaceFormat {
  using Encoded = SurfacePixel;
  using Word = const SurfaceMemory;
  static constexpr unsigned kBitsPerPixel = 32;
  static constexpr bool kDithers = false;

  class Cursor {
   public:
    Cursor(Word* memory, std::int32_t x, std::int32_t y = 0) : memory_(memory), x_(x), y_(y) {}
    /// Writes the pixel's depth too, unless it is blended.
    void write(const Encoded& surface) {
      if (!is_blended(surface.operation->transparency)) memory_->depth->row(y_)[x_] = surface.depth;
      memory_->store->write(x_, y_, surface);
    }
    [[nodiscard]] Encoded read() const { return {}; }
    void next() { ++x_; }

   private:
    Word* memory_;
    std::int32_t x_;
    std::int32_t y_;
  };

  [[nodiscard]] static std::size_t words_per_row(std::int32_t) { return 1; }
  template <class C>
  [[nodiscard]] static Encoded encode(const SurfaceOperation::Result<C>& colour) {
    return colour.pixel();
  }
  [[nodiscard]] static Encoded encode(Rgb8) { return {}; }
  [[nodiscard]] static Encoded encode_dithered(Rgb8, std::int32_t, std::int32_t) { return {}; }
  [[nodiscard]] static Rgb8 decode(const Encoded& surface) { return surface.colour.rgb8(); }
};

/// The sink of methods with SurfaceOperation; counts the spans and their pixels. It writes depths itself, so
/// the depth target is a ReadOnlyDepth of the same buffer, whether surfaces are blended or not.
class SurfaceSink : public SpanCounter {
 public:
  using Format = SurfaceFormat;

  /// `paints_over`: draw without a depth test, by resetting the depths under every span.
  SurfaceSink(PixelStore& store, const DepthBuffer& depth, bool paints_over)
      : memory_{&store, &depth}, paints_over_(paints_over) {}
  [[nodiscard]] Rect bounds() const { return memory_.store->bounds(); }
  [[nodiscard]] SurfaceFormat::Cursor open(const Span& run) {
    if (paints_over_) std::fill_n(memory_.depth->row(run.y) + run.x, run.count, DepthBuffer::kFarthest);
    return {&memory_, run.x, run.y};
  }

 private:
  SurfaceMemory memory_;
  bool paints_over_;
};

static_assert(PixelSink<SurfaceSink>);

}  // namespace arcspan::tools
