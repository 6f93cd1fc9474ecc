// SPDX-License-Identifier: MIT
// The container of model binaries: chunks of any tags, each reason to refuse one, and damaged bytes.
#include <arcspan/model/chunk_list.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/model/chunk_bytes.hpp>

using namespace arcspan;
using namespace arcspan::test;

namespace {

const std::vector<TestChunk> kChunks{
    {"CLIP", 0, {1, 2, 3}}, {"CLIP", 7, {4}}, {"CLIQ", 0, {}}, {"DATA", 1, {5, 6, 7, 8, 9}}};

Status status_of(const Bytes& file) {
  ChunkList list;
  const Status status = view_chunk_list(file, list);
  if (!ok(status)) CHECK(list.size() == 0);
  return status;
}

/// The status of the file of kChunks after a change, with a right checksum.
Status status_with(std::size_t at, std::uint64_t value, int bytes) {
  Bytes file = file_of(kChunks);
  put(file, at, value, bytes);
  close(file);
  return status_of(file);
}

Bytes bytes_of(std::span<const std::uint8_t> span) { return {span.begin(), span.end()}; }

}  // namespace

TEST_CASE("chunks are found by tag and number, where they lie") {
  const Bytes file = file_of(kChunks);
  ChunkList list;
  REQUIRE(ok(view_chunk_list(file, list)));
  REQUIRE(list.size() == kChunks.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    const TestChunk& written = kChunks[i];
    const std::uint32_t tag = chunk_tag(written.tag[0], written.tag[1], written.tag[2], written.tag[3]);
    CHECK(list[i].tag == tag);
    CHECK(list[i].number == written.number);
    CHECK(bytes_of(list[i].bytes) == written.bytes);
    CHECK(list.find(tag, written.number).data() == list[i].bytes.data());
    CHECK(list.find(tag, written.number).size() == written.bytes.size());
    CHECK(static_cast<std::size_t>(list[i].bytes.data() - file.data()) % 4 == 0);
  }
  CHECK(list.find(chunk_tag('C', 'L', 'I', 'P'), 1).data() == nullptr);
  CHECK(list.find(chunk_tag('C', 'L', 'I', 'P'), 8).data() == nullptr);
  CHECK(list.find(chunk_tag('A', 'A', 'A', 'A')).data() == nullptr);
  CHECK(list.find(chunk_tag('Z', 'Z', 'Z', 'Z')).data() == nullptr);
  CHECK(list.find(chunk_tag('C', 'L', 'I', 'Q')).data() != nullptr);  // it is there, and empty
}

TEST_CASE("a container may have no chunks, and be followed by anything") {
  Bytes file = file_of({});
  CHECK(file.size() == 16);
  file.resize(4096, 0xFF);
  ChunkList list;
  REQUIRE(ok(view_chunk_list(file, list)));
  CHECK(list.size() == 0);
  CHECK(list.find(chunk_tag('M', 'E', 'S', 'H')).data() == nullptr);
  CHECK(ChunkList().find(chunk_tag('M', 'E', 'S', 'H')).data() == nullptr);
}

TEST_CASE("a malformed container gives the status that names its mistake") {
  REQUIRE(ok(status_with(4, 3, 2)));
  CHECK(status_with(0, 'B', 1) == Status::kUnsupported);
  CHECK(status_with(4, 2, 2) == Status::kUnsupported);  // the version
  CHECK(status_with(4, 4, 2) == Status::kUnsupported);
  CHECK(status_with(6, 0xFFFF, 2) == Status::kCorrupted);  // more chunks than there is room for
  CHECK(status_with(6, 9, 2) == Status::kCorrupted);       // the table would end in the checksum
  CHECK(status_with(8, 0, 4) == Status::kCorrupted);       // the size
  CHECK(status_with(8, 4096, 4) == Status::kTruncated);
  CHECK(status_with(8, 0xFFFFFFFF, 4) == Status::kTruncated);
}

TEST_CASE("the chunks of a container are in order, and no two have one name") {
  CHECK(status_with(entry_at(0) + 4, 6, 4) == Status::kOk);
  CHECK(status_with(entry_at(0) + 4, 7, 4) == Status::kCorrupted);  // two chunks 7 of CLIP
  CHECK(status_with(entry_at(0) + 4, 8, 4) == Status::kCorrupted);
  CHECK(status_with(entry_at(2) + 3, 'P', 1) == Status::kCorrupted);  // CLIP 0 after CLIP 7
  CHECK(status_with(entry_at(0), 'D', 1) == Status::kCorrupted);
}

TEST_CASE("the chunks of a container lie within it, at multiples of 4") {
  const std::size_t last = entry_at(kChunks.size() - 1);
  const auto end = static_cast<std::uint32_t>(file_of(kChunks).size() - 4);
  CHECK(status_with(last + 12, 8, 4) == Status::kOk);  // the padding too
  CHECK(status_with(last + 12, 9, 4) == Status::kCorrupted);
  CHECK(status_with(last + 12, 0xFFFFFFFF, 4) == Status::kCorrupted);
  CHECK(status_with(last + 8, end - 6, 4) == Status::kCorrupted);  // no multiple of 4
  CHECK(status_with(entry_at(2) + 8, end, 4) == Status::kOk);      // an empty chunk at the end
  CHECK(status_with(entry_at(2) + 8, end + 4, 4) == Status::kCorrupted);
  CHECK(status_with(last + 8, 0xFFFFFFFC, 4) == Status::kCorrupted);  // begin + size overflows
}

TEST_CASE("every changed bit of a container is found, and every truncation") {
  const Bytes good = file_of(kChunks);
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    CAPTURE(bit);
    Bytes file = good;
    file[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
    CHECK_FALSE(ok(status_of(file)));
  }
  for (std::size_t size = 0; size < good.size(); ++size) {
    CAPTURE(size);
    CHECK(status_of(Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size))) ==
          Status::kTruncated);
  }
}

TEST_CASE("a container at an address that is no multiple of 4 is refused") {
  const Bytes good = file_of(kChunks);
  for (const std::size_t by : {1u, 2u, 3u}) {
    Bytes moved(by);
    moved.insert(moved.end(), good.begin(), good.end());
    ChunkList list;
    CHECK(view_chunk_list(std::span<const std::uint8_t>(moved).subspan(by), list) ==
          Status::kInvalidArgument);
  }
}
