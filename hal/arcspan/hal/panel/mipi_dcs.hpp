// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>

/// The commands of the MIPI display command set that ILI9341 and ST7789 share, by the names of their
/// datasheets in brackets.
namespace arcspan::hal::dcs {

/// A command with its parameters, ready for CommandPort::command.
struct Command {
  std::uint8_t opcode = 0;
  std::uint8_t count = 0;  ///< valid bytes of `bytes`, 0 ... 4
  std::array<std::uint8_t, 4> bytes{};

  [[nodiscard]] constexpr std::span<const std::uint8_t> parameters() const { return {bytes.data(), count}; }
};

/// Pixels that follow go to the window, from its first row and column on (RAMWR).
inline constexpr Command kMemoryWrite{0x2C};
inline constexpr Command kSoftwareReset{0x01};  ///< (SWRESET)
inline constexpr Command kSleepIn{0x10};        ///< (SLPIN)
inline constexpr Command kSleepOut{0x11};       ///< (SLPOUT)
inline constexpr Command kNormalMode{0x13};     ///< the whole memory, no scrolling (NORON)
inline constexpr Command kDisplayOff{0x28};     ///< (DISPOFF)
inline constexpr Command kDisplayOn{0x29};      ///< (DISPON)
/// 16 bits a pixel, red in the high bits, high byte first (COLMOD).
inline constexpr Command kPixelFormatRgb565{0x3A, 1, {0x55}};

/// Shows every colour as its complement, or as it is (INVON, INVOFF).
[[nodiscard]] constexpr Command inversion(bool on) { return {static_cast<std::uint8_t>(on ? 0x21 : 0x20)}; }

namespace detail {
[[nodiscard]] constexpr Command range(std::uint8_t opcode, std::uint16_t first, std::uint16_t last) {
  return {opcode,
          4,
          {static_cast<std::uint8_t>(first >> 8), static_cast<std::uint8_t>(first & 0xFF),
           static_cast<std::uint8_t>(last >> 8), static_cast<std::uint8_t>(last & 0xFF)}};
}
}  // namespace detail

/// The window's columns first ... last, both inside it (CASET). The controller wants first <= last.
[[nodiscard]] constexpr Command columns(std::uint16_t first, std::uint16_t last) {
  return detail::range(0x2A, first, last);
}

/// The window's rows first ... last, both inside it (PASET, RASET). The controller wants first <= last.
[[nodiscard]] constexpr Command rows(std::uint16_t first, std::uint16_t last) {
  return detail::range(0x2B, first, last);
}

/// How the controller's memory is read to the glass.
struct AddressMode {
  bool mirror_rows = false;     ///< MY
  bool mirror_columns = false;  ///< MX
  bool swap_axes = false;       ///< MV: rows of the window run along the memory's columns
  bool blue_first = false;      ///< BGR: the glass has its red and blue stripes exchanged
};

/// Memory access control (MADCTL).
[[nodiscard]] constexpr Command address_mode(const AddressMode& mode) {
  const int bits = (mode.mirror_rows ? 0x80 : 0) | (mode.mirror_columns ? 0x40 : 0) |
                   (mode.swap_axes ? 0x20 : 0) | (mode.blue_first ? 0x08 : 0);
  return {0x36, 1, {static_cast<std::uint8_t>(bits)}};
}

/// Brightness 0 ... 255 of a backlight that the controller dims (WRDISBV).
[[nodiscard]] constexpr Command brightness(std::uint8_t value) { return {0x51, 1, {value}}; }

/// Lets the brightness and the backlight output take effect: BCTRL and BL (WRCTRLD).
inline constexpr Command kBrightnessControlOn{0x53, 1, {0x24}};

}  // namespace arcspan::hal::dcs
