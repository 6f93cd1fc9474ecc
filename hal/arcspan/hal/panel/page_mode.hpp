// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/hal/panel/damage.hpp>
#include <arcspan/hal/panel/panel.hpp>
#include <arcspan/hal/panel/wire_layout.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan::hal {

/// A panel driver: the cold path from Panel, the hot one from its wire layout.
template <class P>
concept PanelDriver = std::derived_from<P, Panel> && WireLayout<typename P::Layout>;

/// Bytes that `area` takes on the wire of P.
template <PanelDriver P>
[[nodiscard]] constexpr std::size_t wire_bytes(std::int32_t width, std::int32_t rows) {
  return P::Layout::bytes({0, 0, width, rows});
}

/// Page mode: frames are drawn band by band into one buffer and sent from another, so that one band is on the
/// wire while the next is drawn, and neither buffer holds a frame.
///
/// Memory is the caller's: `band` holds Frame::words(width, rows), `wire` holds wire_bytes<P>(width, rows).
/// `rows` counts 1 ... the panel's height, in multiples of the layout's row step; 8 suits every panel here.
template <PanelDriver P>
class PageMode {
 public:
  using Layout = typename P::Layout;
  using Frame = Framebuffer<typename Layout::Format>;

  constexpr PageMode(P& panel, std::span<typename Frame::Word> band, std::span<std::uint8_t> wire,
                     std::int32_t rows)
      : panel_(panel), band_memory_(band), wire_(wire), rows_(rows) {}

  /// Draws and sends a whole frame. `draw(Frame& band)` is called for every band, from top to bottom, with
  /// the pixels that an earlier band has left in it; it returns a Status, and one that is not kOk ends the
  /// frame.
  ///
  /// kInvalidArgument for `rows` outside its range, kBufferTooSmall, kNotReady; otherwise the first status of
  /// `draw` or the panel that is not kOk. No transfer is under way when it returns.
  template <class Draw>
  Status show(Draw&& draw) {
    return each_band([&](Frame& band) { return Status{draw(band)}; },
                     [](std::int32_t top, std::int32_t width, std::int32_t bottom) {
                       return Rect{0, top, width, bottom};
                     });
  }

  /// As show(), but sends only what has changed since the last frame: `draw(sink, band)` clears `band` and
  /// draws into `sink`. `damage` has the panel's size. After a failure, the next frame is sent whole.
  template <class Draw>
  Status show_changes(Damage& damage, Draw&& draw) {
    damage.begin_frame();
    const Status status = each_band(
        [&](Frame& band) {
          DamageSink<Frame> sink(band, damage);
          return Status{draw(sink, band)};
        },
        [&damage](std::int32_t top, std::int32_t, std::int32_t bottom) {
          return damage.changed(top, bottom);
        });
    if (!ok(status)) damage.mark_everything();
    return status;
  }

 private:
  [[nodiscard]] Status check() const {
    const std::int32_t step = Layout::row_step(panel_.settings().orientation);
    if (rows_ < 1 || rows_ > panel_.height() || rows_ % step != 0) return Status::kInvalidArgument;
    if (wire_.size() < wire_bytes<P>(panel_.width(), rows_)) return Status::kBufferTooSmall;
    return panel_.awake() ? Status::kOk : Status::kNotReady;
  }

  template <class DrawBand, class AreaOf>
  Status each_band(DrawBand&& draw, AreaOf&& area_of) {
    Status status = check();
    if (!ok(status)) return status;
    const std::int32_t height = panel_.height();
    for (std::int32_t top = 0; ok(status) && top < height; top += rows_) {
      const std::int32_t bottom = top + rows_ < height ? top + rows_ : height;
      Frame band(band_memory_, panel_.width(), bottom - top, top);
      status = band.status();
      if (ok(status)) status = draw(band);
      if (ok(status)) status = send(band, area_of(top, panel_.width(), bottom));
    }
    const Status last = panel_.finish();
    return ok(status) ? last : status;
  }

  Status send(const Frame& band, const Rect& changed) {
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

/// Sends `area` of a picture that is in memory as a whole, widened to the layout's steps, through `wire`: one
/// half of it is filled while the other is on the wire. Returns when all is sent.
///
/// kInvalidArgument if `area` is not inside the frame and the panel; kBufferTooSmall if half of `wire` does
/// not hold one step of rows; otherwise the first status of the panel that is not kOk.
template <PanelDriver P>
Status send_area(P& panel, const Framebuffer<typename P::Layout::Format>& frame, const Rect& area,
                 std::span<std::uint8_t> wire) {
  using Layout = typename P::Layout;
  const Rect all = panel.bounds();
  if (frame.bounds() != all || area.empty() || area.left < 0 || area.top < 0 || area.right > all.right ||
      area.bottom > all.bottom) {
    return Status::kInvalidArgument;
  }
  const Orientation o = panel.settings().orientation;
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
