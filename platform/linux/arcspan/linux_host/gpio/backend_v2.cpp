// SPDX-License-Identifier: MIT
// Backend for libgpiod 2.x.
#include <arcspan/linux_host/gpio/backend.hpp>

#include <gpiod.h>

#include <cerrno>
#include <memory>

namespace arcspan::linux_host::gpio {
namespace {

template <class T>
using Owned = std::unique_ptr<T, void (*)(T*)>;

Owned<gpiod_chip> open_chip(const char* path) { return {gpiod_chip_open(path), &gpiod_chip_close}; }

Result no_chip() { return Result::from_errno("the GPIO chip cannot be opened", Status::kNotReady); }

gpiod_line_value value_of(bool high) { return high ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE; }

Result refused_line() {
  switch (errno) {
    case EBUSY:
      return Result::from_errno("the GPIO line cannot be taken", Status::kBusy);
    case EINVAL:
      return Result::refused("the GPIO chip has no such line", Status::kIndexOutOfRange);
    default:
      return Result::from_errno("the GPIO line cannot be taken");
  }
}

/// Opens the chip and requests the line with the settings of `describe`, which returns false on failure.
template <class Describe>
Result request(const char* chip_path, unsigned offset, Describe&& describe, HeldLine& held) {
  const Owned<gpiod_chip> chip = open_chip(chip_path);
  if (!chip) return no_chip();
  const Owned<gpiod_line_settings> settings(gpiod_line_settings_new(), &gpiod_line_settings_free);
  const Owned<gpiod_line_config> config(gpiod_line_config_new(), &gpiod_line_config_free);
  const Owned<gpiod_request_config> request(gpiod_request_config_new(), &gpiod_request_config_free);
  if (!settings || !config || !request || !describe(settings.get()) ||
      gpiod_line_config_add_line_settings(config.get(), &offset, 1, settings.get()) != 0) {
    return Result::from_errno("the GPIO line cannot be described");
  }
  gpiod_request_config_set_consumer(request.get(), "arcspan");
  gpiod_line_request* line = gpiod_chip_request_lines(chip.get(), request.get(), config.get());
  if (line == nullptr) return refused_line();
  // The request remains valid after the chip is closed.
  held = {nullptr, line, offset};
  return {};
}

}  // namespace

const char* version() { return gpiod_api_version(); }

Result find_line(const char* chip_path, const char* name, unsigned& offset) {
  const Owned<gpiod_chip> chip = open_chip(chip_path);
  if (!chip) return no_chip();
  const int found = gpiod_chip_get_line_offset_from_name(chip.get(), name);
  if (found < 0) {
    if (errno == ENOENT) return Result::refused("has no such line", Status::kIndexOutOfRange);
    return Result::from_errno("the GPIO chip's lines cannot be listed");
  }
  offset = static_cast<unsigned>(found);
  return {};
}

Result request_output(const char* chip_path, unsigned offset, bool high, HeldLine& held) {
  return request(
      chip_path, offset,
      [high](gpiod_line_settings* settings) {
        return gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_OUTPUT) == 0 &&
               gpiod_line_settings_set_output_value(settings, value_of(high)) == 0;
      },
      held);
}

Result request_input(const char* chip_path, unsigned offset, HeldLine& held) {
  return request(
      chip_path, offset,
      [](gpiod_line_settings* settings) {
        return gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_INPUT) == 0;
      },
      held);
}

Result set_value(const HeldLine& held, bool high) {
  if (held.line == nullptr) return Result::refused("the GPIO line is not held", Status::kNotReady);
  if (gpiod_line_request_set_value(static_cast<gpiod_line_request*>(held.line), held.offset, value_of(high)) <
      0) {
    return Result::from_errno("the GPIO line cannot be set");
  }
  return {};
}

Result get_value(const HeldLine& held, bool& high) {
  if (held.line == nullptr) return Result::refused("the GPIO line is not held", Status::kNotReady);
  const gpiod_line_value value =
      gpiod_line_request_get_value(static_cast<gpiod_line_request*>(held.line), held.offset);
  if (value == GPIOD_LINE_VALUE_ERROR) return Result::from_errno("the GPIO line cannot be read");
  high = value == GPIOD_LINE_VALUE_ACTIVE;
  return {};
}

void release(HeldLine& held) {
  if (held.line != nullptr) gpiod_line_request_release(static_cast<gpiod_line_request*>(held.line));
  held = {};
}

}  // namespace arcspan::linux_host::gpio
