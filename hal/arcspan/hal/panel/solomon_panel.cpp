// SPDX-License-Identifier: MIT
#include <arcspan/hal/panel/solomon_panel.hpp>

namespace arcspan::hal {
namespace {

constexpr std::uint8_t kNop = 0xE3;
constexpr std::uint8_t kDisplayOff = 0xAE;

}  // namespace

Status SolomonPanel::end_command() {
  constexpr std::uint8_t kNops[] = {kNop, kNop};
  return send(kNops);
}

Status SolomonPanel::reset() {
  // SSD1306 rev 1.1, 8.9: reset is low for at least 3 us, and nothing is sent for 3 us after it. The same
  // times are assumed for the SSD0323, whose datasheet was not available.
  constexpr std::uint32_t kResetUs = 10;
  if (reset_ != nullptr) {
    Status status = reset_->set(Level::kLow);
    clock().delay_us(kResetUs);
    if (ok(status)) status = reset_->set(Level::kHigh);
    clock().delay_us(kResetUs);
    if (!ok(status)) return status;
  }
  const Status status = end_command();
  constexpr std::uint8_t kOff[] = {kDisplayOff};
  return ok(status) ? send(kOff) : status;
}

Status SolomonPanel::send_sleep() {
  constexpr std::uint8_t kOff[] = {kDisplayOff};
  return send(kOff);
}

}  // namespace arcspan::hal
