// SPDX-License-Identifier: MIT
#include <arcspan/hal/panel/solomon_port.hpp>

namespace arcspan::hal {

Status SolomonSpi::do_command(std::span<const std::uint8_t> bytes) {
  if (bus_.under_way()) return Status::kBusy;
  const Status status = dc_.set(Level::kLow);
  return ok(status) ? bus_.write(bytes) : status;
}

Status SolomonSpi::do_start_pixels(std::span<const std::uint8_t> bytes) {
  if (bus_.under_way()) return Status::kBusy;
  const Status status = dc_.set(Level::kHigh);
  return ok(status) ? bus_.start(bytes) : status;
}

Status SolomonI2c::send(std::uint8_t control, std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return Status::kInvalidArgument;
  std::uint8_t transaction[1 + kBytesAtOnce];
  transaction[0] = control;
  while (!bytes.empty()) {
    const std::size_t count = bytes.size() < kBytesAtOnce ? bytes.size() : kBytesAtOnce;
    for (std::size_t i = 0; i < count; ++i) transaction[1 + i] = bytes[i];
    const Status status = bus_.write(address_, {transaction, 1 + count});
    if (!ok(status)) return status;
    bytes = bytes.subspan(count);
  }
  return Status::kOk;
}

}  // namespace arcspan::hal
