// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/hal/framebuffer_window.hpp>
#include <arcspan/hal/panel/damage.hpp>
#include <arcspan/hal/panel/panel.hpp>
#include <arcspan/hal/panel/wire_layout.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan::hal {

/// A panel driver: a Panel that names its wire layout.
template <class P>
concept PanelDriver = std::derived_from<P, Panel> && WireLayout<typename P::Layout>;

/// Bytes that `rows` rows of `width` pixels take on the wire of P.
template <PanelDriver P>
[[nodiscard]] constexpr std::size_t wire_bytes(std::int32_t width, std::int32_t rows) {
  return P::Layout::bytes({0, 0, width, rows});
}

/// Page mode: draws a frame band by band into one buffer and sends it from another. One band is sent while
/// the next is drawn, and neither buffer holds a whole frame.
///
/// The caller owns panel and memory, which must outlive this object: `band` holds Frame::words(width, rows)
/// and `wire` holds wire_bytes<P>(width, rows). `rows` is 1 ... panel height, a multiple of the layout's row
/// step; 8 suits every panel here. No transfer uses the memory after show() has returned.
///
/// If a transfer fails in mid-frame, the frame ends and show() returns the cause. The failure of a band's
/// transfer is reported by finish() before the next band is sent, or at the end of the frame. The glass keeps
/// the bands sent so far. The caller just calls show() again: the panel then sends all its settings before
/// the first band (see Panel).
template <PanelDriver P>
class PageMode {
 public:
  using Layout = typename P::Layout;
  using Frame = Framebuffer<typename Layout::Format>;
  using Window = FramebufferWindow<typename Layout::Format>;

  constexpr PageMode(P& panel, std::span<typename Frame::Word> band, std::span<std::uint8_t> wire,
                     std::int32_t rows)
      : panel_(panel), band_memory_(band), wire_(wire), rows_(rows) {}

  /// Draws and sends a whole frame. Calls `draw(Frame& band)` for each band from top to bottom. The band
  /// still holds the pixels of an earlier one. A status of `draw` other than kOk ends the frame.
  ///
  /// - kInvalidArgument: `rows` is out of range, a side of the panel no multiple of the layout's steps, or
  /// `draw` has turned the panel, so that the band is one of another picture
  /// - kBufferTooSmall: `band` or `wire` is too small
  /// - kNotReady: the panel is not awake
  /// - others: the first failure of `draw` or the panel
  ///
  /// No transfer is under way when it returns.
  template <class Draw>
  Status show(Draw&& draw) {
    return for_each_band([&](Frame& band) { return Status{draw(band)}; },
                         [](std::int32_t top, std::int32_t width, std::int32_t bottom) {
                           return Rect{0, top, width, bottom};
                         });
  }

  /// As show(), but sends only the area that differs from the last frame. `draw(sink, band)` clears `band`
  /// and draws into `sink`. Returns kInvalidArgument and draws nothing unless `damage` has the panel's size.
  /// After a failure or a change of orientation the next frame is sent whole. What else changes the picture
  /// on the glass, such as show() and start(), `damage` does not see: call its mark_everything() then.
  template <class Draw>
  Status show_changes(Damage& damage, Draw&& draw) {
    if (damage.width() != panel_.width() || damage.height() != panel_.height())
      return Status::kInvalidArgument;
    damage.set_orientation(panel_.settings().orientation);
    // Else an unchanged frame would send nothing, not even the settings of a set() that failed.
    if (panel_.needs_configuration()) damage.mark_everything();
    damage.begin_frame();
    const Status status = for_each_band(
        [&](Frame& band) {
          DamageSink<Frame> sink(band, damage);
          return Status{draw(sink, band)};
        },
        [&damage](std::int32_t top, std::int32_t, std::int32_t bottom) {
          return damage.changed_area(top, bottom);
        });
    if (!ok(status)) damage.mark_everything();
    return status;
  }

