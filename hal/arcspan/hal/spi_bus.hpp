// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/clock.hpp>
#include <arcspan/status.hpp>

#include <cstdint>
#include <span>

namespace arcspan::hal {

/// One device on an SPI bus, write-only: clock rate, mode and chip select are the bus's own affair.
///
/// A transfer is either blocking (`write`) or runs by itself (`start`, then `poll` or `wait`), so that the
/// next band can be drawn while one is sent. At most one transfer is under way; while it is, `write` and
/// `start` refuse with kBusy and leave it alone. A bus that only implements `do_write` is complete: its
/// transfers are over when `start` returns.
///
/// A transfer's result is told once: by `write`, by a `start` that fails, or by the first `poll` or `wait`
/// that does not say kBusy. Not for interrupt handlers, not for two threads at once.
class SpiBus {
 public:
  /// Microseconds between two looks at a transfer in `wait`.
  static constexpr std::uint32_t kPollIntervalUs = 10;

  /// Sends `bytes` and returns when the last bit is on the wire. kInvalidArgument if `bytes` is empty, kBusy
  /// if a transfer is under way, kTransferFailed if the bus reported an error, kTransferShort if it took
  /// fewer bytes. After an error, it is unknown how many bytes the device has seen.
  Status write(std::span<const std::uint8_t> bytes);

  /// Begins to send `bytes`, which must stay unchanged until the transfer is over. Does not wait for it.
  /// Statuses as `write`; after one that is not kOk no transfer is under way that was not before.
  Status start(std::span<const std::uint8_t> bytes);

  /// kBusy while the transfer is under way; otherwise its result, and kOk if none was started. Never blocks.
  Status poll();

  /// Blocks until the transfer is over and returns its result, as `poll`. If it lasts longer than `limit_us`
  /// (0 ... 2^31 - 1, else kInvalidArgument and nothing is waited for) it is given up: kTimeout, and the bus
  /// is free again. `clock` must run, or a transfer that hangs is waited for without end.
  Status wait(Clock& clock, std::uint32_t limit_us);

  /// Whether a transfer was started whose result has not been told.
  [[nodiscard]] bool under_way() const { return under_way_; }

 protected:
  ~SpiBus() = default;

 private:
  /// Sends `bytes`, at least one, and blocks until they are sent. No transfer is under way.
  virtual Status do_write(std::span<const std::uint8_t> bytes) = 0;
  /// Begins to send `bytes`, at least one; kOk promises that `do_poll` will tell the result.
  virtual Status do_start(std::span<const std::uint8_t> bytes) { return do_write(bytes); }
  /// kBusy, or the result of the transfer that `do_start` began.
  virtual Status do_poll() { return Status::kOk; }
  /// Ends the transfer at once; `bytes` is not read after this returns.
  virtual void do_abort() {}

  bool under_way_ = false;
};

}  // namespace arcspan::hal
