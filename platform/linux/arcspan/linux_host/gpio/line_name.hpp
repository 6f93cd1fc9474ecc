// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/linux_host/result.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace arcspan::linux_host::gpio {

/// Address of a line: its chip and its number on the chip.
struct LineAddress {
  std::string chip_path;  ///< e.g. /dev/gpiochip0
  unsigned offset = 0;
  friend bool operator==(const LineAddress&, const LineAddress&) = default;
};

/// Parses `CHIP:OFFSET`, where CHIP is gpiochip0 or /dev/gpiochip0 and OFFSET is decimal, at most 65535.
/// Returns nothing for any other text, which is then the name of a line.
[[nodiscard]] std::optional<LineAddress> parse_line_address(std::string_view text);

/// Finds the line for `text`: a line address as above, or the name of a line on any chip of the system.
/// kIndexOutOfRange if no chip has such a line; kInvalidArgument if several have, or if `text` is empty.
Result find_line_address(const std::string& text, LineAddress& address);

}  // namespace arcspan::linux_host::gpio
