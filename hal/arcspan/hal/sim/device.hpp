// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/output_pin.hpp>
#include <arcspan/hal/panel/glass.hpp>
#include <arcspan/pixel/colour.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// Simulated devices, for the desk and for tests: they use the standard library, and are a target of their
/// own (arcspan::hal_sim). Nothing that runs on a board includes them.
namespace arcspan::hal::sim {

/// A picture with 8 bits a channel, rows from top to bottom.
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

/// A display controller with a glass, as its wires see it. Stricter than a real one: what a datasheet forbids
/// or leaves open is kept as a complaint, with the time at which it happened.
class Device {
 public:
  explicit Device(const Glass& glass) : glass_(glass) {}
  virtual ~Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  /// One byte with the level of D/C, whole at `now_ns`.
  void receive(std::uint8_t byte, Level data_or_command, std::uint64_t now_ns);
  /// The reset line, active when low; it is high at first.
  void reset_line(Level level, std::uint64_t now_ns);
  /// From now on the reset line does nothing: a broken wire.
  void lose_reset_line() { reset_lost_ = true; }
  /// The supply fails for a moment: registers as after reset, memory garbage.
  void brown_out(std::uint64_t now_ns);

  /// What the glass shows, in its own columns and rows: black when the display is off or asleep.
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
  virtual void do_scramble() = 0;
  [[nodiscard]] virtual bool do_lit() const = 0;
  /// The colour at a column and row of the controller, inside the glass.
  [[nodiscard]] virtual Rgb8 do_pixel(int column, int row) const = 0;
  [[nodiscard]] virtual std::uint64_t do_least_reset_ns() const = 0;
  /// Time after reset during which nothing may be sent.
  [[nodiscard]] virtual std::uint64_t do_after_reset_ns() const = 0;

  Glass glass_;
  std::vector<std::string> complaints_;
  std::uint64_t now_ns_ = 0;
  std::uint64_t reset_began_ns_ = 0;
  std::uint64_t deaf_until_ns_ = 0;
  bool in_reset_ = false;
  bool reset_lost_ = false;
};

/// An address of memory, which is not negative.
[[nodiscard]] constexpr std::size_t index(int at) { return static_cast<std::size_t>(at); }

/// "0x2c" of a byte.
[[nodiscard]] std::string hex(unsigned byte);

}  // namespace arcspan::hal::sim
