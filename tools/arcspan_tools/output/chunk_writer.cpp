// SPDX-License-Identifier: MIT
#include <arcspan/model/chunk_list.hpp>

#include <arcspan_tools/output/bytes.hpp>
#include <arcspan_tools/output/chunk_writer.hpp>
#include <arcspan_tools/support/failure.hpp>

namespace arcspan::tools {
namespace {

std::size_t aligned(std::size_t bytes) {
  return (bytes + chunk_list::kAlignment - 1) / chunk_list::kAlignment * chunk_list::kAlignment;
}

void append_tag(std::string& out, std::uint32_t tag) {
  for (const int shift : {24, 16, 8, 0}) append_number(out, tag >> shift, 1);
}

}  // namespace

std::string chunk_file(const std::vector<FileChunk>& chunks) {
  if (chunks.size() > 0xFFFF) throw Failure("model", "too many parts and textures for a binary");
  std::size_t begin = chunk_list::kHeaderBytes + chunks.size() * chunk_list::kEntryBytes;
  std::size_t size = begin + chunk_list::kChecksumBytes;
  for (const FileChunk& chunk : chunks) size += aligned(chunk.bytes.size());
  if (size > 0xFFFFFFFF) throw Failure("model", "too large for a binary, 4 GB or more");
  std::string out;
  append_number(out, chunk_list::kMagic, 4);
  append_number(out, chunk_list::kVersion, 2);
  append_number(out, chunks.size(), 2);
  append_number(out, size, 4);
  for (const FileChunk& chunk : chunks) {
    append_tag(out, chunk.tag);
    for (const std::size_t value : {chunk.number, begin, chunk.bytes.size()}) append_number(out, value, 4);
    begin += aligned(chunk.bytes.size());
  }
  for (const FileChunk& chunk : chunks) {
    out += chunk.bytes;
    out.resize(aligned(out.size()), '\0');
  }
  append_checksum(out);
  return out;
}

}  // namespace arcspan::tools
