// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/element_text.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace arcspan::tools {

bool is_coordinate(const Vec3& v) {
  return finite(v) && std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}) <= kMostCoordinate;
}

void ElementText::begin(std::string what) {
  what_ = std::move(what);
  if (!has_own_lines()) return;
  lines_.next_words(what_);
  at_ = 0;
}

bool ElementText::has_more() {
  while (left_on_line() == 0) {
    if (!lines_.next()) return false;
    at_ = 0;
  }
  return true;
}

void ElementText::advance() {
  const bool more = has_own_lines() ? left_on_line() > 0 : has_more();
  if (!more) lines_.fail("the file ends before " + what_);
}

std::string_view ElementText::word() {
  advance();
  return lines_.words()[at_++];
}

double ElementText::number() {
  return parse_number(word()).value_or(std::numeric_limits<double>::quiet_NaN());
}

void ElementText::read_triple() {
  for (std::string_view& read : triple_) read = word();
}

Vec3 ElementText::triple() const {
  double v[3];
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = parse_number(triple_[i]).value_or(std::numeric_limits<double>::quiet_NaN());
    if (!(std::fabs(v[i]) <= kMostCoordinate)) fail(in_quotes(triple_[i]) + " is not a number up to 1e30");
  }
  return {v[0], v[1], v[2]};
}

std::int64_t ElementText::integer(std::int64_t least, std::int64_t most, const char* what) {
  advance();
  return lines_.integer_at(at_++, least, most, what);
}

void ElementText::expect(std::string_view wanted) {
  const std::string_view found = word();
  if (!same_letters(found, wanted)) fail("expected '" + std::string(wanted) + "', not " + in_quotes(found));
}

void ElementText::skip_to(std::string_view first, std::string_view second) {
  const std::vector<std::string_view>& words = lines_.words();
  for (; at_ < words.size(); ++at_) {
    if (at_ + 1 < words.size() && same_letters(words[at_], first) && same_letters(words[at_ + 1], second))
      break;
  }
}

void ElementText::end() {
  if (!has_own_lines() && has_more()) lines_.fail("more numbers than its counts announce");
}

}  // namespace arcspan::tools
