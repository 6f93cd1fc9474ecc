// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/sim/solomon_model.hpp>

namespace arcspan::hal::sim {

/// Model of an SSD1306 (rev 1.1): 128 x 64 bits. The segment re-map takes effect when bytes are written, the
/// COM scan direction when they are shown (10.1.8, 10.1.14).
class Ssd1306Model final : public SolomonModel {
 public:
  explicit Ssd1306Model(const Glass& glass);
  [[nodiscard]] std::uint8_t brightness() const { return contrast_; }
  /// Whether the pump supplies VCC, and whether the current's reference is internal.
  [[nodiscard]] bool charge_pump() const { return charge_pump_; }
  [[nodiscard]] bool internal_reference() const { return internal_reference_; }

 private:
  static constexpr int kColumns = 128;
  static constexpr int kPages = 8;

  void do_reset() override;
  void do_scramble() override { memory_ = garbage(kColumns * kPages); }
  [[nodiscard]] Rgb8 do_pixel(int column, int row) const override;
  [[nodiscard]] int do_parameter_count(std::uint8_t opcode) const override;
  void do_execute(std::uint8_t opcode) override;
  bool do_store(int column, int row, std::uint8_t byte) override;
  [[nodiscard]] std::uint8_t do_normal_opcode() const override { return 0xA6; }

  std::vector<std::uint8_t> memory_;
  bool segments_mirrored_ = false;
  bool coms_mirrored_ = false;
  int multiplex_ = 64;
  int offset_ = 0;
  int start_line_ = 0;
  std::uint8_t contrast_ = 0x7F;
  bool charge_pump_ = false;
  bool internal_reference_ = false;
};

}  // namespace arcspan::hal::sim
