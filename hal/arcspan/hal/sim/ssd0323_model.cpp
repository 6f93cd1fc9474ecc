// SPDX-License-Identifier: MIT
#include <arcspan/hal/sim/ssd0323_model.hpp>

namespace arcspan::hal::sim {
namespace {

constexpr unsigned kColumnRemap = 0x01;
constexpr unsigned kNibbleRemap = 0x02;
constexpr unsigned kVertical = 0x04;
constexpr unsigned kComRemap = 0x10;

}  // namespace

Ssd0323Model::Ssd0323Model(const Glass& glass) : SolomonModel(glass, false, 3000) {
  do_scramble();
  do_reset();
}

void Ssd0323Model::do_reset() {
  reset_common(kByteColumns, kRows);
  remap_ = 0;
  multiplex_ = kRows;
  offset_ = start_line_ = 0;
  contrast_ = 0x40;
}

int Ssd0323Model::do_parameter_count(std::uint8_t opcode) const {
  switch (opcode) {
    case 0x15:
    case 0x75:
      return 2;
    case 0x81:
    case 0xA0:
    case 0xA1:
    case 0xA2:
    case 0xA8:
    case 0xAD:
    case 0xB0:
    case 0xB1:
    case 0xB2:
    case 0xB3:
    case 0xBC:
    case 0xBE:
    case 0xBF:
      return 1;
    case 0x84:
    case 0x85:
    case 0x86:
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7:
    case 0xAE:
    case 0xAF:
    case 0xE3:
      return 0;
    case 0xB8:
      return 8;
    default:
      return -1;
  }
}

void Ssd0323Model::do_execute(std::uint8_t opcode) {
  switch (opcode) {
    case 0x15:
      set_columns(kByteColumns);
      break;
    case 0x75:
      set_rows(kRows);
      break;
    case 0x81:
      contrast_ = parameters()[0] & 127;
      break;
    case 0xA0:
      remap_ = parameters()[0];
      set_vertical((remap_ & kVertical) != 0);
      break;
    case 0xA1:
      start_line_ = parameters()[0] % kRows;
      break;
    case 0xA2:
      offset_ = parameters()[0] % kRows;
      break;
    case 0xA8:
      multiplex_ = (parameters()[0] & 127) + 1;
      break;
    default:
      break;
  }
}

bool Ssd0323Model::do_store(int column, int row, std::uint8_t byte) {
  memory_[index(row * kByteColumns + column)] = byte;
  return true;
}

Rgb8 Ssd0323Model::do_pixel(int column, int row) const {
  const int line = (((remap_ & kComRemap) != 0 ? kRows - 1 - row : row) + offset_) % kRows;
  if (line >= multiplex_) return {};
  const bool columns_mirrored = (remap_ & kColumnRemap) != 0;
  const int pair = columns_mirrored ? kByteColumns - 1 - column / 2 : column / 2;
  const unsigned byte = memory_[index((line + start_line_) % kRows * kByteColumns + pair)];
  // Address map: an even segment shows the low nibble, or the high one with nibble re-map.
  const bool high = (column % 2 != 0) != ((remap_ & kNibbleRemap) != 0);
  const unsigned level = high ? byte >> 4 : byte & 15u;
  const auto grey = static_cast<std::uint8_t>((inverted() != glass().inverted ? 15u - level : level) * 17u);
  return {grey, grey, grey};
}

}  // namespace arcspan::hal::sim
