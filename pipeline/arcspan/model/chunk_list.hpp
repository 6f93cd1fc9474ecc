// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// The layout of the container of a model binary (docs/model-binary.md): little-endian, offsets in bytes. A
/// header, a table with an entry for each chunk, the chunks, and a checksum.
namespace chunk_list {
inline constexpr std::uint32_t kMagic = 0x50435241;  ///< "ARCP"
inline constexpr std::uint16_t kVersion = 3;         ///< 1 and 2 had no chunks

inline constexpr std::size_t kMagicAt = 0;    ///< u32
inline constexpr std::size_t kVersionAt = 4;  ///< u16
inline constexpr std::size_t kChunksAt = 6;   ///< u16, number of chunks
inline constexpr std::size_t kSizeAt = 8;     ///< u32, bytes of the whole binary
inline constexpr std::size_t kHeaderBytes = 12;

inline constexpr std::size_t kTagAt = 0;     ///< 4 characters
inline constexpr std::size_t kNumberAt = 4;  ///< u32, among the chunks of its tag
inline constexpr std::size_t kBeginAt = 8;   ///< u32, where the chunk begins, a multiple of kAlignment
inline constexpr std::size_t kBytesAt = 12;  ///< u32, its size
inline constexpr std::size_t kEntryBytes = 16;

inline constexpr std::size_t kAlignment = 4;      ///< of the binary in memory, and of a chunk in it
inline constexpr std::size_t kChecksumBytes = 4;  ///< u32, crc32() of all bytes before it
}  // namespace chunk_list

/// A tag of four characters as a number. Numbers are in alphabetical order.
[[nodiscard]] constexpr std::uint32_t chunk_tag(char a, char b, char c, char d) {
  const auto code = [](char character) { return std::uint32_t{static_cast<std::uint8_t>(character)}; };
  return (code(a) << 24) | (code(b) << 16) | (code(c) << 8) | code(d);
}

/// A piece of a binary. What it holds and what its number counts is a matter of its tag.
struct Chunk {
  std::uint32_t tag = 0;  ///< see chunk_tag()
  std::uint32_t number = 0;
  std::span<const std::uint8_t> bytes;  ///< at a multiple of chunk_list::kAlignment
};

/// A view of the chunks of a binary, in the order of their tags and, within a tag, of their numbers. No two
/// have the same tag and number. The binary must outlive it.
class ChunkList {
 public:
  [[nodiscard]] std::size_t size() const { return count_; }
  /// Chunk `i`, which must be below size().
  [[nodiscard]] Chunk operator[](std::size_t i) const;
  /// The bytes of a chunk, whose data() is null if there is none. The time is logarithmic in size().
  [[nodiscard]] std::span<const std::uint8_t> find(std::uint32_t tag, std::uint32_t number = 0) const;

 private:
  friend Status view_chunk_list(std::span<const std::uint8_t> bytes, ChunkList& list);

  const std::uint8_t* binary_ = nullptr;
  std::size_t count_ = 0;
};

/// Makes a view of the chunks of a binary. `bytes` may be longer than the binary. All of it is read once, for
/// the checksum; what the chunks hold is not looked at. Returns:
///
///   kOk                `list` is set; otherwise it is not changed
///   kInvalidArgument   `bytes` does not begin at a multiple of chunk_list::kAlignment
///   kUnsupported       the magic number or the version is another, or this machine is big-endian
///   kTruncated         there are fewer bytes than a header has, or than the header states
///   kCorrupted         the checksum is wrong, chunks are not in order, begin at another place than a
///                      multiple of chunk_list::kAlignment, or do not lie within the binary
[[nodiscard]] Status view_chunk_list(std::span<const std::uint8_t> bytes, ChunkList& list);

}  // namespace arcspan
