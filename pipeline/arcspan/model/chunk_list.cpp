// SPDX-License-Identifier: MIT
#include <arcspan/mesh/crc32.hpp>
#include <arcspan/model/chunk_list.hpp>
#include <arcspan/numbers/little_endian.hpp>

#include <bit>

namespace arcspan {

namespace {

/// Tag and number of the chunk of an entry, by which chunks are ordered.
std::uint64_t key_of(std::uint32_t tag, std::uint32_t number) { return (std::uint64_t{tag} << 32) | number; }

std::uint32_t tag_at(const std::uint8_t* entry) {
  const auto* const tag = entry + chunk_list::kTagAt;
  return chunk_tag(static_cast<char>(tag[0]), static_cast<char>(tag[1]), static_cast<char>(tag[2]),
                   static_cast<char>(tag[3]));
}

std::uint64_t key_at(const std::uint8_t* entry) {
  return key_of(tag_at(entry), little_u32(entry + chunk_list::kNumberAt));
}

const std::uint8_t* entry_at(const std::uint8_t* binary, std::size_t i) {
  return binary + chunk_list::kHeaderBytes + i * chunk_list::kEntryBytes;
}

/// Checks what the header says, of a binary that is long enough to have one.
Status check_header(std::span<const std::uint8_t> bytes) {
  const std::uint8_t* const at = bytes.data();
  if (little_u16(at + chunk_list::kVersionAt) != chunk_list::kVersion) return Status::kUnsupported;
  const std::uint32_t size = little_u32(at + chunk_list::kSizeAt);
  const std::uint32_t table =  // below 2^21, for which std::size_t may be too short
      std::uint32_t{little_u16(at + chunk_list::kChunksAt)} * std::uint32_t{chunk_list::kEntryBytes} +
      std::uint32_t{chunk_list::kHeaderBytes};
  if (size < table + chunk_list::kChecksumBytes) return Status::kCorrupted;
  return bytes.size() < size ? Status::kTruncated : Status::kOk;
}

/// Whether all chunks are in order and lie before `end`.
bool has_valid_table(const std::uint8_t* binary, std::size_t count, std::uint32_t end) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* const entry = entry_at(binary, i);
    const std::uint32_t begin = little_u32(entry + chunk_list::kBeginAt);
    if (i != 0 && key_at(entry - chunk_list::kEntryBytes) >= key_at(entry)) return false;
    if (begin % chunk_list::kAlignment != 0 || begin > end ||
        little_u32(entry + chunk_list::kBytesAt) > end - begin)
      return false;
  }
  return true;
}

}  // namespace

Chunk ChunkList::operator[](std::size_t i) const {
  const std::uint8_t* const entry = entry_at(binary_, i);
  // Offsets and sizes fit std::size_t, because the whole binary is in memory.
  return {tag_at(entry),
          little_u32(entry + chunk_list::kNumberAt),
          {binary_ + static_cast<std::size_t>(little_u32(entry + chunk_list::kBeginAt)),
           static_cast<std::size_t>(little_u32(entry + chunk_list::kBytesAt))}};
}

std::span<const std::uint8_t> ChunkList::find(std::uint32_t tag, std::uint32_t number) const {
  const std::uint64_t wanted = key_of(tag, number);
  std::size_t low = 0;
  std::size_t high = count_;
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (key_at(entry_at(binary_, middle)) < wanted) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  if (low == count_ || key_at(entry_at(binary_, low)) != wanted) return {};
  return (*this)[low].bytes;
}

Status view_chunk_list(std::span<const std::uint8_t> bytes, ChunkList& list) {
  if (std::endian::native != std::endian::little) return Status::kUnsupported;
  const std::uint8_t* const at = bytes.data();
  if (reinterpret_cast<std::uintptr_t>(at) % chunk_list::kAlignment != 0) return Status::kInvalidArgument;
  if (bytes.size() >= chunk_list::kVersionAt && little_u32(at + chunk_list::kMagicAt) != chunk_list::kMagic)
    return Status::kUnsupported;
  if (bytes.size() < chunk_list::kHeaderBytes) return Status::kTruncated;
  const Status status = check_header(bytes);
  if (!ok(status)) return status;
  const std::size_t covered =
      static_cast<std::size_t>(little_u32(at + chunk_list::kSizeAt)) - chunk_list::kChecksumBytes;
  const std::size_t count = little_u16(at + chunk_list::kChunksAt);
  if (crc32(bytes.first(covered)) != little_u32(at + covered) ||
      !has_valid_table(at, count, static_cast<std::uint32_t>(covered)))
    return Status::kCorrupted;
  list.binary_ = at;
  list.count_ = count;
  return Status::kOk;
}

}  // namespace arcspan
