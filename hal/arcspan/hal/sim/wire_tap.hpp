// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/clock.hpp>
#include <arcspan/hal/i2c_bus.hpp>
#include <arcspan/hal/input_pin.hpp>
#include <arcspan/hal/output_pin.hpp>
#include <arcspan/hal/sim/wire_script.hpp>
#include <arcspan/hal/spi_bus.hpp>

#include <map>
#include <string>

namespace arcspan::hal::sim {

/// All the wires of a driver, each fulfilling its seam, that report what is done to them to one place.
///
/// Transfers block. The clock is the driver's alone: it begins where it is told to and moves by what is
/// waited for, or is somebody else's if one is attached.
class WireTap {
 public:
  WireTap(const WireTap&) = delete;
  WireTap& operator=(const WireTap&) = delete;

  [[nodiscard]] SpiBus& spi() { return spi_; }
  [[nodiscard]] I2cBus& i2c() { return i2c_; }
  [[nodiscard]] Clock& clock() { return clock_; }
  [[nodiscard]] OutputPin& data_or_command() { return output(std::string(kDataOrCommand)); }
  /// The pin of this name, which is what scripts call it: the same one every time. Lives as long as this.
  [[nodiscard]] OutputPin& output(const std::string& name);
  [[nodiscard]] InputPin& input(const std::string& name);

  /// Microseconds that the driver has waited in all.
  [[nodiscard]] std::uint64_t waited_us() const { return clock_.waited_us; }
  /// What now_us() counts from, e.g. shortly before it wraps.
  void set_now_us(std::uint32_t now) { clock_.now_us = now; }

 protected:
  WireTap() : spi_(*this), i2c_(*this), clock_(*this) {}
  ~WireTap() = default;

  /// What was done, with the answer of what is attached, or kOk. Returns what the driver is told. `level` of
  /// a kRead is what it reads, and may be changed.
  virtual Status on(WireEvent& event) = 0;

  /// Each passes what it is told to what is attached, and then, with its answer, to on().
  struct Spi final : SpiBus {
    explicit Spi(WireTap& owner) : tap(owner) {}
    Status do_write(std::span<const std::uint8_t> bytes) override;
    WireTap& tap;
    SpiBus* attached = nullptr;
  };
  /// See Spi.
  struct I2c final : I2cBus {
    explicit I2c(WireTap& owner) : tap(owner) {}
    Status do_write(std::uint8_t address, std::span<const std::uint8_t> bytes) override;
    WireTap& tap;
    I2cBus* attached = nullptr;
  };
  /// See Spi; a pin knows the name that scripts call it by.
  struct Output final : OutputPin {
    Output(WireTap& owner, const std::string& called) : tap(owner), name(called) {}
    Status do_set(Level to) override;
    WireTap& tap;
    std::string name;
    OutputPin* attached = nullptr;
  };
  /// See Output.
  struct Input final : InputPin {
    Input(WireTap& owner, const std::string& called) : tap(owner), name(called) {}
    Status do_read(Level& level) override;
    WireTap& tap;
    std::string name;
    InputPin* attached = nullptr;
  };
  /// Counts by itself unless a clock is attached.
  struct TapClock final : Clock {
    explicit TapClock(WireTap& owner) : tap(owner) {}
    std::uint32_t do_now_us() override { return attached != nullptr ? attached->now_us() : now_us; }
    void do_delay_us(std::uint32_t us) override;
    WireTap& tap;
    Clock* attached = nullptr;
    std::uint32_t now_us = 0;
    std::uint64_t waited_us = 0;
  };

  // A map's elements stay where they are.
  std::map<std::string, Output> outputs_;
  std::map<std::string, Input> inputs_;
  Spi spi_;
  I2c i2c_;
  TapClock clock_;
  Level dc_ = Level::kHigh;
};

}  // namespace arcspan::hal::sim
