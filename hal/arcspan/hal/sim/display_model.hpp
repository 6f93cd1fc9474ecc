// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/output_pin.hpp>
#include <arcspan/hal/panel/glass.hpp>
#include <arcspan/pixel/colour.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// Simulated displays and buses for tests and tools on a host. They use the standard library and form a
/// target of their own, arcspan::hal_sim. Code for a board does not include them.
namespace arcspan::hal::sim {

/// A picture with 8 bits per channel, row by row from the top.
struct Picture {
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::vector<Rgb8> pixels;

  [[nodiscard]] const Rgb8& at(std::int32_t x, std::int32_t y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  friend bool operator==(const Picture&, const Picture&) = default;
};

/// Model of a display controller with its glass, driven through its wires. It is stricter than a real
/// controller: everything that the datasheet forbids or leaves open is recorded as a complaint with its time.
class DisplayModel {
 public:
  explicit DisplayModel(const Glass& glass) : glass_(glass) {}
  virtual ~DisplayModel() = default;
  DisplayModel(const DisplayModel&) = delete;
  DisplayModel& operator=(const DisplayModel&) = delete;

  /// Receives one byte, sent with this level of D/C and complete at `now_ns`.
  void receive(std::uint8_t byte, Level data_or_command, std::uint64_t now_ns);
  /// Sets the reset line, which is active low and initially high.
  void reset_line(Level level, std::uint64_t now_ns);
  /// Disconnects the reset line: later levels have no effect.
  void lose_reset_line() { reset_lost_ = true; }
  /// Interrupts the supply: registers are reset and the memory holds garbage.
  void brown_out(std::uint64_t now_ns);

  /// Picture on the glass, in the glass's columns and rows. Black while the display is off, asleep or in
  /// reset.
  [[nodiscard]] Picture picture() const;

  [[nodiscard]] const Glass& glass() const { return glass_; }
  [[nodiscard]] const std::vector<std::string>& complaints() const { return complaints_; }
  void forget_complaints() { complaints_.clear(); }

 protected:
  [[nodiscard]] std::uint64_t now_ns() const { return now_ns_; }
  void complain(const std::string& what);

 private:
  virtual void do_command(std::uint8_t byte) = 0;
  virtual void do_data(std::uint8_t byte) = 0;
  virtual void do_reset() = 0;
  /// Fills the memory with garbage.
  virtual void do_scramble() = 0;
  /// Whether the display is on and awake.
  [[nodiscard]] virtual bool do_lit() const = 0;
  /// Colour at a column and row of the controller that lie on the glass.
  [[nodiscard]] virtual Rgb8 do_pixel(int column, int row) const = 0;
  /// Shortest time for which reset must be low, in nanoseconds.
  [[nodiscard]] virtual std::uint64_t do_min_reset_ns() const = 0;
  /// Nanoseconds after reset during which nothing may be sent.
  [[nodiscard]] virtual std::uint64_t do_after_reset_ns() const = 0;

  Glass glass_;
  std::vector<std::string> complaints_;
  std::uint64_t now_ns_ = 0;
  std::uint64_t reset_began_ns_ = 0;
  std::uint64_t deaf_until_ns_ = 0;
  bool in_reset_ = false;
  bool reset_lost_ = false;
};

/// Converts a memory address, which must not be negative, to an index.
[[nodiscard]] constexpr std::size_t index(int at) { return static_cast<std::size_t>(at); }

/// `byte` in the form "0x2c".
[[nodiscard]] std::string hex(unsigned byte);

}  // namespace arcspan::hal::sim
