// SPDX-License-Identifier: MIT
// The functions of libgpiod that arcspan needs. Versions 1 and 2 share no function: backend_v1.cpp and
// backend_v2.cpp implement this for one version each, backend_none.cpp for systems without libgpiod. The
// build selects one.
#pragma once

#include <arcspan/linux_host/result.hpp>

namespace arcspan::linux_host::gpio {

/// A line that this process holds, as libgpiod's objects. Null pointers if none is held.
struct HeldLine {
  void* chip = nullptr;
  void* line = nullptr;  ///< version 1: the line; version 2: the request
  unsigned offset = 0;
};

/// Version of the linked libgpiod, e.g. "1.6.3"; "" if there is none.
[[nodiscard]] const char* version();

/// Finds the line `name` on the chip at `chip_path` and stores its `offset`. kIndexOutOfRange if the chip has
/// no such line; other statuses if the chip cannot be read.
Result find_line(const char* chip_path, const char* name, unsigned& offset);

/// Requests the line as an output at this level, without a glitch. kNotReady if the chip cannot be opened,
/// kIndexOutOfRange if it has no such line, kBusy if the line is in use.
Result request_output(const char* chip_path, unsigned offset, bool high, HeldLine& line);

/// Requests the line as an input and keeps its bias. Returns the statuses of request_output().
Result request_input(const char* chip_path, unsigned offset, HeldLine& line);

/// Sets the level of a held output.
Result set_value(const HeldLine& line, bool high);

/// Reads the level of a held line.
Result get_value(const HeldLine& line, bool& high);

/// Releases the line, if one is held, and clears `line`.
void release(HeldLine& line);

}  // namespace arcspan::linux_host::gpio
