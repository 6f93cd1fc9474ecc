// SPDX-License-Identifier: MIT
#include <arcspan/hal/sim/display_model.hpp>

namespace arcspan::hal::sim {

std::string hex(unsigned byte) {
  const char* digits = "0123456789abcdef";
  return std::string("0x") + digits[(byte >> 4) & 15] + digits[byte & 15];
}

void DisplayModel::complain(const std::string& what) {
  complaints_.push_back(std::to_string(now_ns_ / 1000) + " us: " + what);
}

void DisplayModel::receive(std::uint8_t byte, Level data_or_command, std::uint64_t now_ns) {
  now_ns_ = now_ns;
  if (in_reset_) return complain(hex(byte) + " while reset is low");
  if (now_ns < deaf_until_ns_) complain(hex(byte) + " too soon after reset");
  if (data_or_command == Level::kLow) {
    do_command(byte);
  } else {
    do_data(byte);
  }
}

void DisplayModel::reset_line(Level level, std::uint64_t now_ns) {
  now_ns_ = now_ns;
  if (reset_lost_ || in_reset_ == (level == Level::kLow)) return;
  in_reset_ = level == Level::kLow;
  if (in_reset_) {
    reset_began_ns_ = now_ns;
  } else if (now_ns - reset_began_ns_ < do_min_reset_ns()) {
    complain("reset was low for only " + std::to_string(now_ns - reset_began_ns_) +
             " ns");  // such a reset has no effect
  } else {
    do_reset();
    deaf_until_ns_ = now_ns + do_after_reset_ns();
  }
}

void DisplayModel::brown_out(std::uint64_t now_ns) {
  now_ns_ = now_ns;
  do_scramble();
  do_reset();
}

Picture DisplayModel::picture() const {
  Picture picture{glass_.width, glass_.height, {}};
  const bool lit = !in_reset_ && do_lit();
  for (int y = 0; y < glass_.height; ++y) {
    for (int x = 0; x < glass_.width; ++x) {
      const int column = (glass_.columns_mirrored ? glass_.width - 1 - x : x) + glass_.column_offset;
      const int row = (glass_.rows_mirrored ? glass_.height - 1 - y : y) + glass_.row_offset;
      picture.pixels.push_back(lit ? do_pixel(column, row) : Rgb8{});
    }
  }
  return picture;
}

}  // namespace arcspan::hal::sim
