// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/overlay/area.hpp>
#include <arcspan/overlay/font.hpp>
#include <arcspan/overlay/text.hpp>
#include <arcspan/overlay/utf8.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>

#include <concepts>
#include <cstdint>

namespace arcspan::overlay {

enum class HorizontalAlignment : std::uint8_t { kLeft, kCentre, kRight };
enum class VerticalAlignment : std::uint8_t { kTop, kMiddle, kBottom };

/// Where the lines of a caption stand in its rectangle.
struct Alignment {
  HorizontalAlignment horizontal = HorizontalAlignment::kLeft;
  VerticalAlignment vertical = VerticalAlignment::kTop;
};

/// How a caption is aligned: by an Alignment, or, in less code, by a HorizontalAlignment and at the top.
template <class A>
concept CaptionAlignment = std::same_as<A, Alignment> || std::same_as<A, HorizontalAlignment>;

/// The columns and rows that a caption takes.
struct TextSize {
  std::int32_t width = 0;
  std::int32_t height = 0;

  friend constexpr bool operator==(const TextSize&, const TextSize&) = default;
};

namespace detail {

/// A line of a caption, and the text behind it.
struct CaptionLine {
  const char* end;
  const char* next;
  std::uint32_t width;
};

/// The first line of a text, which is not empty(), in `most` columns. It ends at a newline, at the last
/// spaces before the first glyph that would leave the columns, or, in a word that is too long, before that
/// glyph; it has at least one glyph. Spaces at its end are not part of it, and those where it is broken not
/// of the next.
template <unsigned Bits>
[[nodiscard]] constexpr CaptionLine first_line(const Font<Bits>& font, Utf8Text text, std::uint32_t most) {
  CaptionLine line{text.begin(), text.end(), 0};
  CaptionLine shorter = line;  // up to the last spaces; its width is 0 if there were none
  std::uint32_t pen = 0;
  while (!text.empty()) {
    const char* const before = text.begin();
    const std::uint32_t code = text.take();
    const std::uint32_t end = pen + font.find(code).glyph->advance;
    if (code <= ' ') {
      shorter = {line.end, text.begin(), line.width};
      if (code == '\n') return shorter;
    } else if (end > most && pen != 0) {
      const bool is_long_word = shorter.width == 0 && line.width != 0;
      return is_long_word ? CaptionLine{before, before, pen} : shorter;
    } else {
      line.end = text.begin();
      line.width = end;
    }
    pen = end;
  }
  return line;
}

}  // namespace detail

/// The size of a caption in an area `width` pixels wide: its longest line, and the height of its lines, which
/// may be more than an area has.
template <unsigned Bits>
[[nodiscard]] constexpr TextSize caption_size(const Font<Bits>& font, Utf8Text text,
                                              std::uint32_t width = UINT32_MAX) {
  TextSize size;
  while (!text.empty()) {
    const detail::CaptionLine line = detail::first_line(font, text, width);
    const auto columns = static_cast<std::int32_t>(line.width);
    if (columns > size.width) size.width = columns;
    size.height = wrap_add(size.height, font.line_height());
    text = {line.next, text.end()};
  }
  return size;
}

namespace detail {

/// Where something `size` wide stands in `room`: 0 at its beginning, 1 in the middle, 2 at its end; at its
/// beginning if it is too large.
[[nodiscard]] constexpr std::int32_t aligned(std::uint32_t room, std::uint32_t size, int alignment) {
  if (size >= room || alignment == 0) return 0;
  const std::uint32_t free = room - size;
  return static_cast<std::int32_t>(alignment == 1 ? free / 2 : free);
}

/// The lines of a caption.
template <unsigned Bits, CaptionAlignment Aligned>
struct WrappedText {
  const Font<Bits>& font;
  const Rect& area;
  Utf8Text text;
  Aligned alignment;

  template <class Pass>
  [[nodiscard]] constexpr Status draw(const Pass& pass) const {
    const std::uint32_t width = extent(area.left, area.right);
    Point at{area.left, area.top};
    if constexpr (std::same_as<Aligned, Alignment>) {
      const auto rows = static_cast<std::uint32_t>(caption_size(font, text, width).height);
      at.y =
          wrap_add(at.y, aligned(extent(area.top, area.bottom), rows, static_cast<int>(alignment.vertical)));
    }
    for (Utf8Text rest = text; !rest.empty();) {
      const CaptionLine line = first_line(font, rest, width);
      if (meets_rows(font, at.y, pass.clip)) {
        at.x = wrap_add(area.left, aligned(width, line.width, horizontal()));
        const Status status = pass({rest.begin(), line.end}, at);
        if (!ok(status)) return status;
      }
      at.y = wrap_add(at.y, font.line_height());
      rest = {line.next, rest.end()};
    }
    return Status::kOk;
  }

  [[nodiscard]] constexpr int horizontal() const {
    if constexpr (std::same_as<Aligned, Alignment>)
      return static_cast<int>(alignment.horizontal);
    else
      return static_cast<int>(alignment);
  }
};

}  // namespace detail

/// Draws text in lines within `area`, and nothing outside of it. A line ends at a newline, or at spaces where
/// the next word would leave the area; words wider than the area are broken. If not all lines fit, the first
/// ones are shown. Glyphs are those of draw_text(). Returns the first status of the sink that is not kOk,
/// else kOk.
template <PixelSink Sink, unsigned Bits, TextStyle Style, CaptionAlignment Aligned = HorizontalAlignment>
constexpr Status draw_caption(Sink& sink, const Font<Bits>& font, const Rect& area, Utf8Text text,
                              const Style& style, Aligned alignment = {}) {
  const Rect clip = detail::intersection(area, sink.bounds());
  if (clip.empty()) return detail::status_of(sink);
  return detail::draw_styled(sink, font, clip, style,
                             detail::WrappedText<Bits, Aligned>{font, area, text, alignment});
}

}  // namespace arcspan::overlay