  /// Draws and sends one rectangle of the picture: as far as it lies on the panel, and widened to the
  /// layout's steps. Calls `draw(Window& window)` for each part of it from top to bottom; `window.bounds()`
  /// is that part, in pixels of the picture. The pixels are those of the whole frame, if `draw` draws the
  /// same.
  ///
  /// A part is as high as the memory allows, and has at most as many pixels as `rows` rows of the panel: a
  /// narrow rectangle takes fewer parts than the frame has bands, and memory for the depths of a band serves
  /// DepthBuffer(memory, window.bounds()). Nothing is drawn or sent of an empty rectangle. Returns as show().
  ///
  /// A program that draws whole frames too saves code if it draws them by show_area(panel.bounds(), draw). A
  /// Damage does not see what is drawn here: call its mark_everything() before show_changes().
  template <class Draw>
  Status show_area(const Rect& area, Draw&& draw) {
    Status status = check();
    if (!ok(status)) return status;
    const Rect visible = on_panel(area);
    if (visible.empty()) return Status::kOk;
    if (band_memory_.size() < Frame::words(panel_.width(), rows_)) return Status::kBufferTooSmall;
    const Rect sent = widened<Layout>(visible, panel_.settings().orientation);
    const std::int32_t rows = part_rows(sent);
    for (std::int32_t top = sent.top; ok(status) && top < sent.bottom; top += rows) {
      const Rect part{sent.left, top, sent.right, top + rows < sent.bottom ? top + rows : sent.bottom};
      Window window(std::as_writable_bytes(band_memory_), part, Window::least_stride(part));
      status = window.status();
      if (ok(status)) status = drawn(draw, window);
      if (ok(status)) status = start_sending(window, part);
    }
    const Status last = panel_.finish();
    return ok(status) ? last : status;
  }

  /// show_area() of two rectangles, such as those where an object was and is: of the one around both if that
  /// has no more pixels than the two have, else of one after the other.
  template <class Draw>
  Status show_areas(const Rect& before, const Rect& now, Draw&& draw) {
    const Rect first = on_panel(before);
    const Rect second = on_panel(now);
    const Rect both = bounding_rect(first, second);
    if (pixels(both) <= pixels(first) + pixels(second)) return show_area(both, draw);
    const Status status = show_area(first, draw);
    return ok(status) ? show_area(second, draw) : status;
  }

 private:
  [[nodiscard]] Status check() const {
    const Orientation o = panel_.settings().orientation;
    if (!fits_steps<Layout>(panel_.bounds(), o)) return Status::kInvalidArgument;
    if (rows_ < 1 || rows_ > panel_.height() || rows_ % Layout::row_step(o) != 0)
      return Status::kInvalidArgument;
    if (wire_.size() < wire_bytes<P>(panel_.width(), rows_)) return Status::kBufferTooSmall;
    return panel_.awake() ? Status::kOk : Status::kNotReady;
  }

  template <class DrawBand, class AreaOf>
  Status for_each_band(DrawBand&& draw, AreaOf&& area_of) {
    Status status = check();
    if (!ok(status)) return status;
    const std::int32_t height = panel_.height();
    for (std::int32_t top = 0; ok(status) && top < height; top += rows_) {
      const std::int32_t bottom = top + rows_ < height ? top + rows_ : height;
      Frame band(band_memory_, panel_.width(), bottom - top, top);
      status = band.status();
      if (ok(status)) status = drawn(draw, band);
      if (ok(status)) status = start_sending(band, area_of(top, panel_.width(), bottom));
    }
    const Status last = panel_.finish();
    return ok(status) ? last : status;
  }

  /// Calls `draw`. Refuses what it has drawn if it has turned the panel meanwhile.
  template <class Draw, class Sink>
  Status drawn(Draw& draw, Sink& sink) {
    const Orientation before = panel_.settings().orientation;
    const Status status{draw(sink)};
    return ok(status) && panel_.settings().orientation != before ? Status::kInvalidArgument : status;
  }

