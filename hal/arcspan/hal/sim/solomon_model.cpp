// SPDX-License-Identifier: MIT
#include <arcspan/hal/sim/solomon_model.hpp>

namespace arcspan::hal::sim {

std::vector<std::uint8_t> SolomonModel::garbage(std::size_t size) {
  std::vector<std::uint8_t> bytes;
  std::uint32_t state = 777;
  while (bytes.size() < size) {
    state = state * 1664525u + 1013904223u;
    bytes.push_back(static_cast<std::uint8_t>(state >> 24));
  }
  return bytes;
}

void SolomonModel::reset_common(int columns, int rows) {
  wanted_ = 0;
  parameters_.clear();
  columns_ = {0, columns - 1};
  rows_ = {0, rows - 1};
  column_ = row_ = 0;
  vertical_ = columns_set_ = rows_set_ = window_full_ = on_ = inverted_ = false;
}

void SolomonModel::do_command(std::uint8_t byte) {
  if (!parameters_are_data_ && parameters_.size() < wanted_) {
    parameters_.push_back(byte);
    return execute();
  }
  if (parameters_.size() < wanted_) complain("command " + hex(opcode_) + " was cut short");
  const int count = do_parameter_count(byte);
  opcode_ = byte;
  parameters_.clear();
  wanted_ = count > 0 ? static_cast<std::size_t>(count) : 0;
  if (parameters_are_data_) writing_ = false;
  if (count < 0) return complain("unknown command " + hex(byte));
  execute();
}

void SolomonModel::execute() {
  if (parameters_.size() < wanted_) return;
  if (opcode_ == 0xAE || opcode_ == 0xAF) on_ = opcode_ == 0xAF;
  if (opcode_ == do_normal_opcode()) inverted_ = false;
  if (opcode_ == 0xA7) inverted_ = true;
  do_execute(opcode_);
}

void SolomonModel::set_range(Range& range, int limit, const char* what) {
  range = {parameters_[0] % limit, parameters_[1] % limit};
  if (parameters_[0] >= limit || parameters_[1] >= limit || range.first > range.last) {
    complain(std::string("bad ") + what + " " + hex(parameters_[0]) + " to " + hex(parameters_[1]));
  }
  window_full_ = false;
}

void SolomonModel::set_columns(int limit) {
  set_range(columns_, limit, "columns");
  column_ = columns_.first;
  columns_set_ = true;
}

void SolomonModel::set_rows(int limit) {
  set_range(rows_, limit, "rows");
  row_ = rows_.first;
  rows_set_ = true;
}

void SolomonModel::do_data(std::uint8_t byte) {
  if (parameters_.size() < wanted_) {
    if (!parameters_are_data_) return complain("data " + hex(byte) + " amid command " + hex(opcode_));
    parameters_.push_back(byte);
    return execute();
  }
  if (!writing_) return complain("data " + hex(byte) + " before a memory write");
  if (!columns_set_ || !rows_set_) complain("data " + hex(byte) + " before a window");
  if (!on_) complain("pixels while the display is off are invisible");
  if (window_full_) complain("more pixels than the window holds");
  if (do_store(column_, row_, byte)) step();
}

void SolomonModel::step() {
  window_full_ = false;
  int& fast = vertical_ ? row_ : column_;
  int& slow = vertical_ ? column_ : row_;
  const Range fast_range = vertical_ ? rows_ : columns_;
  const Range slow_range = vertical_ ? columns_ : rows_;
  if (fast++ != fast_range.last) return;
  fast = fast_range.first;
  if (slow++ != slow_range.last) return;
  slow = slow_range.first;
  window_full_ = true;
}

}  // namespace arcspan::hal::sim
