// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/overlay/area.hpp>
#include <arcspan/overlay/font.hpp>
#include <arcspan/overlay/text.hpp>
#include <arcspan/overlay/utf8.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan::overlay {

enum class HorizontalAlignment : std::uint8_t { kLeft, kCentre, kRight };
enum class VerticalAlignment : std::uint8_t { kTop, kMiddle, kBottom };

/// Where the lines of a caption stand in its rectangle.
struct Alignment {
  HorizontalAlignment horizontal = HorizontalAlignment::kLeft;
  VerticalAlignment vertical = VerticalAlignment::kTop;
};

/// The columns and rows that a caption takes.
struct TextSize {
  std::int32_t width = 0;
  std::int32_t height = 0;

  friend constexpr bool operator==(const TextSize&, const TextSize&) = default;
};

namespace detail {

/// The lines of a caption that is `width` pixels wide. A line ends at a newline, at the last spaces before
/// the first glyph that would leave the width, or, in a word that is too long, before that glyph; it has at
/// least one glyph. Spaces at the end of a line are not part of it, and those where it was broken not of the
/// next.
template <unsigned Bits>
class CaptionLines {
 public:
  constexpr CaptionLines(const Font<Bits>& font, Utf8Text text, std::int32_t width)
      : font_(font), rest_(text), most_(width) {}

  /// Makes the next line the current one. Returns false if there is none.
  constexpr bool next() {
    if (rest_.empty()) return false;
    const char* const begin = rest_.begin();
    line_ = {{begin, begin}, 0};
    Line shorter = line_;  // the line up to the last spaces, and the text behind them
    Utf8Text behind;
    std::int32_t pen = 0;
    while (!rest_.empty()) {
      const Utf8Text before = rest_;
      const std::uint32_t code = rest_.take();
      if (code == '\n') break;
      const std::int32_t end = saturated_add(pen, font_.find(code).glyph->advance);
      if (code <= ' ') {
        shorter = line_;
        behind = rest_;
      } else if (end > most_ && before.begin() != begin) {
        const bool is_long_word = shorter.text.empty();
        line_ = is_long_word ? Line{{begin, before.begin()}, pen} : shorter;
        rest_ = is_long_word ? before : behind;
        break;
      } else {
        line_ = {{begin, rest_.begin()}, end};
      }
      pen = end;
    }
    return true;
  }

  [[nodiscard]] constexpr Utf8Text text() const { return line_.text; }
  [[nodiscard]] constexpr std::int32_t width() const { return line_.width; }

 private:
  struct Line {
    Utf8Text text;
    std::int32_t width;
  };

  const Font<Bits>& font_;
  Utf8Text rest_;
  std::int32_t most_;
  Line line_{};
};

/// The width and the height of a rectangle, 0 or more, saturated.
[[nodiscard]] constexpr TextSize size_of(const Rect& rect) {
  if (rect.empty()) return {};
  return {saturated_sub(rect.right, rect.left), saturated_sub(rect.bottom, rect.top)};
}

/// Rows between the top of a rectangle of `height` rows and the first line of a caption within it. If not all
/// lines fit, the first ones are shown.
template <unsigned Bits>
[[nodiscard]] constexpr std::int32_t rows_above(CaptionLines<Bits> lines, std::int32_t line_height,
                                                std::int32_t height, VerticalAlignment alignment) {
  if (alignment == VerticalAlignment::kTop) return 0;
  while (height > 0 && lines.next()) height = saturated_sub(height, line_height);
  if (height <= 0) return 0;
  return alignment == VerticalAlignment::kMiddle ? height / 2 : height;
}

/// Columns between the left of a rectangle and a line, of which the rectangle has `room` more. A glyph wider
/// than the rectangle begins at its left.
[[nodiscard]] constexpr std::int32_t columns_before(std::int32_t room, HorizontalAlignment alignment) {
  if (alignment == HorizontalAlignment::kLeft || room <= 0) return 0;
  return alignment == HorizontalAlignment::kCentre ? room / 2 : room;
}

}  // namespace detail

/// Draws text in lines within `area`, and nothing outside of it. A line ends at a newline, or at spaces where
/// the next word would leave the area; words wider than the area are broken. Glyphs are those of draw_text().
/// Returns the first status of the sink that is not kOk, else kOk.
template <PixelSink Sink, unsigned Bits, TextStyle Style>
constexpr Status draw_caption(Sink& sink, const Font<Bits>& font, const Rect& area, Utf8Text text,
                              const Style& style, const Alignment& alignment = {}) {
  const TextSize size = detail::size_of(area);
  const Rect clip = detail::intersection(area, sink.bounds());
  return detail::draw_lines(sink, font, clip, style, [&](const auto& pass) {
    detail::CaptionLines<Bits> lines(font, text, size.width);
    const std::int32_t above = detail::rows_above(lines, font.line_height(), size.height, alignment.vertical);
    std::int32_t y = detail::saturated_add(area.top, above);
    while (detail::saturated_add(y, font.top() - 1) < clip.bottom && lines.next()) {
      if (detail::line_meets(font, y, clip)) {
        const std::int32_t before =
            detail::columns_before(detail::saturated_sub(size.width, lines.width()), alignment.horizontal);
        const Status status = pass(lines.text(), {detail::saturated_add(area.left, before), y});
        if (!ok(status)) return status;
      }
      y = detail::saturated_add(y, font.line_height());
    }
    return Status::kOk;
  });
}

/// The size of a caption in an area `width` pixels wide: its longest line, and the height of its lines, which
/// may be more than an area has. Saturated.
template <unsigned Bits>
[[nodiscard]] constexpr TextSize caption_size(const Font<Bits>& font, Utf8Text text,
                                              std::int32_t width = INT32_MAX) {
  TextSize size;
  for (detail::CaptionLines<Bits> lines(font, text, width); lines.next();) {
    if (lines.width() > size.width) size.width = lines.width();
    size.height = detail::saturated_add(size.height, font.line_height());
  }
  return size;
}

}  // namespace arcspan::overlay
