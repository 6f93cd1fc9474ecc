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
#include <arcspan/target.hpp>

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

/// Draws the glyphs of lines by one mask and in one colour: their pixels, or their outlines.
template <bool Outlined, PixelSink Sink, unsigned Bits>
class GlyphPass {
 public:
  constexpr GlyphPass(Sink& sink, const Font<Bits>& font, const Rect& clip, Rgb8 colour)
      : sink_(sink), font_(font), clip_(clip), colour_(Sink::Format::encode(colour)) {}

  /// Draws the line whose pen begins at column at.x and whose top is row at.y.
  [[nodiscard]] constexpr Status operator()(Utf8Text line, Point at) const {
    // The box of a glyph begins at most 128 columns left of its pen, and its outline one more.
    while (!line.empty() && saturated_sub(at.x, 129) < clip_.right) {
      const auto found = font_.find(line.take());
      const Status status = draw(found, at);
      if (!ok(status)) return status;
      at.x = saturated_add(at.x, found.glyph->advance);
    }
    return Status::kOk;
  }

 private:
  using Encoded = typename Sink::Format::Encoded;
  using Colour = std::conditional_t<Bits == 1, Encoded, MixedColour<typename Sink::Format>>;
  using Mask = std::conditional_t<Bits == 1, std::conditional_t<Outlined, BitOutline, BitMask>,
                                  std::conditional_t<Outlined, CoverageOutline, CoverageMask>>;

  [[nodiscard]] constexpr Status draw(const typename Font<Bits>::Found& found, Point pen) const {
    const Glyph& glyph = *found.glyph;
    if (glyph.width == 0) return Status::kOk;
    const Point at{saturated_add(pen.x, glyph.left), saturated_add(pen.y, glyph.top)};
    Rect box = rect_at(at, glyph.width, glyph.height);
    if constexpr (Outlined) {
      box = {saturated_sub(box.left, 1), saturated_sub(box.top, 1), saturated_add(box.right, 1),
             saturated_add(box.bottom, 1)};
    }
    const Rect visible = intersection(box, clip_);
    if (visible.empty()) return Status::kOk;
    if constexpr (Outlined)
      return draw_mask(sink_, Mask{{glyph, found.bitmap}}, at, visible, colour_);
    else
      return draw_mask(sink_, Mask{glyph, found.bitmap}, at, visible, colour_);
  }

  Sink& sink_;
  const Font<Bits>& font_;
  Rect clip_;
  Colour colour_;
};

/// Fills the rectangles behind lines.
template <PixelSink Sink, unsigned Bits>
struct BackgroundPass {
  Sink& sink;
  const Font<Bits>& font;
  Rect clip;
  Rgb8 colour;

  [[nodiscard]] constexpr Status operator()(Utf8Text line, Point at) const {
    const Rect box = rect_at(at, text_width(font, line), font.line_height());
    return fill_within(sink, intersection(box, clip), Sink::Format::encode(colour));
  }
};

/// Draws lines in a style. `for_lines(pass)` calls pass(line, at) for each line and returns the first status
/// that is not kOk. No outline or background covers the glyphs of another line, because the glyphs come last.
template <PixelSink Sink, unsigned Bits, TextStyle Style, class ForLines>
[[nodiscard]] constexpr Status draw_lines(Sink& sink, const Font<Bits>& font, const Rect& clip,
                                          const Style& style, const ForLines& for_lines) {
  if (const Status status = status_of(sink); !ok(status)) return status;
  if (clip.empty()) return Status::kOk;
  if constexpr (std::same_as<Style, Rgb8>) {
    return for_lines(GlyphPass<false, Sink, Bits>(sink, font, clip, style));
  } else {
    Status status = Status::kOk;
    if constexpr (std::same_as<Style, OutlinedText>)
      status = for_lines(GlyphPass<true, Sink, Bits>(sink, font, clip, style.outline));
    else
      status = for_lines(BackgroundPass<Sink, Bits>{sink, font, clip, style.background});
    if (!ok(status)) return status;
    return for_lines(GlyphPass<false, Sink, Bits>(sink, font, clip, style.colour));
  }
}

/// True if a line whose top is row `y` may have pixels in `clip`, its outline included.
template <unsigned Bits>
[[nodiscard]] constexpr bool line_meets(const Font<Bits>& font, std::int32_t y, const Rect& clip) {
  return saturated_add(y, font.top() - 1) < clip.bottom && saturated_add(y, font.bottom() + 1) > clip.top;
}

}  // namespace detail

/// Draws one line of text. The pen begins at column at.x, the top of the line is row at.y. There is one glyph
/// per code point, from left to right; control characters, newlines too, are shown as spaces. Code points
/// that the font does not have are shown as its placeholder; missing_glyphs() counts them. Returns the first
/// status of the sink that is not kOk, else kOk.
template <PixelSink Sink, unsigned Bits, TextStyle Style>
constexpr Status draw_text(Sink& sink, const Font<Bits>& font, Point at, Utf8Text text, const Style& style) {
  const Rect clip = sink.bounds();
  return detail::draw_lines(sink, font, clip, style, [&](const auto& pass) {
    return detail::line_meets(font, at.y, clip) ? pass(text, at) : Status::kOk;
  });
}

}  // namespace arcspan::overlay
