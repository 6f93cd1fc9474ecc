// SPDX-License-Identifier: MIT
// Bands, rectangles and scissors have the pixels of the picture drawn whole, in every pixel format.
#include <arcspan/hal/framebuffer_window.hpp>
#include <arcspan/overlay/bitmap.hpp>
#include <arcspan/overlay/caption.hpp>
#include <arcspan/overlay/line.hpp>
#include <arcspan/overlay/needle.hpp>
#include <arcspan/pixel/pixel_format_list.hpp>
#include <arcspan/pixel/sink_part.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/overlay/overlay_support.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <array>
#include <cstring>

using namespace arcspan;
using namespace arcspan::overlay;
using namespace arcspan::test;

namespace {

constexpr std::int32_t kWidth = 48;
constexpr std::int32_t kHeight = 40;

/// Draws some of everything, in colours and at places that `seed` gives.
template <class Sink>
void draw_all(Sink& sink, std::uint64_t seed) {
  static constexpr std::array<std::uint16_t, 12> kTexels = {0xF00F, 0x0F08, 0x00F0, 0xFFF3, 0x123F, 0x4560,
                                                            0x789A, 0xABCF, 0xDEF1, 0x0008, 0xF0F0, 0xFF0F};
  static constexpr auto kBitmap = Bitmap<DirectTexels<Alpha4Colour>>::of(kTexels, 4, 3);
  Random random(seed);
  const auto colour = [&] {
    return Rgb8{static_cast<std::uint8_t>(random.bits()), static_cast<std::uint8_t>(random.bits()),
                static_cast<std::uint8_t>(random.bits())};
  };
  const auto point = [&] {
    const std::int32_t x = random.integer(-20, kWidth + 5);
    return Point{x, random.integer(-15, kHeight + 5)};
  };
  const auto rect = [&] {
    const Point a = point();
    const std::int32_t right = a.x + random.integer(0, 50);
    return Rect{a.x, a.y, right, a.y + random.integer(0, 40)};
  };
  const auto done = [](Status status) { REQUIRE(ok(status)); };
  const Alignment alignment{static_cast<HorizontalAlignment>(random.integer(0, 2)),
                            static_cast<VerticalAlignment>(random.integer(0, 2))};
  constexpr const char* kText = "Lip pL\nii LLpL WW L\xFFi";
  const Rgb8 a = colour();
  const Rgb8 b = colour();
  done(fill_rectangle(sink, rect(), a));
  done(fill_rectangle(sink, rect(), b, random.bits() % 40));
  done(draw_caption(sink, plain_font().font, rect(), kText, b, alignment));
  done(draw_caption(sink, smooth_font().font, rect(), kText, a, alignment));
  done(draw_frame(sink, rect(), a, random.integer(1, 4)));
  const Needle needle{
      point(), {static_cast<std::uint16_t>(random.bits())}, random.integer(0, 40), random.integer(1, 9), 5};
  done(draw_needle(sink, needle, b));
  done(draw_caption(sink, plain_font().font, rect(), kText, OutlinedText{a, b}, alignment));
  done(draw_caption(sink, smooth_font().font, rect(), kText, OutlinedText{b, a}));
  const Point from = point();
  done(draw_line(sink, from, point(), a));
  done(draw_text(sink, smooth_font().font, point(), kText, FilledText{a, b}));
  done(draw_bitmap(sink, point(), kBitmap));
}

template <PixelFormat F>
std::vector<typename F::Word> noise(std::int32_t rows) {
  std::vector<typename F::Word> words(hal::Framebuffer<F>::words(kWidth, rows));
  hal::Framebuffer<F> frame(words, kWidth, rows);
  for (std::int32_t y = 0; y < rows; ++y) {
    typename F::Cursor cursor(frame.row(y), 0);
    for (std::int32_t x = 0; x < kWidth; ++x, cursor.next()) {
      const auto level = [&](int k) { return static_cast<std::uint8_t>(x * 5 * k + y * 31 + k * 77); };
      cursor.write(F::encode({level(1), level(2), level(3)}));
    }
  }
  return words;
}

template <class A, class B>
bool same_within(const A& a, const B& b, const Rect& rect) {
  for (std::int32_t y = rect.top; y < rect.bottom; ++y)
    for (std::int32_t x = rect.left; x < rect.right; ++x)
      if (!(a.pixel(x, y) == b.pixel(x, y))) return false;
  return true;
}

}  // namespace

