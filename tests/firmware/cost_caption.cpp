// SPDX-License-Identifier: MIT
// A caption as a product draws it. It is compiled once more for size, because text_cost_test.py adds up its
// code.
#include <tests/firmware/cost_caption.hpp>

Status draw_measured_caption(MeasuredFrame& frame, const Rect& area, overlay::Utf8Text text) {
  return overlay::draw_caption(frame, label_font::kFont, area, text, Rgb8{255, 255, 255},
                               overlay::HorizontalAlignment::kCentre);
}
