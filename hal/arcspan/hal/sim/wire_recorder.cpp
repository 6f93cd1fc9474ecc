// SPDX-License-Identifier: MIT
#include <arcspan/hal/sim/wire_recorder.hpp>

namespace arcspan::hal::sim {
namespace {

using Kind = WireEvent::Kind;

/// Whether `next` can be appended to `last`.
bool joins(const WireEvent& last, const WireEvent& next) {
  if (!ok(last.answer) || last.kind != next.kind) return false;
  return next.kind == Kind::kDelay || (next.kind == Kind::kSpi && last.level == next.level);
}

}  // namespace

void WireRecorder::attach(const std::string& name, OutputPin& pin) {
  (void)output(name);
  outputs_.at(name).attached = &pin;
}

void WireRecorder::attach(const std::string& name, InputPin& pin) {
  (void)input(name);
  inputs_.at(name).attached = &pin;
}

Status WireRecorder::on(WireEvent& event) {
  // Byte events carry the level of D/C.
  if (event.kind == Kind::kSet && event.pin == kDataOrCommand && ok(event.answer)) return Status::kOk;
  if (!events_.empty() && joins(events_.back(), event)) {
    WireEvent& last = events_.back();
    last.us += event.us;
    last.bytes.insert(last.bytes.end(), event.bytes.begin(), event.bytes.end());
    last.answer = event.answer;
  } else {
    events_.push_back(event);
  }
  return event.answer;
}

}  // namespace arcspan::hal::sim
