// SPDX-License-Identifier: MIT
#include <arcspan/hal/sim/simulated_bus.hpp>

#include <algorithm>

namespace arcspan::hal::sim {

Status status_of(Fault::Kind kind) {
  switch (kind) {
    case Fault::Kind::kFailed:
      return Status::kTransferFailed;
    case Fault::Kind::kShort:
      return Status::kTransferShort;
    case Fault::Kind::kStuck:
      break;
  }
  return Status::kTimeout;
}

Status SimulatedSpi::Line::do_set(Level level) {
  if (fails_at_ && (*fails_at_)-- == 0) {
    fails_at_.reset();
    return Status::kTransferFailed;
  }
  level_ = level;
  if (resets_) bus_.device_.reset_line(level, bus_.clock_.now_ns());
  return Status::kOk;
}

bool SimulatedSpi::Line::cancel_fault() {
  const bool waiting = fails_at_.has_value();
  fails_at_.reset();
  return waiting;
}

Status SimulatedSpi::Busy::do_read(Level& level) {
  if (fails_) {
    fails_ = false;
    return Status::kTransferFailed;
  }
  level = stuck_ || is_busy(clock_.now_ns()) ? Level::kHigh : Level::kLow;
  return Status::kOk;
}

bool SimulatedSpi::cancel_fault() {
  const bool waiting = fault_.has_value();
  fault_.reset();
  return waiting;
}

std::uint64_t SimulatedSpi::duration_ns(std::size_t bytes) const {
  return bytes * std::uint64_t{8'000'000'000} / hertz_;
}

void SimulatedSpi::begin(std::span<const std::uint8_t> bytes) {
  source_ = bytes;
  sent_.assign(bytes.begin(), bytes.end());
  dc_at_begin_ = dc.level();
  begin_ns_ = clock_.now_ns();
  if (busy.is_busy(begin_ns_)) complaints_.push_back("bytes for a device that is busy");
  strikes_.reset();
  ++count_.transfers;
  if (fault_ && fault_->at_byte < offered_ + bytes.size()) {
    strikes_ = fault_->kind;
    sent_.resize(static_cast<std::size_t>(fault_->at_byte - offered_));
    fault_.reset();
  }
  offered_ += bytes.size();
}

Status SimulatedSpi::deliver() {
  if (!std::equal(sent_.begin(), sent_.end(), source_.begin())) {
    complaints_.push_back("bytes were changed while they were sent");
  }
  if (dc.level() != dc_at_begin_) complaints_.push_back("D/C was changed while bytes were sent");
  std::size_t sent = 0;
  for (const std::uint8_t byte : sent_) device_.receive(byte, dc_at_begin_, begin_ns_ + duration_ns(++sent));
  count_.bytes += sent_.size();
  count_.busy_ns += duration_ns(sent_.size());
  busy.until_ns_ = begin_ns_ + duration_ns(sent_.size()) + busy.time_ns_;
  source_ = {};
  return strikes_ ? status_of(*strikes_) : Status::kOk;
}

Status SimulatedSpi::do_write(std::span<const std::uint8_t> bytes) {
  begin(bytes);
  clock_.advance_ns(duration_ns(sent_.size()));
  return deliver();
}

Status SimulatedSpi::do_start(std::span<const std::uint8_t> bytes) {
  begin(bytes);
  return Status::kOk;
}

Status SimulatedSpi::do_poll() {
  if (strikes_ == Fault::Kind::kStuck) return Status::kBusy;
  if (clock_.now_ns() < begin_ns_ + duration_ns(sent_.size())) return Status::kBusy;
  return deliver();
}

void SimulatedSpi::do_abort() {
  // Bytes sent before the abort have arrived.
  const std::uint64_t elapsed = clock_.now_ns() - begin_ns_;
  const std::uint64_t bytes = elapsed * hertz_ / 8'000'000'000;
  if (bytes < sent_.size()) sent_.resize(static_cast<std::size_t>(bytes));
  (void)deliver();
}

bool SimulatedI2c::cancel_fault() {
  const bool waiting = fault_.has_value();
  fault_.reset();
  return waiting;
}

Status SimulatedI2c::do_write(std::uint8_t address, std::span<const std::uint8_t> bytes) {
  ++count_.transfers;
  if (address != address_) return Status::kTransferFailed;
  std::size_t arrive = bytes.size();
  Status status = Status::kOk;
  if (fault_ && fault_->at_byte < offered_ + bytes.size()) {
    arrive = static_cast<std::size_t>(fault_->at_byte - offered_);
    status = status_of(fault_->kind);
    fault_.reset();
  }
  offered_ += bytes.size();
  const std::uint64_t ns = (9 * (arrive + 1) + 2) * std::uint64_t{1'000'000'000} / hertz_;
  clock_.advance_ns(ns + (status == Status::kTimeout ? 25'000'000 : 0));
  count_.bytes += arrive + 1;
  count_.busy_ns += ns;
  if (arrive > 0 && bytes[0] != 0x00 && bytes[0] != 0x40) {
    complaints_.push_back("control byte " + hex(bytes[0]));
    return status;
  }
  for (std::size_t i = 1; i < arrive; ++i) {
    device_.receive(bytes[i], bytes[0] == 0x00 ? Level::kLow : Level::kHigh, clock_.now_ns());
  }
  return status;
}

}  // namespace arcspan::hal::sim
