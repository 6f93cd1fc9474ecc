// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>

#include <cstdint>

namespace arcspan::tools {

/// The part of a sink that counts spans and pixels.
class SpanCounter {
 public:
  [[nodiscard]] Status close(const Span& run) {
    ++spans_;
    pixels_ += static_cast<std::uint64_t>(run.count);
    return Status::kOk;
  }
  [[nodiscard]] std::uint64_t spans() const { return spans_; }
  [[nodiscard]] std::uint64_t pixels() const { return pixels_; }

 private:
  std::uint64_t spans_ = 0;
  std::uint64_t pixels_ = 0;
};

}  // namespace arcspan::tools
