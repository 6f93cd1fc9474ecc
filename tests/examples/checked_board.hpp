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
  explicit CheckedSpi(hal::SpiBus* next) : next_(next) {}

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

/// The board of an example: a panel, such as hal::Ili9341, on `Devices`, which have `bus` and `reset`
/// (pointers that may be null), `data_or_command` and `clock`, and print a summary at the end.
template <class Panel, class Devices>
class CheckedBoard {
 public:
  CheckedBoard() = default;
  CheckedBoard(const CheckedBoard&) = delete;
  CheckedBoard& operator=(const CheckedBoard&) = delete;
  ~CheckedBoard() { devices_.report(bus_.bytes(), bus_.hash()); }

  Status start() { return panel_.start(); }
  [[nodiscard]] Panel& panel() { return panel_; }

 private:
  Devices devices_;
  CheckedSpi bus_{devices_.bus};
  Panel panel_{bus_, devices_.data_or_command, devices_.reset, devices_.clock};
};

}  // namespace arcspan::example
