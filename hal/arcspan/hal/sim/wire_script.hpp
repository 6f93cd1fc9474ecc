// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/output_pin.hpp>
#include <arcspan/status.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::hal::sim {

/// One thing that a driver does to its wires, and what the wires answer.
///
/// As a line of a script, bytes in hexadecimal:
///   command 2a                  bytes on SPI with D/C low
///   data 00 00 00 ef            bytes on SPI with D/C high
///   data f8 00 x240             the bytes before the last word, 240 times
///   i2c 3c 00 ae                a transaction: the address, then its bytes
///   reset low                   an output pin, by its name
///   read busy high              an input pin, and the level that it gives
///   wait 120 ms                 a delay; us or ms
///   command 2c = transfer short what the driver is told, if it is not "ok": a to_string(Status)
/// Bytes in succession with the same D/C level, and delays in succession, are one: how a driver cuts its
/// transfers does not matter. The line of D/C is in the bytes; `dc low = transfer failed` is a line of its
/// own.
struct WireEvent {
  enum class Kind : std::uint8_t { kSpi, kI2c, kSet, kRead, kDelay };
  Kind kind = Kind::kDelay;
  Level level = Level::kLow;        ///< D/C of kSpi; of kSet and kRead the wire's
  std::string pin;                  ///< kSet, kRead
  std::uint8_t address = 0;         ///< kI2c
  std::vector<std::uint8_t> bytes;  ///< kSpi, kI2c
  std::uint64_t us = 0;             ///< kDelay
  Status answer = Status::kOk;
  int line = 0;  ///< of the script, from 1
};

/// The name of the D/C pin in scripts.
inline constexpr std::string_view kDataOrCommand = "dc";

/// A script that was read.
struct WireScript {
  std::vector<WireEvent> events;
  std::string error;  ///< "" or "line 3: not a byte: 'zz'": what could not be read, and `events` ends there
};

/// Reads a script; empty lines and what follows a # do not count.
[[nodiscard]] WireScript parse_wire_script(std::string_view text);

/// The event as one line of a script, without a line break. Long runs of bytes are written as `x` many.
[[nodiscard]] std::string to_string(const WireEvent& event);

/// The same as a script, longer ones over several lines. What parse_wire_script makes of it is equal but for
/// where bytes are cut.
[[nodiscard]] std::string to_script(const std::vector<WireEvent>& events);

}  // namespace arcspan::hal::sim
