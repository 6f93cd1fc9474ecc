// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/sim/device.hpp>

namespace arcspan::hal::sim {

/// What the controllers of Solomon Systech have in common: commands with parameters, display on and off,
/// inversion, and a window in which the address runs and wraps.
class SolomonModel : public Device {
 protected:
  /// Parameters come as command bytes, or as data; `least_reset_ns` the shortest reset, after which as much
  /// again must pass.
  SolomonModel(const Glass& glass, bool parameters_are_data, std::uint64_t least_reset_ns)
      : Device(glass), parameters_are_data_(parameters_are_data), least_reset_ns_(least_reset_ns) {}

  [[nodiscard]] const std::vector<std::uint8_t>& parameters() const { return parameters_; }

  /// Columns or rows of a window, both ends included.
  struct Range {
    int first = 0;
    int last = 0;
  };
  /// Takes a window's columns or rows from the two parameters, each below `limit`.
  void set_columns(int limit);
  void set_rows(int limit);
  void set_vertical(bool vertical) { vertical_ = vertical; }
  void allow_pixels(bool allow) { writing_ = allow; }
  /// Registers that all have, as after reset.
  void reset_common(int columns, int rows);
  [[nodiscard]] static std::vector<std::uint8_t> garbage(std::size_t size);

  [[nodiscard]] bool inverted() const { return inverted_; }

 private:
  void do_command(std::uint8_t byte) final;
  void do_data(std::uint8_t byte) final;
  [[nodiscard]] bool do_lit() const final { return on_; }
  [[nodiscard]] std::uint64_t do_least_reset_ns() const final { return least_reset_ns_; }
  [[nodiscard]] std::uint64_t do_after_reset_ns() const final { return least_reset_ns_; }

  /// The number of parameters of a command, -1 for one that is unknown.
  [[nodiscard]] virtual int do_parameter_count(std::uint8_t opcode) const = 0;
  virtual void do_execute(std::uint8_t opcode) = 0;
  /// Bytes of an address step, and one of them; true when an address has all of its bytes.
  virtual bool do_store(int column, int row, std::uint8_t byte) = 0;
  /// Whether opcode shows the memory inverted, or as it is.
  [[nodiscard]] virtual std::uint8_t do_normal_opcode() const = 0;

  void set_range(Range& range, int limit, const char* what);
  void execute();
  void step();

  bool parameters_are_data_;
  std::uint64_t least_reset_ns_;
  std::uint8_t opcode_ = 0;
  std::size_t wanted_ = 0;
  std::vector<std::uint8_t> parameters_;
  Range columns_;
  Range rows_;
  int column_ = 0;
  int row_ = 0;
  bool vertical_ = false;
  bool columns_set_ = false;
  bool rows_set_ = false;
  bool writing_ = true;
  bool window_full_ = false;
  bool on_ = false;
  bool inverted_ = false;
};

}  // namespace arcspan::hal::sim
