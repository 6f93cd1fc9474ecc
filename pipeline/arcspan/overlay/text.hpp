// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/overlay/area.hpp>
#include <arcspan/overlay/draw_glyph.hpp>
#include <arcspan/overlay/font.hpp>
#include <arcspan/overlay/rectangle.hpp>
#include <arcspan/overlay/utf8.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>

#include <concepts>
#include <cstdint>
#include <type_traits>

namespace arcspan::overlay {

/// Text with an outline one pixel wide, which stays readable on any picture.
struct OutlinedText {
  Rgb8 colour{};
  Rgb8 outline{};
};

/// Text on a rectangle, as wide as the text and as high as a line.
struct FilledText {
  Rgb8 colour{};
  Rgb8 background{};
};

/// How text is drawn: a colour alone, an OutlinedText or a FilledText.
template <class S>
concept TextStyle = std::same_as<S, Rgb8> || std::same_as<S, OutlinedText> || std::same_as<S, FilledText>;

namespace detail {

/// Draws the glyphs of lines in one colour: their pixels or, if `Outlined`, their outlines.
template <bool Outlined, PixelSink Sink, unsigned Bits>
struct GlyphPass {
  using Mask = std::conditional_t<Bits == 1, std::conditional_t<Outlined, BitOutline, BitMask>,
                                  std::conditional_t<Outlined, CoverageOutline, CoverageMask>>;

  Sink& sink;
  const Font<Bits>& font;
  const Rect& clip;
  typename Sink::Format::Encoded colour;

  /// Draws the line whose pen begins at column at.x and whose top is row at.y.
  [[nodiscard]] constexpr Status operator()(Utf8Text line, Point at) const {
    constexpr std::int32_t kMostLeft = 129;  // columns from the pen to the left, with an outline
    while (!line.empty() && wrap_sub(at.x, clip.right) < kMostLeft) {
      const auto found = font.find(line.take());
      const Glyph& glyph = *found.glyph;
      const Status status = draw_glyph(sink, Mask{glyph, found.bitmap},
                                       {wrap_add(at.x, glyph.left), wrap_add(at.y, glyph.top)}, clip, colour);
      if (!ok(status)) return status;
      at.x = wrap_add(at.x, glyph.advance);
    }
    return Status::kOk;
  }
};

/// Fills the rectangles behind lines.
template <PixelSink Sink, unsigned Bits>
struct BackgroundPass {
  Sink& sink;
  const Font<Bits>& font;
  const Rect& clip;
  typename Sink::Format::Encoded colour;

  [[nodiscard]] constexpr Status operator()(Utf8Text line, Point at) const {
    const Rect box = rect_at(at, text_width(font, line), font.line_height());
    return fill_within(sink, intersection(box, clip), colour);
  }
};

/// Draws lines in a style. lines.draw(pass) calls pass(line, at) for each line and returns the first status
/// that is not kOk. No outline or background covers the glyphs of another line, because the glyphs come last.
template <PixelSink Sink, unsigned Bits, TextStyle Style, class Lines>
[[nodiscard]] constexpr Status draw_styled(Sink& sink, const Font<Bits>& font, const Rect& clip,
                                           const Style& style, const Lines& lines) {
  using Format = typename Sink::Format;
  using Ink = GlyphPass<false, Sink, Bits>;
  if (const Status status = status_of(sink); !ok(status)) return status;
  if constexpr (std::same_as<Style, Rgb8>) {
    return lines.draw(Ink{sink, font, clip, Format::encode(style)});
  } else {
    Status status = Status::kOk;
    if constexpr (std::same_as<Style, OutlinedText>) {
      using Outline = GlyphPass<true, Sink, Bits>;
      status = lines.draw(Outline{sink, font, clip, Format::encode(style.outline)});
    } else {
      status = lines.draw(BackgroundPass<Sink, Bits>{sink, font, clip, Format::encode(style.background)});
    }
    if (!ok(status)) return status;
    return lines.draw(Ink{sink, font, clip, Format::encode(style.colour)});
  }
}

/// True if a line whose top is row `y` may have pixels in the rows of `clip`, its outline included.
template <unsigned Bits>
[[nodiscard]] constexpr bool meets_rows(const Font<Bits>& font, std::int32_t y, const Rect& clip) {
  return wrap_sub(clip.bottom, y) >= font.top() && wrap_sub(clip.top, y) <= font.bottom();
}

/// A single line.
template <unsigned Bits>
struct OneLine {
  const Font<Bits>& font;
  Point at;
  Utf8Text text;

  template <class Pass>
  [[nodiscard]] constexpr Status draw(const Pass& pass) const {
    return meets_rows(font, at.y, pass.clip) ? pass(text, at) : Status::kOk;
  }
};

}  // namespace detail

/// Draws one line of text. The pen begins at column at.x, the top of the line is row at.y. There is one glyph
/// per code point, from left to right; control characters, newlines too, are shown as spaces. Code points
/// that the font does not have are shown as its placeholder; missing_glyphs() counts them. Returns the first
/// status of the sink that is not kOk, else kOk.
template <PixelSink Sink, unsigned Bits, TextStyle Style>
constexpr Status draw_text(Sink& sink, const Font<Bits>& font, Point at, Utf8Text text, const Style& style) {
  const Rect clip = sink.bounds();
  return detail::draw_styled(sink, font, clip, style, detail::OneLine<Bits>{font, at, text});
}

}  // namespace arcspan::overlay
