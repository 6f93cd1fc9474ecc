// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/crc32.hpp>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <vector>

/// Model binaries written from docs/model-binary.md, without the tools.
namespace arcspan::test {

using Bytes = std::vector<std::uint8_t>;

inline void append(Bytes& out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

inline void append_u16(Bytes& out, std::initializer_list<int> values) {
  for (const int value : values) append(out, static_cast<std::uint16_t>(value), 2);
}

inline void put(Bytes& out, std::size_t at, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i)
    out.at(at + static_cast<std::size_t>(i)) = static_cast<std::uint8_t>(value >> (8 * i));
}

/// A chunk to be written.
struct TestChunk {
  std::string_view tag;
  std::uint32_t number;
  Bytes bytes;
};

/// Makes the last four bytes the checksum of those before them.
inline void close(Bytes& file) {
  const std::size_t covered = file.size() - 4;
  put(file, covered, crc32({file.data(), covered}), 4);
}

/// The offset of the table's entry for chunk i.
inline std::size_t entry_at(std::size_t i) { return 12 + 16 * i; }

/// A file of these chunks in this order.
inline Bytes file_of(const std::vector<TestChunk>& chunks) {
  Bytes file{'A', 'R', 'C', 'P', 3, 0};
  append(file, chunks.size(), 2);
  file.resize(entry_at(chunks.size()));
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    const TestChunk& chunk = chunks[i];
    for (std::size_t c = 0; c < 4; ++c) file[entry_at(i) + c] = static_cast<std::uint8_t>(chunk.tag[c]);
    put(file, entry_at(i) + 4, chunk.number, 4);
    put(file, entry_at(i) + 8, file.size(), 4);
    put(file, entry_at(i) + 12, chunk.bytes.size(), 4);
    file.insert(file.end(), chunk.bytes.begin(), chunk.bytes.end());
    file.resize((file.size() + 3) / 4 * 4);
  }
  put(file, 8, file.size() + 4, 4);
  file.resize(file.size() + 4);
  close(file);
  return file;
}

}  // namespace arcspan::test
