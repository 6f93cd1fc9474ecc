// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/clock.hpp>
#include <arcspan/status.hpp>

#include <cstdint>
#include <span>

namespace arcspan::hal {

/// A write-only SPI bus with one device. Board code derives from it and owns clock rate, mode and chip
/// select.
///
/// A transfer either blocks (`write`) or runs in the background (`start`, then `poll` or `wait`), so that the
/// next band can be drawn meanwhile. At most one is under way; during it `write` and `start` return kBusy and
/// change nothing. A class that implements only `do_write` is complete: its transfers end before `start`
/// returns.
///
/// The result of a transfer is reported once: by `write`, by a `start` that fails, or by the first `poll` or
/// `wait` that does not return kBusy. Not for interrupt handlers or concurrent threads.
class SpiBus {
 public:
  /// Microseconds between two polls in `wait`, unless the board blocks the task instead (`do_pause`).
  static constexpr std::uint32_t kPollIntervalUs = 10;

  /// Sends `bytes` and returns after the last bit. After a failure it is unknown how many bytes the device
  /// received.
  ///
  /// - kInvalidArgument: `bytes` is empty
  /// - kBusy: a transfer is under way
  /// - kTransferFailed: the bus reported an error
  /// - kTransferShort: the bus accepted fewer bytes
  Status write(std::span<const std::uint8_t> bytes);

  /// Begins to send `bytes`, which the caller keeps unchanged until the result is reported. Does not block.
  /// Returns the statuses of `write`; unless it is kOk, no transfer was started.
  Status start(std::span<const std::uint8_t> bytes);

  /// kBusy while the transfer is under way, then its result once, and kOk if there is none. Never blocks.
  Status poll();

  /// Blocks until the transfer ends and returns its result. After `limit_us` (0 ... 2^31 - 1) it aborts the
  /// transfer, frees the bus and returns kTimeout. kInvalidArgument, without waiting, for a larger limit.
  /// `clock` must be running, or a stuck transfer blocks forever.
  Status wait(Clock& clock, std::uint32_t limit_us);

  /// Whether a transfer was started whose result has not been reported.
  [[nodiscard]] bool under_way() const { return under_way_; }

 protected:
  ~SpiBus() = default;

 private:
  /// Sends `bytes`, which is not empty, and blocks until they are sent. No transfer is under way.
  virtual Status do_write(std::span<const std::uint8_t> bytes) = 0;
  /// Begins to send `bytes`, which is not empty. After kOk, `do_poll` reports the result.
  virtual Status do_start(std::span<const std::uint8_t> bytes) { return do_write(bytes); }
  /// kBusy, or the result of the transfer that `do_start` began.
  virtual Status do_poll() { return Status::kOk; }
  /// Called by `wait` between two polls: gives the processor away until the transfer may have ended, for
  /// `left_us` microseconds at most, 1 ... 2^31 - 1. An operating system waits here for a semaphore that the
  /// interrupt at the end of the transfer gives; returning early is harmless.
  virtual void do_pause(Clock& clock, std::uint32_t left_us) {
    (void)left_us;
    clock.delay_us(kPollIntervalUs);
  }
  /// Aborts the transfer. `bytes` is not read after this returns.
  virtual void do_abort() {}

  bool under_way_ = false;
};

}  // namespace arcspan::hal
