// SPDX-License-Identifier: MIT
#include <arcspan/hal/sim/ssd1306_model.hpp>

namespace arcspan::hal::sim {

Ssd1306Model::Ssd1306Model(const Glass& glass) : SolomonModel(glass, false, 3000) {
  do_scramble();
  do_reset();
}

void Ssd1306Model::do_reset() {
  reset_common(kColumns, kPages);
  segments_mirrored_ = coms_mirrored_ = false;
  multiplex_ = 64;
  offset_ = start_line_ = 0;
  contrast_ = 0x7F;
  charge_pump_ = internal_reference_ = false;
}

int Ssd1306Model::do_parameter_count(std::uint8_t opcode) const {
  if (opcode >= 0x40 && opcode <= 0x7F) return 0;
  switch (opcode) {
    case 0x20:
    case 0x81:
    case 0x8D:
    case 0xA8:
    case 0xAD:
    case 0xD3:
    case 0xD5:
    case 0xD9:
    case 0xDA:
    case 0xDB:
      return 1;
    case 0x21:
    case 0x22:
      return 2;
    case 0x2E:
    case 0xA0:
    case 0xA1:
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7:
    case 0xAE:
    case 0xAF:
    case 0xC0:
    case 0xC8:
    case 0xE3:
      return 0;
    default:
      return -1;
  }
}

void Ssd1306Model::do_execute(std::uint8_t opcode) {
  if (opcode >= 0x40 && opcode <= 0x7F) start_line_ = opcode & 63;
  switch (opcode) {
    case 0x20:
      if (parameters()[0] > 1) complain("page addressing is not modelled");
      set_vertical(parameters()[0] == 1);
      break;
    case 0x21:
      set_columns(kColumns);
      break;
    case 0x22:
      set_rows(kPages);
      break;
    case 0x81:
      contrast_ = parameters()[0];
      break;
    case 0x8D:
      charge_pump_ = (parameters()[0] & 0x04) != 0;
      break;
    case 0xAD:
      internal_reference_ = (parameters()[0] & 0x10) != 0;
      break;
    case 0xA0:
    case 0xA1:
      segments_mirrored_ = opcode == 0xA1;
      break;
    case 0xA8:
      multiplex_ = (parameters()[0] & 63) + 1;
      break;
    case 0xC0:
    case 0xC8:
      coms_mirrored_ = opcode == 0xC8;
      break;
    case 0xD3:
      offset_ = parameters()[0] & 63;
      break;
    default:
      break;
  }
}

bool Ssd1306Model::do_store(int column, int row, std::uint8_t byte) {
  const int segment = segments_mirrored_ ? kColumns - 1 - column : column;
  memory_[index(row * kColumns + segment)] = byte;
  return true;
}

Rgb8 Ssd1306Model::do_pixel(int column, int row) const {
  if (row >= multiplex_) return {};
  const int line = ((coms_mirrored_ ? multiplex_ - 1 - row : row) + start_line_ + offset_) & 63;
  const int bit = (memory_[index(line / 8 * kColumns + column)] >> (line % 8)) & 1;
  const bool lit = (bit != 0) != (inverted() != glass().inverted);
  return lit ? Rgb8{255, 255, 255} : Rgb8{};
}

}  // namespace arcspan::hal::sim
