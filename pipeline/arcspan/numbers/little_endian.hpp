// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// The number in two or four bytes at any address, the least significant byte first.
[[nodiscard]] constexpr std::uint16_t little_u16(const std::uint8_t* at) {
  return static_cast<std::uint16_t>(at[0] | (at[1] << 8));
}

[[nodiscard]] constexpr std::uint32_t little_u32(const std::uint8_t* at) {
  return little_u16(at) | (std::uint32_t{little_u16(at + 2)} << 16);
}

namespace detail {

/// The elements at an address, whose alignment has been checked. They are read in place, on little-endian
/// machines only.
template <class T>
[[nodiscard]] ARCSPAN_INLINE inline const T* elements_at(const std::uint8_t* at) {
  return static_cast<const T*>(static_cast<const void*>(at));
}

}  // namespace detail

}  // namespace arcspan
