// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/crc32.hpp>

#include <cstdint>
#include <string>

namespace arcspan::tools {

/// Appends the lowest `bytes` bytes of a number, the least significant one first.
inline void append_number(std::string& out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out.push_back(static_cast<char>((value >> (8 * i)) & 0xFFu));
}

/// Appends the CRC-32 of all bytes so far.
inline void append_checksum(std::string& out) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(out.data());
  append_number(out, crc32({bytes, out.size()}), 4);
}

}  // namespace arcspan::tools
