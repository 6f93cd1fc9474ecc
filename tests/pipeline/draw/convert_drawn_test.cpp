// SPDX-License-Identifier: MIT
// Drawn pixels in another format: against drawing in that format, against the formats' own conversions, in
// bands and rectangles, and every status.
#include <arcspan/convert_drawn.hpp>
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer_window.hpp>
#include <arcspan/pixel/pixel_format_list.hpp>
#include <arcspan/pixel/sink_part.hpp>
#include <arcspan/shading/gouraud.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/strict_sink.hpp>

#include <vector>

using namespace arcspan;
using namespace arcspan::test;
using hal::Framebuffer;

namespace {

constexpr std::int32_t kWidth = 61;
constexpr std::int32_t kHeight = 40;

using Method = Gouraud<Illumination<1, Highlight::kPhong>>;
// Each format compiles the pipeline: the least of it.
constexpr DrawFeatures kFeatures{.clips = false, .planes = false, .small_triangles = false};

/// A picture with memory of its own.
template <class Format>
struct Picture {
  std::vector<typename Format::Word> memory =
      std::vector<typename Format::Word>(Framebuffer<Format>::words(kWidth, kHeight));
  Framebuffer<Format> frame{memory, kWidth, kHeight};

  explicit Picture(Rgb8 background = {}) { frame.clear(background); }
  Picture(const Picture&) = delete;
};

struct Depths {
  std::vector<std::uint16_t> memory = std::vector<std::uint16_t>(DepthBuffer::words(kWidth, kHeight));
  DepthBuffer buffer{memory, kWidth, kHeight};

  Depths() { buffer.clear(); }
  Depths(const Depths&) = delete;
};

/// Two balls of many colours, one behind the other.
template <class Format>
void draw_balls(Picture<Format>& picture, Depths& depths) {
  Random random(9);
  const TestMesh ball = make_sphere(10, 14, 3000, 0.1, random);
  TestCamera camera;
  camera.width = kWidth;
  camera.height = kHeight;
  camera.focal = 45;
  for (const double x : {-1500.0, 1800.0}) {
    camera.translation = {x, 300, x - 9000};
    const Method::Lighting lighting(make_light<1, Highlight::kPhong>(camera));
    REQUIRE(ok(
        draw_mesh<Method, kFeatures>(ball.view(), camera.transform(), lighting, picture.frame, depths.buffer)
            .status));
  }
}

template <class Format>
bool same_words(const std::vector<typename Format::Word>& a, const std::vector<typename Format::Word>& b) {
  return a == b;
}

/// Pixels drawn in Source and converted, compared with those drawn in Target.
template <class Source, class Target>
void check_as_drawn() {
  Picture<Source> source({200, 0, 0});
  Depths depths;
  draw_balls(source, depths);
  Picture<Target> wanted({17, 99, 180});
  Depths depths_of_wanted;
  draw_balls(wanted, depths_of_wanted);
  Picture<Target> target({17, 99, 180});
  const std::vector<typename Target::Word> background = target.memory;
  REQUIRE(ok(convert_drawn(source.frame, depths.buffer, target.frame)));
  CHECK(same_words<Target>(target.memory, wanted.memory));
  CHECK_FALSE(same_words<Target>(target.memory, background));
}

/// Fills a picture with any pixels, and leaves out some depths.
template <class Format>
void scatter(Picture<Format>& picture, Depths& depths, Random& random) {
  for (std::int32_t y = 0; y < kHeight; ++y) {
    auto cursor = picture.frame.open({y, 0, kWidth});
    for (std::int32_t x = 0; x < kWidth; ++x, cursor.next()) {
      cursor.write(Format::encode({static_cast<std::uint8_t>(random.integer(0, 255)),
                                   static_cast<std::uint8_t>(random.integer(0, 255)),
                                   static_cast<std::uint8_t>(random.integer(0, 255))}));
      const int kind = random.integer(0, 3);
      depths.buffer.row(y)[x] = kind == 0   ? std::uint16_t{0}
                                : kind == 1 ? std::uint16_t{0xFFFE}
                                            : DepthBuffer::kFarthest;
    }
  }
}

template <class Format>
typename Format::Encoded encoded_at(Picture<Format>& picture, std::int32_t x, std::int32_t y) {
  return picture.frame.open({y, x, 1}).read();
}

/// Every pixel is converted by the formats, or left alone.
template <class Source, class Target>
void check_formats() {
  Random random(3);
  Picture<Source> source;
  Depths depths;
  scatter(source, depths, random);
  const Rgb8 background{40, 200, 90};
  Picture<Target> target(background);
  REQUIRE(ok(convert_drawn(source.frame, depths.buffer, target.frame)));
  int wrong = 0;
  for (std::int32_t y = 0; y < kHeight; ++y) {
    for (std::int32_t x = 0; x < kWidth; ++x) {
      const Rgb8 colour = Source::decode(encoded_at(source, x, y));
      const bool drawn = depths.buffer.row(y)[x] != 0xFFFF;
      const typename Target::Encoded wanted = !drawn             ? Target::encode(background)
                                              : Target::kDithers ? Target::encode_dithered(colour, x, y)
                                                                 : Target::encode(colour);
      wrong += encoded_at(target, x, y) == wanted ? 0 : 1;
    }
  }
  CHECK(wrong == 0);
}

template <class Target>
void check_formats_to() {
  check_formats<Rgb565, Target>();
  check_formats<Rgb888, Target>();
  check_formats<Gray4, Target>();
  check_formats<Mono, Dithered<Target>>();
}

template <class Format>
bool is_clear(const std::vector<typename Format::Word>& memory) {
  return memory == std::vector<typename Format::Word>(memory.size());
}

/// A sink that fails at its third run.
struct FailingSink {
  using Format = Gray8;
  int runs = 0;
  std::vector<std::uint8_t> memory = std::vector<std::uint8_t>(kWidth * kHeight);

