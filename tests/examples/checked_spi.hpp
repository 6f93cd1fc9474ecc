// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/spi_bus.hpp>

#include <cstdint>
#include <span>

namespace arcspan::example {

/// Counts the bytes that a program sends, and computes their FNV-1a hash, by which two boards are compared.
class CheckedSpi final : public hal::SpiBus {
 public:
  /// Bytes go on to `next`, unless it is null.
  explicit CheckedSpi(hal::SpiBus* next = nullptr) : next_(next) {}

  [[nodiscard]] std::uint32_t bytes() const { return bytes_; }
  [[nodiscard]] std::uint32_t hash() const { return hash_; }

 private:
  Status do_write(std::span<const std::uint8_t> bytes) override {
    for (const std::uint8_t byte : bytes) hash_ = (hash_ ^ byte) * 16777619u;
    bytes_ += static_cast<std::uint32_t>(bytes.size());
    return next_ == nullptr ? Status::kOk : next_->write(bytes);
  }

  hal::SpiBus* next_;
  std::uint32_t bytes_ = 0;
  std::uint32_t hash_ = 2166136261u;
};

}  // namespace arcspan::example
