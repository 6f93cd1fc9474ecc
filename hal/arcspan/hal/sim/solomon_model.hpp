// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/sim/display_model.hpp>

namespace arcspan::hal::sim {

/// Common part of the Solomon Systech models: commands with parameters, display on and off, inversion, and a
/// window in which the address advances and wraps.
class SolomonModel : public DisplayModel {
 protected:
  /// `parameters_are_data`: parameters arrive with D/C high instead of low. `min_reset_ns`: shortest reset
  /// pulse, and also the shortest pause after it.
  SolomonModel(const Glass& glass, bool parameters_are_data, std::uint64_t min_reset_ns)
      : DisplayModel(glass), parameters_are_data_(parameters_are_data), min_reset_ns_(min_reset_ns) {}

  [[nodiscard]] const std::vector<std::uint8_t>& parameters() const { return parameters_; }

  /// Columns or rows of a window, first ... last.
  struct Range {
    int first = 0;
    int last = 0;
  };
  /// Set the window's columns or rows from the two received parameters, each below `limit`.
  void set_columns(int limit);
  void set_rows(int limit);
  void set_vertical(bool vertical) { vertical_ = vertical; }
  void allow_pixels(bool allow) { writing_ = allow; }
  /// Sets the registers common to all models to their reset values.
  void reset_common(int columns, int rows);
  [[nodiscard]] static std::vector<std::uint8_t> garbage(std::size_t size);

  [[nodiscard]] bool inverted() const { return inverted_; }

 private:
  void do_command(std::uint8_t byte) final;
  void do_data(std::uint8_t byte) final;
  [[nodiscard]] bool do_lit() const final { return on_; }
  [[nodiscard]] std::uint64_t do_min_reset_ns() const final { return min_reset_ns_; }
  [[nodiscard]] std::uint64_t do_after_reset_ns() const final { return min_reset_ns_; }

  /// Number of parameters of a command, or -1 if it is unknown.
  [[nodiscard]] virtual int do_parameter_count(std::uint8_t opcode) const = 0;
  virtual void do_execute(std::uint8_t opcode) = 0;
  /// Stores one byte at the address. True when all bytes of that address have been stored.
  virtual bool do_store(int column, int row, std::uint8_t byte) = 0;
  /// Opcode that switches inversion off.
  [[nodiscard]] virtual std::uint8_t do_normal_opcode() const = 0;

  void set_range(Range& range, int limit, const char* what);
  void execute();
  void step();

  bool parameters_are_data_;
  std::uint64_t min_reset_ns_;
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
