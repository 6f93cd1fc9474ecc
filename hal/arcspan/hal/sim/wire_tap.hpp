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

/// Base of MockWires and WireRecorder: all buses, pins and the clock of a driver, which report every call to
/// on().
///
/// Transfers block. The clock advances only by the driver's own delays, unless another clock is attached.
class WireTap {
 public:
  WireTap(const WireTap&) = delete;
  WireTap& operator=(const WireTap&) = delete;

  [[nodiscard]] SpiBus& spi() { return spi_; }
  [[nodiscard]] I2cBus& i2c() { return i2c_; }
  [[nodiscard]] Clock& clock() { return clock_; }
  [[nodiscard]] OutputPin& data_or_command() { return output(std::string(kDataOrCommand)); }
  /// The pin that scripts call `name`. Every call returns the same object, which lives as long as this one.
  [[nodiscard]] OutputPin& output(const std::string& name);
  [[nodiscard]] InputPin& input(const std::string& name);

  /// Sum of the driver's delays in microseconds.
  [[nodiscard]] std::uint64_t waited_us() const { return clock_.waited_us; }
  /// Sets the clock to `now` microseconds, for example to shortly before it wraps.
  void set_now_us(std::uint32_t now) { clock_.now_us = now; }

 protected:
  WireTap() : spi_(*this), i2c_(*this), clock_(*this) {}
  ~WireTap() = default;

  /// Handles an event, whose `answer` is that of the attached object or kOk, and returns the answer for the
  /// driver. It may change `level` of a kRead, which is the level that the driver reads.
  virtual Status on(WireEvent& event) = 0;

  /// Each of these forwards a call to the attached object, if any, and then passes the event to on().
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
  /// See Spi. `name` is the pin's name in scripts.
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
  /// See Spi. Counts the delays if no clock is attached.
  struct TapClock final : Clock {
    explicit TapClock(WireTap& owner) : tap(owner) {}
    std::uint32_t do_now_us() override { return attached != nullptr ? attached->now_us() : now_us; }
    void do_delay_us(std::uint32_t us) override;
    WireTap& tap;
    Clock* attached = nullptr;
    std::uint32_t now_us = 0;
    std::uint64_t waited_us = 0;
  };

  // A map, because its elements do not move.
  std::map<std::string, Output> outputs_;
  std::map<std::string, Input> inputs_;
  Spi spi_;
  I2c i2c_;
  TapClock clock_;
  Level dc_ = Level::kHigh;
};

}  // namespace arcspan::hal::sim
