// SPDX-License-Identifier: MIT
#pragma once

#include <tests/support/strict_sink.hpp>

#include <vector>

namespace arcspan::test {

/// A sink that only notes its runs: the colours are in the probe.
class RunList {
 public:
  using Format = StrictFormat;
  explicit RunList(const Rect& bounds) : bounds_(bounds), row_(static_cast<std::size_t>(bounds.right)) {}
  [[nodiscard]] Rect bounds() const { return bounds_; }
  [[nodiscard]] Format::Cursor open(const Span& run) {
    runs.push_back(run);
    for (std::int32_t i = 0; i < run.count; ++i) row_[static_cast<std::size_t>(run.x + i)] = {};
    return {row_.data() + run.x, row_.data() + run.x + run.count, &faults_};
  }
  [[nodiscard]] Status close(const Span&) { return Status::kOk; }

  std::vector<Span> runs;

 private:
  Rect bounds_;
  std::vector<StrictFormat::Cell> row_;
  SinkFaults faults_;
};

}  // namespace arcspan::test
