// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/output_pin.hpp>
#include <arcspan/status.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::hal::sim {

/// One action of a driver on its wires, and the answer of the wires.
///
/// A script has one event per line, with bytes in hexadecimal:
///   command 2a                  bytes on SPI with D/C low
///   data 00 00 00 ef            bytes on SPI with D/C high
///   data f8 00 x240             the bytes before the last word, 240 times
///   i2c 3c 00 ae                an I2C transaction: the address, then its bytes
///   reset low                   an output pin, by its name
///   read busy high              an input pin, and the level that it returns
///   wait 120 ms                 a delay in us or ms
///   command 2c = transfer short the answer, if it is not "ok": a to_string(Status)
/// Successive bytes with the same D/C level are one event, however the driver splits its transfers, and so
/// are successive delays. D/C has no events of its own, except to make it fail: `dc low = transfer failed`.
struct WireEvent {
  enum class Kind : std::uint8_t { kSpi, kI2c, kSet, kRead, kDelay };
  Kind kind = Kind::kDelay;
  Level level = Level::kLow;        ///< kSpi: of D/C; kSet, kRead: of the pin
  std::string pin;                  ///< kSet, kRead
  std::uint8_t address = 0;         ///< kI2c
  std::vector<std::uint8_t> bytes;  ///< kSpi, kI2c
  std::uint64_t us = 0;             ///< kDelay
  Status answer = Status::kOk;
  int line = 0;  ///< line number in the script, from 1
};

/// Name of the D/C pin in scripts.
inline constexpr std::string_view kDataOrCommand = "dc";

/// Result of parsing a script.
struct WireScript {
  std::vector<WireEvent> events;
  std::string error;  ///< "", or why `events` ends early, such as "line 3: not a byte: 'zz'"
};

/// Parses a script. Empty lines and text after a # are ignored.
[[nodiscard]] WireScript parse_wire_script(std::string_view text);

/// `event` as one line of a script without a line break. Repeated bytes are written as "xN".
[[nodiscard]] std::string to_string(const WireEvent& event);

/// `events` as a script, long ones on several lines. Parsing it returns equal events, except that bytes may
/// be split differently.
[[nodiscard]] std::string to_script(const std::vector<WireEvent>& events);

}  // namespace arcspan::hal::sim
