// SPDX-License-Identifier: MIT
// Backend for libgpiod 1.x.
#include <arcspan/linux_host/gpio/backend.hpp>

#include <gpiod.h>

#include <cerrno>
#include <memory>

namespace arcspan::linux_host::gpio {
namespace {

constexpr const char* kConsumer = "arcspan";

using Chip = std::unique_ptr<gpiod_chip, decltype(&gpiod_chip_close)>;

Chip open_chip(const char* path) { return {gpiod_chip_open(path), &gpiod_chip_close}; }

Result no_chip() { return Result::from_errno("the GPIO chip cannot be opened", Status::kNotReady); }

/// Opens the chip and requests the line through `take`, which returns a negative value on failure.
template <class Take>
Result request(const char* chip_path, unsigned offset, Take&& take, HeldLine& held) {
  Chip chip = open_chip(chip_path);
  if (!chip) return no_chip();
  if (offset >= gpiod_chip_num_lines(chip.get())) {
    return Result::refused("the GPIO chip has no such line", Status::kIndexOutOfRange);
  }
  gpiod_line* line = gpiod_chip_get_line(chip.get(), offset);
  if (line == nullptr) return Result::from_errno("the GPIO line cannot be read");
  if (take(line) < 0) {
    return Result::from_errno("the GPIO line cannot be taken",
                              errno == EBUSY ? Status::kBusy : Status::kTransferFailed);
  }
  held = {chip.release(), line, offset};
  return {};
}

}  // namespace

const char* version() { return gpiod_version_string(); }

Result find_line(const char* chip_path, const char* name, unsigned& offset) {
  const Chip chip = open_chip(chip_path);
  if (!chip) return no_chip();
  gpiod_line* line = gpiod_chip_find_line(chip.get(), name);
  if (line == nullptr) {
    if (errno == ENOENT) return Result::refused("has no such line", Status::kIndexOutOfRange);
    return Result::from_errno("the GPIO chip's lines cannot be listed");
  }
  offset = gpiod_line_offset(line);
  return {};
}

Result request_output(const char* chip_path, unsigned offset, bool high, HeldLine& held) {
  return request(
      chip_path, offset,
      [high](gpiod_line* line) { return gpiod_line_request_output(line, kConsumer, high ? 1 : 0); }, held);
}

Result request_input(const char* chip_path, unsigned offset, HeldLine& held) {
  return request(
      chip_path, offset, [](gpiod_line* line) { return gpiod_line_request_input(line, kConsumer); }, held);
}

Result set_value(const HeldLine& held, bool high) {
  if (held.line == nullptr) return Result::refused("the GPIO line is not held", Status::kNotReady);
  if (gpiod_line_set_value(static_cast<gpiod_line*>(held.line), high ? 1 : 0) < 0) {
    return Result::from_errno("the GPIO line cannot be set");
  }
  return {};
}

Result get_value(const HeldLine& held, bool& high) {
  if (held.line == nullptr) return Result::refused("the GPIO line is not held", Status::kNotReady);
  const int value = gpiod_line_get_value(static_cast<gpiod_line*>(held.line));
  if (value < 0) return Result::from_errno("the GPIO line cannot be read");
  high = value != 0;
  return {};
}

void release(HeldLine& held) {
  // Closing the chip releases its lines.
  if (held.chip != nullptr) gpiod_chip_close(static_cast<gpiod_chip*>(held.chip));
  held = {};
}

}  // namespace arcspan::linux_host::gpio
