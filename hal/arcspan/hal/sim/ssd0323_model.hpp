// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/sim/solomon_model.hpp>

namespace arcspan::hal::sim {

/// Model of an SSD0323: 128 x 80 pixels of 4 bits. COM c shows line c of the display, or 79 - c with COM
/// re-map, plus the display offset. Lines from the multiplex ratio on are dark.
class Ssd0323Model final : public SolomonModel {
 public:
  explicit Ssd0323Model(const Glass& glass);
  /// Contrast, 0 ... 127.
  [[nodiscard]] std::uint8_t brightness() const { return contrast_; }

 private:
  static constexpr int kByteColumns = 64;
  static constexpr int kRows = 80;

  void do_reset() override;
  void do_scramble() override { memory_ = garbage(kByteColumns * kRows); }
  [[nodiscard]] Rgb8 do_pixel(int column, int row) const override;
  [[nodiscard]] int do_parameter_count(std::uint8_t opcode) const override;
  void do_execute(std::uint8_t opcode) override;
  bool do_store(int column, int row, std::uint8_t byte) override;
  [[nodiscard]] std::uint8_t do_normal_opcode() const override { return 0xA4; }

  std::vector<std::uint8_t> memory_;
  std::uint8_t remap_ = 0;
  int multiplex_ = kRows;
  int offset_ = 0;
  int start_line_ = 0;
  std::uint8_t contrast_ = 0x40;
};

}  // namespace arcspan::hal::sim
