// SPDX-License-Identifier: MIT
#include <arcspan/hal/sim/ssd1351_model.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <utility>

namespace arcspan::hal::sim {
namespace {

constexpr unsigned kVertical = 0x01;
constexpr unsigned kColumnRemap = 0x02;
constexpr unsigned kColoursSwapped = 0x04;
constexpr unsigned kComRemap = 0x10;
constexpr unsigned kDepth = 0xC0;
constexpr unsigned k65kColours = 0x40;

}  // namespace

Ssd1351Model::Ssd1351Model(const Glass& glass) : SolomonModel(glass, true, 2000) {
  do_scramble();
  do_reset();
}

void Ssd1351Model::do_reset() {
  reset_common(kColumns, kRows);
  remap_ = 0x40;
  multiplex_ = kRows;
  offset_ = 0x60;  // (10.1.7)
  start_line_ = 0;
  contrast_ = 0x8A;  // of the first colour only
  second_byte_ = locked_ = false;
  settings_locked_ = true;
}

int Ssd1351Model::do_parameter_count(std::uint8_t opcode) const {
  switch (opcode) {
    case 0x15:
    case 0x75:
      return 2;
    case 0xA0:
    case 0xA1:
    case 0xA2:
    case 0xAB:
    case 0xB1:
    case 0xB3:
    case 0xB5:
    case 0xB6:
    case 0xBB:
    case 0xBE:
    case 0xC7:
    case 0xCA:
    case 0xFD:
      return 1;
    case 0xB2:
    case 0xB4:
    case 0xC1:
      return 3;
    case 0x5C:
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7:
    case 0xAD:
    case 0xAE:
    case 0xAF:
    case 0xB9:
    case 0xE3:
      return 0;
    default:
      return -1;
  }
}

void Ssd1351Model::unlock() {
  const unsigned key = parameters()[0];
  if (key == 0x12 || key == 0x16) {
    locked_ = key == 0x16;
  } else if (key == 0xB0 || key == 0xB1) {
    settings_locked_ = key == 0xB0;
  } else {
    complain("command lock " + hex(key));
  }
}

void Ssd1351Model::do_execute(std::uint8_t opcode) {
  if (opcode == 0xFD) return unlock();
  if (locked_) return complain("command " + hex(opcode) + " while commands are locked");
  const bool guarded = opcode == 0xA2 || opcode == 0xB1 || opcode == 0xB3 || opcode == 0xBB ||
                       opcode == 0xBE || opcode == 0xC1;
  if (guarded && settings_locked_) return complain("command " + hex(opcode) + " is locked (FDh, B1h)");
  switch (opcode) {
    case 0x15:
      set_columns(kColumns);
      break;
    case 0x75:
      set_rows(kRows);
      break;
    case 0x5C:
      if ((remap_ & kDepth) != k65kColours) complain("pixels in a format that is not 65k colours");
      second_byte_ = false;
      allow_pixels(true);
      break;
    case 0xA0:
      remap_ = parameters()[0];
      set_vertical((remap_ & kVertical) != 0);
      break;
    case 0xA1:
      start_line_ = parameters()[0] & 127;
      break;
    case 0xA2:
      offset_ = parameters()[0] & 127;
      break;
    case 0xC1:
      contrast_ = parameters()[0];
      break;
    case 0xCA:
      multiplex_ = (parameters()[0] & 127) + 1;
      break;
    default:
      break;
  }
}

bool Ssd1351Model::do_store(int column, int row, std::uint8_t byte) {
  memory_[index(2 * (row * kColumns + column) + (second_byte_ ? 1 : 0))] = byte;
  second_byte_ = !second_byte_;
  return !second_byte_;
}

Rgb8 Ssd1351Model::do_pixel(int column, int row) const {
  if (row >= multiplex_) return {};
  const int x = (remap_ & kColumnRemap) != 0 ? kColumns - 1 - column : column;
  const int y = (((remap_ & kComRemap) != 0 ? multiplex_ - 1 - row : row) + start_line_ + offset_) % kRows;
  const auto at = index(2 * (y * kColumns + x));
  auto encoded = static_cast<std::uint16_t>(memory_[at] << 8 | memory_[at + 1]);
  if (inverted() != glass().inverted) encoded = static_cast<std::uint16_t>(~encoded);
  Rgb8 colour = Rgb565::decode(encoded);
  if (((remap_ & kColoursSwapped) != 0) != glass().blue_first) std::swap(colour.r, colour.b);
  return colour;
}

}  // namespace arcspan::hal::sim
