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

Status Panel::note(Status status) {
  // A refusal before anything was sent leaves the controller as it was.
  if (!ok(status) && status != Status::kBusy) in_doubt_ = true;
  return status;
}

Status Panel::restore() {
  if (!in_doubt_) return Status::kOk;
  const Status status = do_configure();
  if (ok(status)) in_doubt_ = false;
  return status;
}

Status Panel::start() {
  if (!valid(settings_) || !do_fits()) return Status::kInvalidArgument;
  (void)finish();  // what an interrupted frame left
  state_ = State::kUnknown;
  Status status = do_reset();
  if (ok(status)) status = do_configure();
  if (!ok(status)) return status;
  state_ = State::kAwake;
  in_doubt_ = false;
  return status;
}

Status Panel::sleep() {
  if (state_ == State::kUnknown) return Status::kNotReady;
  Status status = finish();
  if (ok(status)) status = restore();
  if (ok(status)) status = do_sleep();
  // After a failure it may be either; asleep is what wake() recovers from.
  state_ = State::kAsleep;
  return note(status);
}

Status Panel::wake() {
  if (state_ == State::kUnknown) return Status::kNotReady;
  Status status = finish();
  if (ok(status)) status = do_wake();
  if (ok(status)) status = do_configure();
  if (ok(status)) {
    state_ = State::kAwake;
    in_doubt_ = false;
  }
  return note(status);
}

Status Panel::set(const PanelSettings& settings) {
  if (!valid(settings)) return Status::kInvalidArgument;
  Status status = finish();
  settings_ = settings;
  if (state_ != State::kAwake) return status;
  if (ok(status)) status = do_configure();
  return note(status);
}

Status Panel::start_write(const Rect& area, std::span<const std::uint8_t> wire) {
  if (state_ != State::kAwake) return Status::kNotReady;
  if (!inside(area, bounds()) || !do_takes(area, wire.size())) return Status::kInvalidArgument;
  Status status = restore();
  if (ok(status)) status = do_open_window(area);
  if (ok(status)) status = do_start_pixels(wire);
  return note(status);
}

Status Panel::finish() { return note(do_wait(settings_.transfer_limit_us)); }

}  // namespace arcspan::hal
