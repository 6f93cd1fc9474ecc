// SPDX-License-Identifier: MIT
// Bands of a picture on the displays of four Arduino libraries. None of them is included: a sketch includes
// its own, in any order. Part of arcspan.h.
#pragma once

#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565_swapped.hpp>
#include <arcspan/span/depth.hpp>

#include <cstdint>

namespace arcspan {

namespace detail {

template <class T>
concept HasDmaWait = requires(T& tft) {
  tft.dmaWait();
};
template <class T>
concept HasPushImageDma = requires(T& tft, std::uint16_t* pixels) {
  tft.pushImageDMA(0, 0, 1, 1, pixels);
};

}  // namespace detail

/// send_band() begins to send `width` x `height` pixels to the display's (x, y), and finish_band() waits
/// until they are sent. Each band must be finished before the next is sent, and keep its pixels until then.
/// Pixels are rgb565 with the high byte first, as they go over the wire; leave setSwapBytes() false.
///
/// TFT_eSPI, after initDMA().
template <detail::HasPushImageDma T>
requires detail::HasDmaWait<T>
void send_band(T& tft, std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height,
               std::uint16_t* pixels) {
  tft.startWrite();
  tft.pushImageDMA(x, y, width, height, pixels);
}
template <detail::HasDmaWait T>
void finish_band(T& tft) {
  tft.dmaWait();
  tft.endWrite();
}

/// LovyanGFX and M5GFX.
template <detail::HasPushImageDma T>
requires requires(T& tft) { tft.waitDMA(); }
void send_band(T& tft, std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height,
               std::uint16_t* pixels) {
  tft.startWrite();
  tft.pushImageDMA(x, y, width, height, pixels);
}
template <class T>
requires requires(T& tft) { tft.waitDMA(); }
void finish_band(T& tft) {
  tft.waitDMA();
  tft.endWrite();
}

/// Adafruit_SPITFT: Adafruit_ILI9341, Adafruit_ST7789 and others. Where it has no DMA, send_band() waits
/// itself.
template <detail::HasDmaWait T>
requires requires(T& tft, std::uint16_t* pixels) { tft.writePixels(pixels, 1u, false, true); }
void send_band(T& tft, std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height,
               std::uint16_t* pixels) {
  tft.startWrite();
  tft.setAddrWindow(static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                    static_cast<std::uint16_t>(width), static_cast<std::uint16_t>(height));
  tft.writePixels(pixels, static_cast<std::uint32_t>(width * height), false, true);
}

/// Arduino_GFX. send_band() returns when the pixels are sent.
template <class T>
requires requires(T& tft, std::uint16_t* pixels) { tft.draw16bitBeRGBBitmap(0, 0, pixels, 1, 1); }
void send_band(T& tft, std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height,
               std::uint16_t* pixels) {
  tft.draw16bitBeRGBBitmap(static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), pixels,
                           static_cast<std::int16_t>(width), static_cast<std::int16_t>(height));
}
template <class T>
requires requires(T& tft, std::uint16_t* pixels) { tft.draw16bitBeRGBBitmap(0, 0, pixels, 1, 1); }
void finish_band(T&) {}

/// Two bands of `Rows` rows of a picture `Width` pixels wide, one of which is sent while the other is drawn,
/// and the depths of one. It takes 6 bytes per pixel of a band.
template <std::int32_t Width, std::int32_t Rows>
class DisplayBands {
 public:
  using Band = hal::Framebuffer<Rgb565Swapped>;

  /// Draws and sends a picture of `height` rows, from the display's upper left corner. `draw(Band&,
  /// DepthBuffer&)` draws each band and returns a Status; the first that is not kOk ends the picture and is
  /// returned. No band is being sent when this returns.
  template <class Display, class Draw>
  Status show(Display& tft, std::int32_t height, Draw&& draw) {
    Status status = Status::kOk;
    bool is_sending = false;
    for (std::int32_t top = 0; top < height && ok(status); top += Rows) {
      Band band(pixels_[next_], Width, Rows, top);
      DepthBuffer depth(depths_, Width, Rows, top);
      status = draw(band, depth);
      if (is_sending) finish_band(tft);
      is_sending = ok(status);
      if (is_sending)
        send_band(tft, 0, top, Width, height - top < Rows ? height - top : Rows, pixels_[next_]);
      next_ ^= 1;
    }
    if (is_sending) finish_band(tft);
    return status;
  }

 private:
  std::uint16_t pixels_[2][Width * Rows];
  std::uint16_t depths_[Width * Rows];
  std::uint8_t next_ = 0;
};

}  // namespace arcspan