#define ARCSPAN_TYPE(name, type) , type
#define ARCSPAN_TYPES(...) TEMPLATE_TEST_CASE("overlays: a part has the pixels of the whole", "" __VA_ARGS__)
ARCSPAN_TYPES(ARCSPAN_FOR_EACH_PIXEL_FORMAT(ARCSPAN_TYPE)) {
  using F = TestType;
  Random random(17);
  bool changed = false;
  for (int i = share_of(60); i > 0; --i) {
    const std::uint64_t seed = random.bits();
    auto whole_words = noise<F>(kHeight);
    const auto before = whole_words;
    hal::Framebuffer<F> whole(whole_words, kWidth, kHeight);
    draw_all(whole, seed);
    changed =
        changed || std::memcmp(before.data(), whole_words.data(), before.size() * sizeof before[0]) != 0;

    // Bands of some rows.
    const std::int32_t rows = random.integer(1, 13);
    auto banded_words = noise<F>(kHeight);
    hal::Framebuffer<F> banded(banded_words, kWidth, kHeight);
    for (std::int32_t top = 0; top < kHeight; top += rows) {
      const std::int32_t held = std::min(rows, kHeight - top);
      hal::Framebuffer<F> band(
          std::span<typename F::Word>(banded_words).subspan(hal::Framebuffer<F>::words(kWidth, top)), kWidth,
          held, top);
      draw_all(band, seed);
    }
    CHECK(same_within(whole, banded, {0, 0, kWidth, kHeight}));

    // A scissor and, where columns begin a word, a window in the same memory: four parts each.
    const std::int32_t x = 8 * random.integer(0, kWidth / 8);
    const std::int32_t y = random.integer(0, kHeight);
    auto parted_words = noise<F>(kHeight);
    hal::Framebuffer<F> parted(parted_words, kWidth, kHeight);
    auto windowed_words = noise<F>(kHeight);
    hal::Framebuffer<F> windowed(windowed_words, kWidth, kHeight);
    for (const Rect& part :
         {Rect{0, 0, x, y}, Rect{x, 0, kWidth, y}, Rect{0, y, x, kHeight}, Rect{x, y, kWidth, kHeight}}) {
      SinkPart scissor(parted, part);
      draw_all(scissor, seed);
      if (part.empty()) continue;
      const auto bytes = std::as_writable_bytes(std::span<typename F::Word>(windowed_words));
      const auto first = static_cast<std::size_t>(part.top * windowed.stride_bytes()) +
                         F::words_per_row(part.left) * sizeof(typename F::Word);
      hal::FramebufferWindow<F> window(bytes.subspan(first), part, windowed.stride_bytes());
      REQUIRE(ok(window.status()));
      draw_all(window, seed);
    }
    CHECK(same_within(whole, parted, {0, 0, kWidth, kHeight}));
    CHECK(same_within(whole, windowed, {0, 0, kWidth, kHeight}));
  }
  CHECK(changed);
}

TEST_CASE("overlays: nothing of a part that its sink does not hold is drawn, wherever the overlay begins") {
  std::vector<std::uint16_t> words(hal::Framebuffer<Rgb565>::words(kWidth, 16));
  hal::Framebuffer<Rgb565> band(words, kWidth, 16);
  SinkPart later(band, {0, 20, kWidth, 30});
  CHECK(later.bounds() == Rect{});
  for (const std::int32_t y : {INT32_MIN + 30, -(1 << 30), 25, INT32_MAX - 30}) {
    const Needle needle{{20, y}, {0}, 40, 9, 5};
    CHECK(draw_needle(later, needle, {255, 255, 255}) == Status::kOk);
    CHECK(draw_text(later, plain_font().font, {20, y}, "Lip", Rgb8{255, 255, 255}) == Status::kOk);
  }
  CHECK(words == std::vector<std::uint16_t>(words.size()));
}
