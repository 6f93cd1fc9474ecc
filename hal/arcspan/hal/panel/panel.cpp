// SPDX-License-Identifier: MIT
#include <arcspan/hal/panel/panel.hpp>

namespace arcspan::hal {
namespace {

bool valid(const PanelSettings& s) {
  return is_orientation(s.orientation) && s.transfer_limit_us >= 1 && s.transfer_limit_us <= INT32_MAX;
}

bool inside(const Rect& area, const Rect& bounds) {
  return !area.empty() && area.left >= bounds.left && area.top >= bounds.top && area.right <= bounds.right &&
         area.bottom <= bounds.bottom;
}

}  // namespace

Status Panel::remember_failure(Status status) {
  // kBusy is returned before anything is sent, so the controller is unchanged.
  if (!ok(status) && status != Status::kBusy) needs_configuration_ = true;
  return status;
}

Status Panel::configure_if_needed() {
  if (!needs_configuration_) return Status::kOk;
  const Status status = do_configure();
  if (ok(status)) needs_configuration_ = false;
  return status;
}

Status Panel::start() {
  if (!valid(settings_) || !do_fits()) return Status::kInvalidArgument;
  (void)finish();  // ends the transfer of an interrupted frame
  state_ = State::kUnknown;
  Status status = do_reset();
  if (ok(status)) status = do_configure();
  if (!ok(status)) return status;
  state_ = State::kAwake;
  needs_configuration_ = false;
  return status;
}

Status Panel::sleep() {
  if (state_ == State::kUnknown) return Status::kNotReady;
  Status status = finish();
  if (ok(status)) status = configure_if_needed();
  if (ok(status)) status = do_sleep();
  // After a failure the controller may be awake or asleep. wake() recovers from both.
  state_ = State::kAsleep;
  return remember_failure(status);
}

Status Panel::wake() {
  if (state_ == State::kUnknown) return Status::kNotReady;
  Status status = finish();
  if (ok(status)) status = do_wake();
  if (ok(status)) status = do_configure();
  if (ok(status)) {
    state_ = State::kAwake;
    needs_configuration_ = false;
  }
  return remember_failure(status);
}

Status Panel::set(const PanelSettings& settings) {
  if (!valid(settings)) return Status::kInvalidArgument;
  Status status = finish();
  settings_ = settings;
  if (state_ != State::kAwake) return status;
  needs_configuration_ = true;
  return ok(status) ? configure_if_needed() : status;
}

Status Panel::start_write(const Rect& area, std::span<const std::uint8_t> wire) {
  if (state_ != State::kAwake) return Status::kNotReady;
  if (!inside(area, bounds()) || !do_takes(area, wire.size())) return Status::kInvalidArgument;
  Status status = configure_if_needed();
  if (ok(status)) status = do_open_window(area);
  if (ok(status)) status = do_start_pixels(wire);
  return remember_failure(status);
}

Status Panel::finish() { return remember_failure(do_wait(settings_.transfer_limit_us)); }

}  // namespace arcspan::hal