  /// The part of a rectangle that lies on the panel; Rect{} if there is none.
  [[nodiscard]] Rect on_panel(const Rect& area) const {
    const Rect all = panel_.bounds();
    const Rect visible{area.left > 0 ? area.left : 0, area.top > 0 ? area.top : 0,
                       area.right < all.right ? area.right : all.right,
                       area.bottom < all.bottom ? area.bottom : all.bottom};
    return visible.empty() ? Rect{} : visible;
  }
  /// Unsigned, because check() may not have refused the sides of the glass, 65535 at most.
  [[nodiscard]] static std::uint32_t pixels(const Rect& visible) {
    return static_cast<std::uint32_t>(visible.width()) * static_cast<std::uint32_t>(visible.height());
  }

  /// How many rows of `area` are drawn at a time: a multiple of the layout's row step, at least one of them,
  /// because `area` is no wider than the panel.
  [[nodiscard]] std::int32_t part_rows(const Rect& area) const {
    const auto bytes = static_cast<std::uint32_t>(std::as_bytes(band_memory_).size());
    const std::uint32_t by_memory = bytes / static_cast<std::uint32_t>(Window::least_stride(area));
    const std::uint32_t by_pixels = static_cast<std::uint32_t>(panel_.width()) *
                                    static_cast<std::uint32_t>(rows_) /
                                    static_cast<std::uint32_t>(area.width());
    const auto step = static_cast<std::uint32_t>(Layout::row_step(panel_.settings().orientation));
    const std::uint32_t rows = by_memory < by_pixels ? by_memory : by_pixels;
    return static_cast<std::int32_t>(rows - rows % step);
  }

  Status start_sending(const Frame& band, const Rect& changed) {
    if (changed.empty()) return Status::kOk;
    const Status status = panel_.finish();
    if (!ok(status)) return status;
    const Orientation o = panel_.settings().orientation;
    const Rect area = widened<Layout>(changed, o);
    Layout::pack(band, area, o, wire_.data());
    return panel_.start_write(area, wire_.first(Layout::bytes(area)));
  }

  P& panel_;
  std::span<typename Frame::Word> band_memory_;
  std::span<std::uint8_t> wire_;
  std::int32_t rows_;
};

/// Sends `area` of a picture that is in memory as a whole, widened to the layout's steps. One half of `wire`
/// is filled while the other is sent. Returns when all is sent, so `wire` is free again.
///
/// - kInvalidArgument: a side of the panel is no multiple of the layout's steps, `frame` has another size, or
///   `area` is empty or not inside it
/// - kBufferTooSmall: half of `wire` does not hold one step of rows
/// - others: the first failure of the panel
template <PanelDriver P>
Status send_area(P& panel, const Framebuffer<typename P::Layout::Format>& frame, const Rect& area,
                 std::span<std::uint8_t> wire) {
  using Layout = typename P::Layout;
  const Rect all = panel.bounds();
  const Orientation o = panel.settings().orientation;
  if (frame.bounds() != all || !fits_steps<Layout>(all, o) || area.empty() || area.left < 0 || area.top < 0 ||
      area.right > all.right || area.bottom > all.bottom) {
    return Status::kInvalidArgument;
  }
  const Rect sent = widened<Layout>(area, o);
  const std::int32_t step = Layout::row_step(o);
  const std::size_t half = wire.size() / 2;
  const auto steps = static_cast<std::int64_t>(half / Layout::bytes({sent.left, 0, sent.right, step}));
  if (steps == 0) return Status::kBufferTooSmall;
  const std::int32_t rows =
      steps * step < sent.height() ? static_cast<std::int32_t>(steps) * step : sent.height();
  Status status = Status::kOk;
  bool second = false;
  for (std::int32_t top = sent.top; ok(status) && top < sent.bottom; top += rows, second = !second) {
    const std::int32_t bottom = top + rows < sent.bottom ? top + rows : sent.bottom;
    const Rect part{sent.left, top, sent.right, bottom};
    const std::span<std::uint8_t> bytes = wire.subspan(second ? half : 0, Layout::bytes(part));
    Layout::pack(frame, part, o, bytes.data());
    status = panel.finish();
    if (ok(status)) status = panel.start_write(part, bytes);
  }
  const Status last = panel.finish();
  return ok(status) ? last : status;
}

}  // namespace arcspan::hal
