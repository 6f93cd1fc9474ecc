// SPDX-License-Identifier: MIT
#include <arcspan/hal/spi_bus.hpp>

namespace arcspan::hal {

Status SpiBus::write(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return Status::kInvalidArgument;
  if (under_way_) return Status::kBusy;
  return do_write(bytes);
}

Status SpiBus::start(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return Status::kInvalidArgument;
  if (under_way_) return Status::kBusy;
  const Status status = do_start(bytes);
  under_way_ = ok(status);
  return status;
}

Status SpiBus::poll() {
  if (!under_way_) return Status::kOk;
  const Status status = do_poll();
  under_way_ = status == Status::kBusy;
  return status;
}

Status SpiBus::wait(Clock& clock, std::uint32_t limit_us) {
  if (limit_us > INT32_MAX) return Status::kInvalidArgument;
  const std::uint32_t begin = clock.now_us();
  Status status = poll();
  while (status == Status::kBusy) {
    // The unsigned difference is right even if the counter wraps while waiting.
    const std::uint32_t passed = clock.now_us() - begin;
    if (passed >= limit_us) {
      do_abort();
      under_way_ = false;
      return Status::kTimeout;
    }
    do_pause(clock, limit_us - passed);
    status = poll();
  }
  return status;
}

}  // namespace arcspan::hal
