// SPDX-License-Identifier: MIT
#include <arcspan/hal/panel/command_port.hpp>

namespace arcspan::hal {

Status CommandPort::command(std::uint8_t opcode, std::span<const std::uint8_t> parameters) {
  Status status = select(Level::kLow);
  if (ok(status)) status = bus_.write({&opcode, 1});
  if (!ok(status) || parameters.empty()) return status;
  return data(parameters);
}

Status CommandPort::data(std::span<const std::uint8_t> bytes) {
  const Status status = select(Level::kHigh);
  return ok(status) ? bus_.write(bytes) : status;
}

Status CommandPort::start_data(std::span<const std::uint8_t> bytes) {
  const Status status = select(Level::kHigh);
  return ok(status) ? bus_.start(bytes) : status;
}

Status CommandPort::select(Level level) { return bus_.under_way() ? Status::kBusy : dc_.set(level); }

}  // namespace arcspan::hal
