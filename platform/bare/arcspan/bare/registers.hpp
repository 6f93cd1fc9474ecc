// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace arcspan::bare {

/// The memory-mapped register at `address`.
[[nodiscard]] inline volatile std::uint32_t& reg32(std::uintptr_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}
[[nodiscard]] inline volatile std::uint8_t& reg8(std::uintptr_t address) {
  return *reinterpret_cast<volatile std::uint8_t*>(address);
}

/// Sets the bits of `mask` and keeps the others.
inline void set_bits(std::uintptr_t address, std::uint32_t mask) { reg32(address) = reg32(address) | mask; }

}  // namespace arcspan::bare
