// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/panel/custom_dcs_panel.hpp>
#include <arcspan/hal/sim/display_model.hpp>

namespace arcspan::hal::sim {

/// Model of an ILI9341 or ST7789, which do not differ in what is modelled here (ILI9341 V1.11, chapter 8;
/// ST7789V, chapter 9), or of another controller with the MIPI display command set.
class DcsModel final : public DisplayModel {
 public:
  /// The commands of `controller` are known and have no effect; they must outlive the model.
  explicit DcsModel(const Glass& glass, const DcsController& controller = {});

  [[nodiscard]] bool awake() const { return !asleep_; }
  [[nodiscard]] std::uint8_t brightness() const { return brightness_; }

 private:
  void do_command(std::uint8_t byte) override;
  void do_data(std::uint8_t byte) override;
  void do_reset() override;
  void do_scramble() override;
  [[nodiscard]] bool do_lit() const override { return !asleep_ && display_on_; }
  [[nodiscard]] Rgb8 do_pixel(int column, int row) const override;
  [[nodiscard]] std::uint64_t do_min_reset_ns() const override { return 10'000; }
  [[nodiscard]] std::uint64_t do_after_reset_ns() const override { return 5'000'000; }

  void finish_parameters();
  void begin_memory_write();
  void pixel_byte(std::uint8_t byte);
  void store(std::uint16_t encoded);
  void sleep(bool asleep);

  /// Number of parameters of a command, or -1 if it is unknown.
  [[nodiscard]] int parameter_count(std::uint8_t opcode) const;

  DcsController controller_;
  int columns_;
  int rows_;
  std::vector<std::uint16_t> memory_;
  std::uint8_t opcode_ = 0;
  std::size_t wanted_ = 0;
  std::vector<std::uint8_t> parameters_;
  bool writing_ = false;
  bool half_pixel_ = false;
  std::uint8_t high_byte_ = 0;
  int window_columns_[2] = {};
  int window_rows_[2] = {};
  int x_ = 0;
  int y_ = 0;
  bool window_full_ = false;
  std::uint8_t address_mode_ = 0;
  std::uint8_t pixel_format_ = 0;
  std::uint8_t brightness_ = 0;
  bool asleep_ = true;
  bool display_on_ = false;
  bool inverted_ = false;
  std::uint64_t quiet_until_ns_ = 0;
  std::uint64_t sleep_locked_until_ns_ = 0;
};

}  // namespace arcspan::hal::sim
