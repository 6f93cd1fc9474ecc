// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/sim/solomon_model.hpp>

namespace arcspan::hal::sim {

/// Model of an SSD1351 (rev 1.5): 128 x 128 pixels in its format of 65k colours.
class Ssd1351Model final : public SolomonModel {
 public:
  explicit Ssd1351Model(const Glass& glass);
  [[nodiscard]] std::uint8_t brightness() const { return contrast_; }

 private:
  static constexpr int kColumns = 128;
  static constexpr int kRows = 128;

  void do_reset() override;
  void do_scramble() override { memory_ = garbage(2 * kColumns * kRows); }
  [[nodiscard]] Rgb8 do_pixel(int column, int row) const override;
  [[nodiscard]] int do_parameter_count(std::uint8_t opcode) const override;
  void do_execute(std::uint8_t opcode) override;
  bool do_store(int column, int row, std::uint8_t byte) override;
  [[nodiscard]] std::uint8_t do_normal_opcode() const override { return 0xA6; }
  void unlock();

  std::vector<std::uint8_t> memory_;
  std::uint8_t remap_ = 0x40;
  int multiplex_ = kRows;
  int offset_ = 0x60;
  int start_line_ = 0;
  std::uint8_t contrast_ = 0x8A;
  bool second_byte_ = false;
  bool locked_ = false;
  bool settings_locked_ = true;
};

}  // namespace arcspan::hal::sim
