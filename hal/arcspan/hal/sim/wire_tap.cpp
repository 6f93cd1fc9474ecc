// SPDX-License-Identifier: MIT
#include <arcspan/hal/sim/wire_tap.hpp>

namespace arcspan::hal::sim {

using Kind = WireEvent::Kind;

OutputPin& WireTap::output(const std::string& name) {
  return outputs_.try_emplace(name, *this, name).first->second;
}

InputPin& WireTap::input(const std::string& name) {
  return inputs_.try_emplace(name, *this, name).first->second;
}

Status WireTap::Spi::do_write(std::span<const std::uint8_t> bytes) {
  WireEvent event;
  event.kind = Kind::kSpi;
  event.level = tap.dc_;
  event.bytes.assign(bytes.begin(), bytes.end());
  event.answer = attached != nullptr ? attached->write(bytes) : Status::kOk;
  return tap.on(event);
}

Status WireTap::I2c::do_write(std::uint8_t address, std::span<const std::uint8_t> bytes) {
  WireEvent event;
  event.kind = Kind::kI2c;
  event.address = address;
  event.bytes.assign(bytes.begin(), bytes.end());
  event.answer = attached != nullptr ? attached->write(address, bytes) : Status::kOk;
  return tap.on(event);
}

Status WireTap::Output::do_set(Level to) {
  WireEvent event;
  event.kind = Kind::kSet;
  event.pin = name;
  event.level = to;
  event.answer = attached != nullptr ? attached->set(to) : Status::kOk;
  const Status status = tap.on(event);
  if (ok(status) && name == kDataOrCommand) tap.dc_ = to;
  return status;
}

Status WireTap::Input::do_read(Level& level) {
  WireEvent event;
  event.kind = Kind::kRead;
  event.pin = name;
  event.answer = attached != nullptr ? attached->read(event.level) : Status::kOk;
  const Status status = tap.on(event);
  if (ok(status)) level = event.level;
  return status;
}

void WireTap::TapClock::do_delay_us(std::uint32_t us) {
  now_us += us;
  waited_us += us;
  if (attached != nullptr) attached->delay_us(us);
  WireEvent event;
  event.kind = Kind::kDelay;
  event.us = us;
  (void)tap.on(event);
}

}  // namespace arcspan::hal::sim