  [[nodiscard]] Rect bounds() const { return {0, 0, kWidth, kHeight}; }
  [[nodiscard]] Format::Cursor open(const Span& run) { return {memory.data() + run.y * kWidth, run.x}; }
  [[nodiscard]] Status close(const Span&) { return ++runs == 3 ? Status::kTransferFailed : Status::kOk; }
};

}  // namespace

TEST_CASE("pixels drawn with 8 bits per channel become those drawn in the other format") {
  check_as_drawn<Rgb888, Bgr888>();
  check_as_drawn<Rgb888, Xrgb8888>();
  check_as_drawn<Xrgb8888, Rgb888>();
}

TEST_CASE("formats with fewer bits drop or dither them as they do in drawing") {
  check_as_drawn<Rgb888, Rgb565>();
  check_as_drawn<Rgb888, Dithered<Mono>>();
}

TEST_CASE("a dithered picture in 5-6-5 bits keeps its pixels with other bytes") {
  check_as_drawn<Dithered<Rgb565>, Dithered<Rgb565Swapped>>();
}

TEST_CASE("every pixel whose depth is not cleared is converted by the formats, all others stay") {
#define ARCSPAN_CHECK_FORMAT(name, Format) check_formats_to<Format>();
  ARCSPAN_FOR_EACH_PIXEL_FORMAT(ARCSPAN_CHECK_FORMAT)
#undef ARCSPAN_CHECK_FORMAT
}

TEST_CASE("a sink gets a run for every row of neighbouring pixels, and nothing else") {
  Picture<Rgb888> source;
  Depths depths;
  for (const std::int32_t x : {0, 1, 2, 5, kWidth - 1}) depths.buffer.row(7)[x] = 100;
  depths.buffer.row(kHeight - 1)[30] = 0;
  StrictSink sink({0, 0, kWidth, kHeight});
  REQUIRE(ok(convert_drawn(source.frame, depths.buffer, sink)));
  CHECK(sink.faults() == SinkFaults{});
  CHECK(sink.runs() == 4);
  CHECK(sink.drawn() == 6);
  CHECK(sink.cell(2, 7).count == 1);
  CHECK(sink.cell(kWidth - 1, 7).count == 1);
  CHECK(sink.cell(30, kHeight - 1).count == 1);
}

