// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/linux_host/result.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace arcspan::linux_host::gpio {

/// A line by its chip and its number there.
struct LineAddress {
  std::string chip_path;  ///< e.g. /dev/gpiochip0
  unsigned offset = 0;
  friend bool operator==(const LineAddress&, const LineAddress&) = default;
};

/// Reads `CHIP:OFFSET`, CHIP being gpiochip0 or /dev/gpiochip0 and OFFSET decimal, at most 65535. Nothing if
/// `text` has another form; it is then the name of a line.
[[nodiscard]] std::optional<LineAddress> parse_line_address(std::string_view text);

/// The line that `text` means: an address as above, or a line's name, looked for on all chips of the system.
/// kIndexOutOfRange if no chip has a line of that name; kInvalidArgument if several have, or for an empty
/// name.
Result find_line_address(const std::string& text, LineAddress& address);

}  // namespace arcspan::linux_host::gpio
