// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/span/line_rows.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan::detail {

/// Draws the pixels of a rectangle of one depth; it is not empty and lies within the scissor of `target`.
template <OneColour Method, class Target>
[[nodiscard]] ARCSPAN_OUTLINE constexpr Status draw_rectangle(const Rect& rect, std::uint16_t depth,
                                                              const Target& all) {
  const Target target = all;  // a copy, because the members of a reference would be loaded for every pixel
  typename Method::Prepared nothing{};
  return Method::walk(nothing, [&](const auto& walker) {
    const Linear z = Linear::from_raw(std::int32_t{depth} << Linear::kFraction);
    RowMemory<Target> memory(target, rect.top);
    for (std::int32_t y = rect.top; y < rect.bottom; ++y, memory.next()) {
      const Status status = draw_one_colour({y, rect.left, rect.width()}, walker, z, {}, target, memory);
      if (!ok(status)) return status;
    }
    return Status::kOk;
  });
}

}  // namespace arcspan::detail
