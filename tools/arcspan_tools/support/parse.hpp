// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/support/vec3.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace arcspan::tools {

/// A finite or non-finite decimal number that is the whole of `text`; an optional sign of either kind.
/// Numbers beyond the range of double are infinite, those below its least one are 0.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// A decimal integer that is the whole of `text`.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view text);

/// `X,Y,Z`, three finite numbers.
[[nodiscard]] std::optional<Vec3> parse_triple(std::string_view text);

/// Two positive integers of at most six digits with an `x` between them.
struct Size {
  std::int32_t width = 0;
  std::int32_t height = 0;
  friend constexpr bool operator==(const Size&, const Size&) = default;
};
[[nodiscard]] std::optional<Size> parse_size(std::string_view text);
[[nodiscard]] std::string size_text(const Size& size);

}  // namespace arcspan::tools
