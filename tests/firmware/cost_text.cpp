// SPDX-License-Identifier: MIT
// A caption of 14 glyphs of a bold font with lines of 24 rows, in three styles, and shapes, for
// text_cost_test.py.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/hal/panel/damage.hpp>
#include <arcspan/overlay/line.hpp>
#include <arcspan/overlay/needle.hpp>
#include <arcspan/overlay/rectangle.hpp>

#include <tests/firmware/cost_caption.hpp>

using namespace arcspan::overlay;

namespace {

constexpr std::int32_t kWidth = 320;
constexpr std::int32_t kHeight = 240;
constexpr Rgb8 kWhite{255, 255, 255};
constexpr Rect kArea{20, 100, 300, 200};

using Frame = MeasuredFrame;

constexpr const char* kText = "Speed 88 km/h!";

[[gnu::section(".bss.frame")]] std::uint16_t colours[kWidth * kHeight];
hal::RowExtent rows[hal::Damage::extents(kHeight)];

template <class Draw>
bool measure(const char* name, const Draw& draw) {
  Frame frame(colours, kWidth, kHeight);
  frame.clear({0, 0, 0});
  arcspan_mark();
  const Status status = draw(frame);
  arcspan_mark();
  std::uint32_t pixels = 0;
  for (const std::uint16_t pixel : colours) pixels += pixel != 0 ? 1 : 0;
  bare::print_line("section: ", name);
  bare::print_line("section: between");
  bare::print_line("drawn: ", name, " pixels ", pixels);
  return ok(status);
}

}  // namespace

int main() {
  hal::Damage damage(rows, kWidth, kHeight);
  bool right = measure("caption", [](Frame& frame) { return draw_measured_caption(frame, kArea, kText); });
  right &= measure("damage", [&](Frame& frame) {
    hal::DamageSink sink(frame, damage);
    return draw_caption(sink, label_font::kFont, kArea, kText, kWhite);
  });
  right &= measure("outlined", [](Frame& frame) {
    return draw_caption(frame, label_font::kFont, kArea, kText, OutlinedText{kWhite, {90, 0, 0}});
  });
  right &= measure("filled", [](Frame& frame) {
    return draw_caption(frame, label_font::kFont, kArea, kText, FilledText{kWhite, {90, 0, 0}});
  });
  right &= measure("line", [](Frame& frame) { return draw_line(frame, {10, 20}, {309, 219}, kWhite); });
  right &= measure("rectangle", [](Frame& frame) { return fill_rectangle(frame, kArea, kWhite); });
  right &= measure("needle", [](Frame& frame) {
    return draw_needle(frame, {{160, 120}, {7000}, 100, 9, 20}, kWhite);
  });
  return right ? 0 : 1;
}
