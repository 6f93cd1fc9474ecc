// SPDX-License-Identifier: MIT
#include <arcspan/hal/sim/display_model.hpp>
#include <arcspan/hal/sim/mock_wires.hpp>

#include <algorithm>

namespace arcspan::hal::sim {

using Kind = WireEvent::Kind;

MockWires::MockWires(std::string_view script) {
  WireScript read = parse_wire_script(script);
  events_ = std::move(read.events);
  difference_ = std::move(read.error);
}

const std::string& MockWires::finish() {
  if (difference_.empty() && due() != nullptr) (void)differ("it ended");
  return difference_;
}

Status MockWires::on(WireEvent& event) {
  if (!difference_.empty()) return Status::kTransferFailed;
  switch (event.kind) {
    case Kind::kSpi:
      return on_bytes(event);
    case Kind::kDelay:
      return on_delay(event);
    case Kind::kSet:
      // Byte events carry the level of D/C. Scripts mention the line only to make it fail.
      if (event.pin == kDataOrCommand &&
          (due() == nullptr || due()->kind != Kind::kSet || due()->pin != kDataOrCommand)) {
        return Status::kOk;
      }
      break;
    case Kind::kI2c:
    case Kind::kRead:
      break;
  }
  return on_whole(event);
}

Status MockWires::on_bytes(const WireEvent& event) {
  for (std::size_t i = 0; i < event.bytes.size(); ++i) {
    const WireEvent* expected = due();
    if (expected == nullptr || expected->kind != Kind::kSpi || expected->level != event.level ||
        expected->bytes[done_bytes_] != event.bytes[i]) {
      WireEvent rest = event;
      rest.bytes.erase(rest.bytes.begin(), rest.bytes.begin() + static_cast<std::ptrdiff_t>(i));
      return differ("it was '" + to_string(rest) + "'");
    }
    if (++done_bytes_ < expected->bytes.size()) continue;
    const Status status = take();
    if (!ok(status)) return status;
  }
  return Status::kOk;
}

Status MockWires::on_delay(const WireEvent& event) {
  std::uint64_t left = event.us;
  while (left > 0) {
    const WireEvent* expected = due();
    if (expected == nullptr || expected->kind != Kind::kDelay) {
      WireEvent rest = event;
      rest.us = left;
      return differ("it was '" + to_string(rest) + "'");
    }
    const std::uint64_t now = std::min(left, expected->us - done_us_);
    done_us_ += now;
    left -= now;
    if (done_us_ == expected->us) (void)take();
  }
  return Status::kOk;
}

Status MockWires::on_whole(WireEvent& event) {
  const WireEvent* expected = due();
  const bool same = expected != nullptr && expected->kind == event.kind && expected->pin == event.pin &&
                    (event.kind == Kind::kRead || expected->level == event.level) &&
                    expected->address == event.address && expected->bytes == event.bytes && done_us_ == 0;
  if (!same)
    return differ("it was '" + (event.kind == Kind::kRead ? "read " + event.pin : to_string(event)) + "'");
  event.level = expected->level;
  return take();
}

Status MockWires::take() {
  done_bytes_ = 0;
  done_us_ = 0;
  return events_[next_++].answer;
}

Status MockWires::differ(const std::string& what) {
  difference_ = expectation() + ", but " + what;
  return Status::kTransferFailed;
}

std::string MockWires::expectation() const {
  const WireEvent* event = due();
  if (event == nullptr) return "the script is over";
  std::string text = "line " + std::to_string(event->line) + ": expected '" + to_string(*event) + "'";
  if (event->kind == Kind::kSpi) {
    text +=
        ", byte " + std::to_string(done_bytes_ + 1) + " (" + hex(event->bytes[done_bytes_]).substr(2) + ")";
  } else if (done_us_ > 0) {
    text += ", of which " + std::to_string(event->us - done_us_) + " us are left";
  }
  return text;
}

}  // namespace arcspan::hal::sim
