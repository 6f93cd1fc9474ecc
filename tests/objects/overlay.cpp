// SPDX-License-Identifier: MIT
// Text and shapes over a picture, in a format of words, one of bits and one whose rows are not in memory.
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/hal/panel/damage.hpp>
#include <arcspan/overlay/bitmap.hpp>
#include <arcspan/overlay/caption.hpp>
#include <arcspan/overlay/line.hpp>
#include <arcspan/overlay/needle.hpp>
#include <arcspan/overlay/rectangle.hpp>

namespace arcspan::overlay {

using Frame565 = hal::Framebuffer<Rgb565>;
using FrameMono = hal::Framebuffer<Mono>;
using Damaged = hal::DamageSink<Frame565>;
using Icon = Palette4Texels<Alpha4Colour>;

#define ARCSPAN_INSTANTIATE(Sink)                                                                 \
  template Status draw_text(Sink&, const Font<1>&, Point, Utf8Text, const Rgb8&);                 \
  template Status draw_text(Sink&, const Font<4>&, Point, Utf8Text, const OutlinedText&);         \
  template Status draw_caption(Sink&, const Font<1>&, const Rect&, Utf8Text, const OutlinedText&, \
                               Alignment);                                                        \
  template Status draw_caption(Sink&, const Font<4>&, const Rect&, Utf8Text, const FilledText&,   \
                               HorizontalAlignment);                                              \
  template Status fill_rectangle(Sink&, const Rect&, Rgb8);                                       \
  template Status fill_rectangle(Sink&, const Rect&, Rgb8, std::uint32_t);                        \
  template Status draw_frame(Sink&, const Rect&, Rgb8, std::int32_t);                             \
  template Status draw_line(Sink&, Point, Point, Rgb8);                                           \
  template Status draw_bitmap(Sink&, Point, const Bitmap<Icon>&);                                 \
  template Status draw_needle(Sink&, const Needle&, Rgb8);
ARCSPAN_INSTANTIATE(Frame565)
ARCSPAN_INSTANTIATE(FrameMono)
ARCSPAN_INSTANTIATE(Damaged)
#undef ARCSPAN_INSTANTIATE

template class Font<1>;
template class Font<4>;

Rect covered(const Needle& needle) { return needle_rect(needle); }
std::size_t missing(const Font<4>& font, Utf8Text text) { return missing_glyphs(font, text); }
TextSize size(const Font<1>& font, Utf8Text text) { return caption_size(font, text, 100); }

}  // namespace arcspan::overlay
