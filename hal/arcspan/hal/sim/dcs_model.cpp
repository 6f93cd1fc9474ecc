// SPDX-License-Identifier: MIT
#include <arcspan/hal/sim/dcs_model.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <algorithm>

namespace arcspan::hal::sim {
namespace {

constexpr std::uint64_t kMs = 1'000'000;
constexpr std::uint64_t kAfterCommandNs = 5 * kMs;  // software reset, sleep in, sleep out
constexpr std::uint64_t kBetweenSleepsNs = 120 * kMs;
constexpr unsigned kMirrorRows = 0x80;
constexpr unsigned kMirrorColumns = 0x40;
constexpr unsigned kSwapAxes = 0x20;
constexpr unsigned kBlueFirst = 0x08;

/// Number of parameters of a modelled command, or -1 for any other.
int modelled_parameters(std::uint8_t opcode) {
  switch (opcode) {
    case 0x01:
    case 0x10:
    case 0x11:
    case 0x13:
    case 0x20:
    case 0x21:
    case 0x28:
    case 0x29:
    case 0x2C:
    case 0x00:
      return 0;
    case 0x2A:
    case 0x2B:
      return 4;
    case 0x36:
    case 0x3A:
    case 0x51:
    case 0x53:
      return 1;
    default:
      return -1;
  }
}

}  // namespace

DcsModel::DcsModel(const Glass& glass, const DcsController& controller)
    : DisplayModel(glass),
      controller_(controller),
      columns_(controller.columns),
      rows_(controller.rows),
      memory_(index(columns_ * rows_)) {
  do_scramble();
  do_reset();
}

int DcsModel::parameter_count(std::uint8_t opcode) const {
  const std::span<const std::uint8_t> table = controller_.commands;
  for (std::size_t at = 0; at + 1 < table.size(); at += 2 + std::size_t{table[at + 1]}) {
    if (table[at] == opcode) return table[at + 1];
  }
  return modelled_parameters(opcode);
}

void DcsModel::do_scramble() {
  std::uint32_t state = 12345;  // memory content is undefined after power-on
  for (std::uint16_t& encoded : memory_) {
    state = state * 1664525u + 1013904223u;
    encoded = static_cast<std::uint16_t>(state >> 16);
  }
}

void DcsModel::do_reset() {
  // After a reset out of sleep mode, sleep mode may be left only after 120 ms.
  sleep_locked_until_ns_ = now_ns() + (asleep_ ? kAfterCommandNs : kBetweenSleepsNs);
  asleep_ = true;
  display_on_ = inverted_ = writing_ = half_pixel_ = false;
  wanted_ = 0;
  address_mode_ = 0;
  brightness_ = 0;
  pixel_format_ = 0x66;
  window_columns_[0] = window_rows_[0] = 0;
  window_columns_[1] = columns_ - 1;
  window_rows_[1] = rows_ - 1;
}

void DcsModel::sleep(bool asleep) {
  if (now_ns() < sleep_locked_until_ns_) {
    complain(std::string(asleep ? "sleep in" : "sleep out") + " less than 120 ms after the last change");
  }
  if (asleep_ != asleep) sleep_locked_until_ns_ = now_ns() + kBetweenSleepsNs;
  asleep_ = asleep;
  quiet_until_ns_ = now_ns() + kAfterCommandNs;
}

void DcsModel::do_command(std::uint8_t byte) {
  if (now_ns() < quiet_until_ns_) complain("command " + hex(byte) + " less than 5 ms after reset or sleep");
  if (wanted_ > parameters_.size()) complain("command " + hex(opcode_) + " was cut short");
  if (half_pixel_) complain("a pixel was cut in half");
  writing_ = half_pixel_ = false;
  parameters_.clear();
  opcode_ = byte;
  const int count = parameter_count(byte);
  wanted_ = count > 0 ? static_cast<std::size_t>(count) : 0;
  if (count < 0) return complain("unknown command " + hex(byte));
  if (byte == 0x01) {
    do_reset();
    quiet_until_ns_ = now_ns() + kAfterCommandNs;
  }
  if (byte == 0x10 || byte == 0x11) sleep(byte == 0x10);
  if (byte == 0x20 || byte == 0x21) inverted_ = byte == 0x21;
  if (byte == 0x28 || byte == 0x29) display_on_ = byte == 0x29;
  if (byte == 0x2C) begin_memory_write();
}

void DcsModel::begin_memory_write() {
  if (asleep_) complain("pixels in sleep mode are invisible");
  if (pixel_format_ != 0x55 && pixel_format_ != 0x05) complain("pixels in a format that is not 16 bits");
  const bool swapped = (address_mode_ & kSwapAxes) != 0;
  if (window_columns_[0] > window_columns_[1] || window_columns_[1] >= (swapped ? rows_ : columns_))
    complain("bad column window");
  if (window_rows_[0] > window_rows_[1] || window_rows_[1] >= (swapped ? columns_ : rows_))
    complain("bad row window");
  writing_ = true;
  window_full_ = false;
  x_ = window_columns_[0];
  y_ = window_rows_[0];
}

void DcsModel::do_data(std::uint8_t byte) {
  if (writing_) return pixel_byte(byte);
  if (parameters_.size() >= wanted_) return complain("data " + hex(byte) + " before a memory write");
  parameters_.push_back(byte);
  if (parameters_.size() == wanted_) finish_parameters();
}

void DcsModel::finish_parameters() {
  const auto word = [this](std::size_t i) { return parameters_[i] << 8 | parameters_[i + 1]; };
  switch (opcode_) {
    case 0x2A:
      window_columns_[0] = word(0);
      window_columns_[1] = word(2);
      break;
    case 0x2B:
      window_rows_[0] = word(0);
      window_rows_[1] = word(2);
      break;
    case 0x36:
      address_mode_ = parameters_[0];
      break;
    case 0x3A:
      pixel_format_ = parameters_[0];
      break;
    case 0x51:
      brightness_ = parameters_[0];
      break;
    default:
      break;
  }
}

void DcsModel::pixel_byte(std::uint8_t byte) {
  if (!half_pixel_) {
    high_byte_ = byte;
    half_pixel_ = true;
    return;
  }
  half_pixel_ = false;
  if (window_full_) complain("more pixels than the window holds");
  window_full_ = false;
  store(static_cast<std::uint16_t>(high_byte_ << 8 | byte));
  if (++x_ <= window_columns_[1]) return;
  x_ = window_columns_[0];
  if (++y_ <= window_rows_[1]) return;
  y_ = window_rows_[0];  // a further pixel is a complaint
  window_full_ = true;
}

void DcsModel::store(std::uint16_t encoded) {
  const bool swapped = (address_mode_ & kSwapAxes) != 0;
  int column = swapped ? y_ : x_;
  int row = swapped ? x_ : y_;
  if ((address_mode_ & kMirrorColumns) != 0) column = columns_ - 1 - column;
  if ((address_mode_ & kMirrorRows) != 0) row = rows_ - 1 - row;
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return;
  memory_[index(row * columns_ + column)] = encoded;
}

Rgb8 DcsModel::do_pixel(int column, int row) const {
  const std::uint16_t stored = memory_[index(row * columns_ + column)];
  const std::uint16_t encoded = inverted_ != glass().inverted ? static_cast<std::uint16_t>(~stored) : stored;
  Rgb8 colour = Rgb565::decode(encoded);
  if (((address_mode_ & kBlueFirst) != 0) != glass().blue_first) std::swap(colour.r, colour.b);
  return colour;
}

}  // namespace arcspan::hal::sim
