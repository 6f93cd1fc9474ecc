// SPDX-License-Identifier: MIT
#include <arcspan_tools/support/parse.hpp>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <type_traits>

namespace arcspan::tools {
namespace {

// from_chars does not tell whether a decimal number is too large or too small for a double.
template <class T>
std::optional<T> beyond_range(std::string_view text) {
  if constexpr (std::is_floating_point_v<T>) return std::strtod(std::string(text).c_str(), nullptr);
  return std::nullopt;
}

template <class T>
std::optional<T> parse_all(std::string_view text) {
  // from_chars takes a minus but no plus.
  if (!text.empty() && text.front() == '+') {
    text.remove_prefix(1);
    if (!text.empty() && text.front() == '-') return std::nullopt;
  }
  T value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (stop != end || text.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range) return beyond_range<T>(text);
  if (error != std::errc{}) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) { return parse_all<double>(text); }

std::optional<std::int64_t> parse_integer(std::string_view text) { return parse_all<std::int64_t>(text); }

std::optional<Vec3> parse_triple(std::string_view text) {
  double values[3] = {};
  for (int i = 0; i < 3; ++i) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (i == 2)) return std::nullopt;
    const std::optional<double> value = parse_number(text.substr(0, comma));
    if (!value || !std::isfinite(*value)) return std::nullopt;
    values[i] = *value;
    if (i < 2) text.remove_prefix(comma + 1);
  }
  return Vec3{values[0], values[1], values[2]};
}

std::optional<Size> parse_size(std::string_view text) {
  constexpr std::int64_t kMost = 999'999;
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  const auto width = parse_integer(text.substr(0, cross));
  const auto height = parse_integer(text.substr(cross + 1));
  if (!width || !height || *width < 1 || *height < 1 || *width > kMost || *height > kMost)
    return std::nullopt;
  return Size{static_cast<std::int32_t>(*width), static_cast<std::int32_t>(*height)};
}

std::string size_text(const Size& size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

}  // namespace arcspan::tools
