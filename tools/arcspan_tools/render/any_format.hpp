// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/outline/outline_list.hpp>
#include <arcspan/span/depth.hpp>

#include <arcspan_tools/render/pixel_choice.hpp>
#include <arcspan_tools/render/span_counter.hpp>
#include <arcspan_tools/render/surface_operation.hpp>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>

namespace arcspan::tools {

struct OutlineLook;

/// The time and the memory of inking and smoothing, of all bands and repeats together.
struct SmoothCost {
  double milliseconds = 0;    ///< of processor time
  std::size_t gap_bytes = 0;  ///< of the band that needs most
};

/// Pixels of a format that is known at run time only, in a hal::Framebuffer of that format.
class PixelStore {
 public:
  virtual ~PixelStore() = default;
  virtual void write(std::int32_t x, std::int32_t y, PackedRgb colour) = 0;
  virtual void write(std::int32_t x, std::int32_t y, const SurfacePixel& surface) = 0;
  [[nodiscard]] virtual Rgb8 pixel(std::int32_t x, std::int32_t y) const = 0;
  /// The colours of row y, which must be inside bounds().
  virtual void read_row(std::int32_t y, std::span<Rgb8> row) const = 0;
  virtual void move_to(std::int32_t first_row) = 0;
  virtual void clear(Rgb8 colour) = 0;
  /// finish_outlines() (job_outlines.hpp).
  virtual void finish_outlines(const OutlineList& outlines, const OutlineLook& look, const DepthBuffer& depth,
                               SmoothCost& cost) = 0;
  [[nodiscard]] virtual Rect bounds() const = 0;
  [[nodiscard]] virtual std::size_t bytes() const = 0;
};

/// A store of the format that was chosen; throws Failure if there is none of that name.
[[nodiscard]] std::unique_ptr<PixelStore> make_pixel_store(const PixelChoice& pixels, std::int32_t width,
                                                           std::int32_t rows);

/// Keeps nothing, and counts what is written.
class NoPixels final : public PixelStore {
 public:
  explicit NoPixels(const Rect& bounds) : bounds_(bounds) {}

  void write(std::int32_t, std::int32_t, PackedRgb) override { ++written_; }
  void write(std::int32_t, std::int32_t, const SurfacePixel&) override { ++written_; }
  [[nodiscard]] std::uint64_t written() const { return written_; }
  [[nodiscard]] Rgb8 pixel(std::int32_t, std::int32_t) const override { return {}; }
  void read_row(std::int32_t, std::span<Rgb8>) const override {}
  void move_to(std::int32_t first_row) override {
    bounds_ = {bounds_.left, first_row, bounds_.right, first_row + bounds_.height()};
  }
  void clear(Rgb8) override {}
  void finish_outlines(const OutlineList&, const OutlineLook&, const DepthBuffer&, SmoothCost&) override {}
  [[nodiscard]] Rect bounds() const override { return bounds_; }
  [[nodiscard]] std::size_t bytes() const override { return 0; }

 private:
  Rect bounds_;
  std::uint64_t written_ = 0;
};

/// The pipeline's view of such a store. One instantiation of a shading method with it serves every format. It
/// costs a virtual call per pixel; a firmware names its format instead.
struct AnyFormat {
  using Encoded = PackedRgb;
  using Word = PixelStore;
  static constexpr unsigned kBitsPerPixel = 32;
  static constexpr bool kDithers = false;

  class Cursor {
   public:
    Cursor(PixelStore* store, std::int32_t x, std::int32_t y = 0) : store_(store), x_(x), y_(y) {}
    void write(Encoded colour) { store_->write(x_, y_, colour); }
    [[nodiscard]] Encoded read() const { return encode(store_->pixel(x_, y_)); }
    void next() { ++x_; }

   private:
    PixelStore* store_;
    std::int32_t x_;
    std::int32_t y_;
  };

  [[nodiscard]] static std::size_t words_per_row(std::int32_t) { return 1; }
  [[nodiscard]] static Encoded encode(PackedRgb c) { return c; }
  [[nodiscard]] static Encoded encode(Rgb8 c) { return PackedRgb::of(c.r * 4u, c.g * 4u, c.b * 4u); }
  [[nodiscard]] static Encoded encode_dithered(Rgb8 c, std::int32_t, std::int32_t) { return encode(c); }
  [[nodiscard]] static Rgb8 decode(Encoded colour) { return colour.rgb8(); }
};

/// The sink over such a store; counts the spans and their pixels. It is always drawn with a depth buffer:
/// without a depth test (painter's order) the depths under every span are reset before it is drawn, so that
/// all its pixels pass, and no second instantiation is needed.
class AnySink : public SpanCounter {
 public:
  using Format = AnyFormat;

  /// `painted_over` is the depth buffer if there is no depth test, otherwise null.
  explicit AnySink(PixelStore& store, const DepthBuffer* painted_over = nullptr)
      : store_(&store), painted_over_(painted_over) {}
  [[nodiscard]] Rect bounds() const { return store_->bounds(); }
  [[nodiscard]] AnyFormat::Cursor open(const Span& run) {
    if (painted_over_ != nullptr) {
      std::fill_n(painted_over_->row(run.y) + run.x, run.count, DepthBuffer::kFarthest);
    }
    return {store_, run.x, run.y};
  }

 private:
  PixelStore* store_;
  const DepthBuffer* painted_over_;
};

static_assert(PixelSink<AnySink>);

}  // namespace arcspan::tools
