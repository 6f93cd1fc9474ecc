// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/clock.hpp>
#include <arcspan/hal/i2c_bus.hpp>
#include <arcspan/hal/input_pin.hpp>
#include <arcspan/hal/output_pin.hpp>
#include <arcspan/hal/sim/display_model.hpp>
#include <arcspan/hal/spi_bus.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::hal::sim {

/// A clock that advances only by delays, by advance_ns() and by the transfers of a bus.
class SimulatedClock final : public Clock {
 public:
  [[nodiscard]] std::uint64_t now_ns() const { return now_ns_; }
  void advance_ns(std::uint64_t ns) { now_ns_ += ns; }

 private:
  [[nodiscard]] std::uint32_t do_now_us() override { return static_cast<std::uint32_t>(now_ns_ / 1000); }
  void do_delay_us(std::uint32_t us) override { now_ns_ += std::uint64_t{us} * 1000; }

  std::uint64_t now_ns_ = 0;
};

/// A single fault of a bus, at byte `at_byte` counted from its injection.
struct Fault {
  enum class Kind : std::uint8_t {
    kFailed,  ///< the bus reports an error; this byte and the following ones are lost
    kShort,   ///< the bus accepts no more bytes
    kStuck,   ///< the transfer stays busy until it is aborted
  };
  Kind kind = Kind::kFailed;
  std::uint64_t at_byte = 0;
};

/// Status that a driver receives when a fault of this kind occurs.
[[nodiscard]] Status status_of(Fault::Kind kind);

/// Counters of a bus.
struct BusCount {
  std::uint64_t bytes = 0;    ///< bytes on the wire
  std::uint64_t busy_ns = 0;  ///< time on the wire in nanoseconds
  std::uint64_t transfers = 0;
};

/// A simulated 4-wire SPI bus with its D/C, reset and busy lines and a display. Bytes arrive when their
/// transfer ends. A transfer in the background takes its time on the clock, so other work overlaps with it.
/// It is a complaint to change its bytes or D/C before it ends, and to begin a transfer while the busy line
/// reports busy.
class SimulatedSpi final : public SpiBus {
 public:
  /// `hertz`: rate of the bit clock, at least 1. `device` and `clock` must outlive the bus.
  SimulatedSpi(DisplayModel& device, SimulatedClock& clock, std::uint64_t hertz)
      : dc(*this, false), reset(*this, true), busy(clock), device_(device), clock_(clock), hertz_(hertz) {}

  /// An output pin that is connected to the display.
  class Line final : public OutputPin {
   public:
    Line(SimulatedSpi& bus, bool resets) : bus_(bus), resets_(resets) {}
    /// Makes the n-th `set` from now on fail once, without effect; 0 is the next.
    void fail_at(std::uint64_t set) { fails_at_ = set; }
    /// Removes a fault that has not occurred yet. Returns whether there was one.
    bool cancel_fault();
    [[nodiscard]] Level level() const { return level_; }

   private:
    Status do_set(Level level) override;
    SimulatedSpi& bus_;
    bool resets_;
    std::optional<std::uint64_t> fails_at_;
    Level level_ = Level::kHigh;
  };

  /// The busy line of the display: high for some time after every transfer.
  class Busy final : public InputPin {
   public:
    explicit Busy(SimulatedClock& clock) : clock_(clock) {}
    /// Sets how long the display is busy after each transfer, in nanoseconds.
    void set_time_ns(std::uint64_t ns) { time_ns_ = ns; }
    /// Keeps the line at busy, or lets it work again.
    void stick(bool stuck) { stuck_ = stuck; }
    /// Makes the next `read` fail.
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
  /// Removes a fault that has not occurred yet. Returns whether there was one.
  bool cancel_fault();

  [[nodiscard]] const BusCount& count() const { return count_; }
  /// Misuse of the bus that no hardware tolerates.
  [[nodiscard]] const std::vector<std::string>& complaints() const { return complaints_; }

 private:
  Status do_write(std::span<const std::uint8_t> bytes) override;
  Status do_start(std::span<const std::uint8_t> bytes) override;
  Status do_poll() override;
  void do_abort() override;

  void begin(std::span<const std::uint8_t> bytes);
  Status deliver();
  [[nodiscard]] std::uint64_t duration_ns(std::size_t bytes) const;

  DisplayModel& device_;
  SimulatedClock& clock_;
  std::uint64_t hertz_;
  std::optional<Fault> fault_;
  BusCount count_;
  std::vector<std::string> complaints_;

  std::span<const std::uint8_t> source_;
  std::vector<std::uint8_t> sent_;  ///< copy made at the start, cut off at the fault
  std::optional<Fault::Kind> strikes_;
  Level dc_at_begin_ = Level::kHigh;
  std::uint64_t begin_ns_ = 0;
  std::uint64_t offered_ = 0;
};

/// A simulated I2C bus with one display. The control byte selects commands (0x00) or data (0x40), as in
/// SSD1306 rev 1.1, 8.1.5.2. Timing: 9 clocks per byte, address included, and 2 for start and stop.
class SimulatedI2c final : public I2cBus {
 public:
  SimulatedI2c(DisplayModel& device, std::uint8_t address, SimulatedClock& clock, std::uint64_t hertz)
      : device_(device), clock_(clock), hertz_(hertz), address_(address) {}

  /// Injects a fault. Address bytes are not counted. kStuck returns kTimeout after 25 ms.
  void inject(const Fault& fault) { fault_ = Fault{fault.kind, fault.at_byte + offered_}; }
  bool cancel_fault();

  [[nodiscard]] const BusCount& count() const { return count_; }
  [[nodiscard]] const std::vector<std::string>& complaints() const { return complaints_; }

 private:
  Status do_write(std::uint8_t address, std::span<const std::uint8_t> bytes) override;

  DisplayModel& device_;
  SimulatedClock& clock_;
  std::uint64_t hertz_;
  std::uint8_t address_;
  std::optional<Fault> fault_;
  BusCount count_;
  std::vector<std::string> complaints_;
  std::uint64_t offered_ = 0;
};

}  // namespace arcspan::hal::sim