TEST_CASE("a band, a window and a part of a sink are converted where they lie in the picture") {
  Random random(12);
  Picture<Rgb888> whole;
  Depths depths;
  scatter(whole, depths, random);
  Picture<Dithered<Rgb565>> wanted;
  REQUIRE(ok(convert_drawn(whole.frame, depths.buffer, wanted.frame)));

  // In bands of 9 rows, into windows of the same rectangles.
  Picture<Dithered<Rgb565>> target;
  for (std::int32_t top = 0; top < kHeight; top += 9) {
    const std::int32_t rows = std::min(9, kHeight - top);
    const auto at = static_cast<std::size_t>(top * kWidth);
    const auto count = static_cast<std::size_t>(rows * kWidth);
    const Framebuffer<Rgb888> band(std::span(whole.memory).subspan(at, count), kWidth, rows, top);
    const DepthBuffer band_depth(std::span(depths.memory).subspan(at, count), kWidth, rows, top);
    const std::span rows_of_target = std::span(target.memory).subspan(at);
    hal::FramebufferWindow<Dithered<Rgb565>> window(std::as_writable_bytes(rows_of_target),
                                                    {0, top, kWidth, top + rows}, 2 * kWidth);
    REQUIRE(ok(convert_drawn(band, band_depth, window)));
  }
  CHECK(target.memory == wanted.memory);

  // A rectangle only.
  Picture<Dithered<Rgb565>> cut;
  REQUIRE(ok(convert_drawn(SinkPart(whole.frame, {10, 5, 33, 21}), depths.buffer, cut.frame)));
  int wrong = 0;
  for (std::int32_t y = 0; y < kHeight; ++y) {
    for (std::int32_t x = 0; x < kWidth; ++x) {
      const bool inside = x >= 10 && x < 33 && y >= 5 && y < 21;
      wrong += encoded_at(cut, x, y) == (inside ? encoded_at(wanted, x, y) : 0) ? 0 : 1;
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("bounds that do not match are refused, and nothing is written") {
  Random random(1);
  Picture<Rgb888> source;
  Depths depths;
  scatter(source, depths, random);
  std::vector<std::uint16_t> memory(kWidth * kHeight);
  Framebuffer<Rgb565> lower(memory, kWidth, kHeight, 1);
  CHECK(convert_drawn(source.frame, depths.buffer, lower) == Status::kInvalidArgument);
  Framebuffer<Rgb565> narrow(memory, kWidth - 1, kHeight);
  CHECK(convert_drawn(source.frame, depths.buffer, narrow) == Status::kInvalidArgument);
  Framebuffer<Rgb565> low(memory, kWidth, kHeight - 1);
  CHECK(convert_drawn(source.frame, depths.buffer, low) == Status::kInvalidArgument);
  Framebuffer<Rgb565> target(memory, kWidth, kHeight);
  for (const Rect& held : {Rect{1, 0, kWidth, kHeight}, Rect{0, 1, kWidth, kHeight},
                           Rect{0, 0, kWidth - 1, kHeight}, Rect{0, 0, kWidth, kHeight - 1}}) {
    std::vector<std::uint16_t> cleared(DepthBuffer::words(kWidth, kHeight));
    CHECK(convert_drawn(source.frame, DepthBuffer(cleared, held), target) == Status::kDepthMismatch);
  }
  CHECK(is_clear<Rgb565>(memory));
}

TEST_CASE("an argument that is not ready gives its status, and a sink that fails ends converting") {
  Random random(1);
  Picture<Rgb888> source;
  Depths depths;
  scatter(source, depths, random);
  std::vector<std::uint16_t> memory(kWidth * kHeight);
  Framebuffer<Rgb565> target(memory, kWidth, kHeight);
  const std::span few(source.memory.data(), 5);
  const Framebuffer<Rgb888> no_source(few, kWidth, kHeight);
  CHECK(convert_drawn(no_source, depths.buffer, target) == Status::kBufferTooSmall);
  const std::span few_pixels(memory.data(), 5);
  Framebuffer<Rgb565> no_target(few_pixels, kWidth, kHeight);
  CHECK(convert_drawn(source.frame, depths.buffer, no_target) == Status::kBufferTooSmall);
  const std::span few_depths(depths.memory.data(), 5);
  const DepthBuffer no_depth(few_depths, kWidth, kHeight);
  CHECK(convert_drawn(source.frame, no_depth, target) == Status::kBufferTooSmall);
  CHECK(is_clear<Rgb565>(memory));
  FailingSink failing;
  CHECK(convert_drawn(source.frame, depths.buffer, failing) == Status::kTransferFailed);
  CHECK(failing.runs == 3);
  // An empty source needs nothing of the others.
  const Framebuffer<Rgb888> empty({}, 0, 0);
  Framebuffer<Rgb565> elsewhere(memory, kWidth, 3, 900);
  CHECK(convert_drawn(empty, depths.buffer, elsewhere) == Status::kOk);
}
