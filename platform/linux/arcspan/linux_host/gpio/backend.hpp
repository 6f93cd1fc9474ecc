// SPDX-License-Identifier: MIT
// The few things that are wanted of libgpiod. Versions 1 and 2 have no function in common: backend_v1.cpp and
// backend_v2.cpp implement this for one each, backend_none.cpp for a system without; the build takes one.
#pragma once

#include <arcspan/linux_host/result.hpp>

namespace arcspan::linux_host::gpio {

/// A line that is held; null pointers for none. The library's own objects behind them.
struct HeldLine {
  void* chip = nullptr;
  void* line = nullptr;  ///< version 1: the line; version 2: the request
  unsigned offset = 0;
};

/// The version of libgpiod that is linked, e.g. "1.6.3"; "" for none.
[[nodiscard]] const char* version();

/// Looks for the line `name` on the chip at the device `chip_path`. kOk and its `offset`, or kIndexOutOfRange
/// if the chip has none of that name; other statuses if the chip cannot be asked.
Result find_line(const char* chip_path, const char* name, unsigned& offset);

/// Takes the line and drives it, without a glitch to the other level in between. kNotReady if the chip cannot
/// be opened, kIndexOutOfRange if it has no such line, kBusy if somebody else holds it.
Result request_output(const char* chip_path, unsigned offset, bool high, HeldLine& line);

/// Takes the line as an input; its bias stays as it is. Statuses as request_output.
Result request_input(const char* chip_path, unsigned offset, HeldLine& line);

/// Drives an output that is held.
Result set_value(const HeldLine& line, bool high);

/// Reads the level of a line that is held.
Result get_value(const HeldLine& line, bool& high);

/// Gives the line back to the kernel and empties `line`, which may be empty already.
void release(HeldLine& line);

}  // namespace arcspan::linux_host::gpio
