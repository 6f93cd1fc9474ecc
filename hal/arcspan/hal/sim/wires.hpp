// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/clock.hpp>
#include <arcspan/hal/i2c_bus.hpp>
#include <arcspan/hal/input_pin.hpp>
#include <arcspan/hal/output_pin.hpp>
#include <arcspan/hal/sim/device.hpp>
#include <arcspan/hal/spi_bus.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::hal::sim {

/// A clock that moves only when it is waited for, told to, or when a bus sends.
class SimulatedClock final : public Clock {
 public:
  [[nodiscard]] std::uint64_t now_ns() const { return now_ns_; }
  void advance_ns(std::uint64_t ns) { now_ns_ += ns; }

 private:
  [[nodiscard]] std::uint32_t do_now_us() override { return static_cast<std::uint32_t>(now_ns_ / 1000); }
  void do_delay_us(std::uint32_t us) override { now_ns_ += std::uint64_t{us} * 1000; }

  std::uint64_t now_ns_ = 0;
};

/// What goes wrong on a bus, once, at byte `at_byte` of all that it is given from then on.
struct Fault {
  enum class Kind : std::uint8_t {
    kFailed,  ///< the bus reports an error; the byte and those after it are lost
    kShort,   ///< the bus takes no more bytes
    kStuck,   ///< the transfer never ends: busy until it is given up
  };
  Kind kind = Kind::kFailed;
  std::uint64_t at_byte = 0;
};

/// What a driver is told when `fault` strikes.
[[nodiscard]] Status status_of(Fault::Kind kind);

/// What both buses count.
struct BusCount {
  std::uint64_t bytes = 0;    ///< that were on the wire
  std::uint64_t busy_ns = 0;  ///< the time that they took
  std::uint64_t transfers = 0;
};

/// A 4-wire SPI bus with its D/C and reset lines, and a device at its end. Bytes arrive when their transfer
/// is over. A transfer that runs by itself takes its time on the clock, so that what is done meanwhile
/// overlaps with it; changing its bytes or D/C before it is over is a complaint, and so is a transfer that
/// begins while the busy line says that the device takes none.
class SimulatedSpi final : public SpiBus {
 public:
  /// `hertz` of the bit clock, 1 or more.
  SimulatedSpi(Device& device, SimulatedClock& clock, std::uint64_t hertz)
      : dc(*this, false), reset(*this, true), busy(clock), device_(device), clock_(clock), hertz_(hertz) {}

  /// A line whose levels go to the device.
  class Line final : public OutputPin {
   public:
    Line(SimulatedSpi& bus, bool resets) : bus_(bus), resets_(resets) {}
    /// The n-th `set` from now on, 0 the next, fails once and changes nothing.
    void fail_at(std::uint64_t set) { fails_at_ = set; }
    /// Whether it has not failed yet; forgets that it should.
    bool take_back_fault();
    [[nodiscard]] Level level() const { return level_; }

   private:
    Status do_set(Level level) override;
    SimulatedSpi& bus_;
    bool resets_;
    std::optional<std::uint64_t> fails_at_;
    Level level_ = Level::kHigh;
  };

  /// The line on which the device says that it is busy, high while it is: for some time after every transfer.
  class Busy final : public InputPin {
   public:
    explicit Busy(SimulatedClock& clock) : clock_(clock) {}
    /// From now on the device is busy for `ns` after each transfer.
    void set_time_ns(std::uint64_t ns) { time_ns_ = ns; }
    /// The wire says busy for good, or works again.
    void stick(bool stuck) { stuck_ = stuck; }
    /// The next `read` fails.
    void fail_once() { fails_ = true; }

   private:
    friend class SimulatedSpi;
    Status do_read(Level& level) override;
    [[nodiscard]] bool is_busy(std::uint64_t now_ns) const { return now_ns < until_ns_; }

    SimulatedClock& clock_;
    std::uint64_t time_ns_ = 0;
    std::uint64_t until_ns_ = 0;
    bool stuck_ = false;
    bool fails_ = false;
  };

  Line dc;
  Line reset;
  Busy busy;

  void inject(const Fault& fault) { fault_ = Fault{fault.kind, fault.at_byte + offered_}; }
  /// Whether the fault has not struck yet; forgets it.
  bool take_back_fault();

  [[nodiscard]] const BusCount& count() const { return count_; }
  /// What was done to the bus that no hardware forgives.
  [[nodiscard]] const std::vector<std::string>& complaints() const { return complaints_; }

 private:
  Status do_write(std::span<const std::uint8_t> bytes) override;
  Status do_start(std::span<const std::uint8_t> bytes) override;
  Status do_poll() override;
  void do_abort() override;

  void begin(std::span<const std::uint8_t> bytes);
  Status deliver();
  [[nodiscard]] std::uint64_t duration_ns(std::size_t bytes) const;

  Device& device_;
  SimulatedClock& clock_;
  std::uint64_t hertz_;
  std::optional<Fault> fault_;
  BusCount count_;
  std::vector<std::string> complaints_;

  std::span<const std::uint8_t> source_;
  std::vector<std::uint8_t> sent_;  ///< as it was when the transfer began, cut where the fault strikes
  std::optional<Fault::Kind> strikes_;
  Level dc_at_begin_ = Level::kHigh;
  std::uint64_t begin_ns_ = 0;
  std::uint64_t offered_ = 0;
};

/// An I2C bus with one device whose control byte says what follows: 0x00 commands, 0x40 data (SSD1306
/// rev 1.1, 8.1.5.2). Counts 9 clocks a byte, address included, and 2 for start and stop.
class SimulatedI2c final : public I2cBus {
 public:
  SimulatedI2c(Device& device, std::uint8_t address, SimulatedClock& clock, std::uint64_t hertz)
      : device_(device), clock_(clock), hertz_(hertz), address_(address) {}

  /// Address bytes do not count; kStuck gives kTimeout after 25 ms of a held clock.
  void inject(const Fault& fault) { fault_ = Fault{fault.kind, fault.at_byte + offered_}; }
  bool take_back_fault();

  [[nodiscard]] const BusCount& count() const { return count_; }
  [[nodiscard]] const std::vector<std::string>& complaints() const { return complaints_; }

 private:
  Status do_write(std::uint8_t address, std::span<const std::uint8_t> bytes) override;

  Device& device_;
  SimulatedClock& clock_;
  std::uint64_t hertz_;
  std::uint8_t address_;
  std::optional<Fault> fault_;
  BusCount count_;
  std::vector<std::string> complaints_;
  std::uint64_t offered_ = 0;
};

}  // namespace arcspan::hal::sim
