// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <array>
#include <cstdint>
#include <span>

/// Commands of the MIPI display command set that ILI9341 and ST7789 share. Names in brackets are the
/// datasheets'.
namespace arcspan::hal::dcs {

/// A command and its parameters for CommandPort::command.
struct Command {
  std::uint8_t opcode = 0;
  std::uint8_t count = 0;  ///< number of parameters, 0 ... 4
  std::array<std::uint8_t, 4> bytes{};

  [[nodiscard]] constexpr std::span<const std::uint8_t> parameters() const { return {bytes.data(), count}; }
};

/// The data bytes that follow are pixels of the window, from its first row and column on (RAMWR).
inline constexpr Command kMemoryWrite{0x2C};
inline constexpr Command kSoftwareReset{0x01};  ///< (SWRESET)
inline constexpr Command kSleepIn{0x10};        ///< (SLPIN)
inline constexpr Command kSleepOut{0x11};       ///< (SLPOUT)
inline constexpr Command kNormalMode{0x13};     ///< shows the whole memory without scrolling (NORON)
inline constexpr Command kDisplayOff{0x28};     ///< (DISPOFF)
inline constexpr Command kDisplayOn{0x29};      ///< (DISPON)
/// 16 bits per pixel, red in the high bits, high byte first (COLMOD). Pixels are packed by BigEndianRgb565.
inline constexpr Command kPixelFormatRgb565{0x3A, 1, {0x55}};

/// Complements every colour, or stops doing so (INVON, INVOFF).
[[nodiscard]] constexpr Command inversion(bool on) { return {static_cast<std::uint8_t>(on ? 0x21 : 0x20)}; }

namespace detail {
[[nodiscard]] constexpr Command range(std::uint8_t opcode, std::uint16_t first, std::uint16_t last) {
  return {opcode,
          4,
          {static_cast<std::uint8_t>(first >> 8), static_cast<std::uint8_t>(first & 0xFF),
           static_cast<std::uint8_t>(last >> 8), static_cast<std::uint8_t>(last & 0xFF)}};
}
}  // namespace detail

/// Sets the window's columns to first ... last, both included; first <= last (CASET).
[[nodiscard]] constexpr Command columns(std::uint16_t first, std::uint16_t last) {
  return detail::range(0x2A, first, last);
}

/// Sets the window's rows to first ... last, both included; first <= last (PASET, RASET).
[[nodiscard]] constexpr Command rows(std::uint16_t first, std::uint16_t last) {
  return detail::range(0x2B, first, last);
}

/// Mapping of the controller's memory to the glass.
struct AddressMode {
  bool mirror_rows = false;     ///< MY
  bool mirror_columns = false;  ///< MX
  bool swap_axes = false;       ///< MV: a row of the window is a column of the memory
  bool blue_first = false;      ///< BGR: the glass has red and blue exchanged
};

/// Sets the address mode (MADCTL).
[[nodiscard]] constexpr Command address_mode(const AddressMode& mode) {
  const int bits = (mode.mirror_rows ? 0x80 : 0) | (mode.mirror_columns ? 0x40 : 0) |
                   (mode.swap_axes ? 0x20 : 0) | (mode.blue_first ? 0x08 : 0);
  return {0x36, 1, {static_cast<std::uint8_t>(bits)}};
}

/// Sets the backlight brightness, 0 ... 255, if the controller drives the backlight (WRDISBV).
[[nodiscard]] constexpr Command brightness(std::uint8_t value) { return {0x51, 1, {value}}; }

/// Enables brightness control and the backlight output: BCTRL and BL (WRCTRLD).
inline constexpr Command kBrightnessControlOn{0x53, 1, {0x24}};

}  // namespace arcspan::hal::dcs
