// SPDX-License-Identifier: MIT
// Arbitrary bytes as a mesh binary. If the first byte is odd, size and checksum are made right, so that what
// lies behind them is reached. A binary is either refused or every vertex and index of it can be read; the
// bytes lie in memory of exactly their size, so that the address sanitizer sees one read too many.
#include <arcspan/mesh/crc32.hpp>
#include <arcspan/mesh/mesh_binary.hpp>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>

using namespace arcspan;

namespace {

void require(bool promise) {
  if (!promise) std::abort();
}

void put_u32(std::uint8_t* at, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) at[i] = static_cast<std::uint8_t>(value >> (8 * i));
}

void make_right(std::uint8_t* bytes, std::size_t size) {
  if (size < mesh_binary::kHeaderBytes + mesh_binary::kChecksumBytes) return;
  std::memcpy(bytes, "ARCM", 4);
  bytes[mesh_binary::kVersionAt] = static_cast<std::uint8_t>(1 + (bytes[mesh_binary::kVersionAt] & 1u));
  bytes[mesh_binary::kVersionAt + 1] = 0;
  put_u32(bytes + mesh_binary::kSizeAt, static_cast<std::uint32_t>(size));
  const std::size_t covered = size - mesh_binary::kChecksumBytes;
  put_u32(bytes + covered, crc32({bytes, covered}));
}

void read_all(const MeshView& mesh) {
  std::int32_t sum = 0;
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    sum += mesh.position(i).x + mesh.position(i).z + mesh.normal(i).u + mesh.normal(i).v;
  }
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    if (mesh.planes() != nullptr) sum += mesh.planes()[i].x + mesh.planes()[i].offset;
    const TriangleIndices t = mesh.triangle(i);
    require(t.a < mesh.vertex_count() && t.b < mesh.vertex_count() && t.c < mesh.vertex_count());
  }
  [[maybe_unused]] static volatile std::int32_t kept;  // the reads must stay
  kept = sum;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  const std::size_t length = size - 1;
  const std::unique_ptr<std::uint8_t, decltype(&std::free)> bytes(
      static_cast<std::uint8_t*>(std::malloc(length)), &std::free);
  if (length > 0) std::memcpy(bytes.get(), data + 1, length);
  if ((data[0] & 1u) != 0) make_right(bytes.get(), length);
  MeshView mesh;
  const Status status = view_mesh_binary({bytes.get(), length}, mesh);
  if (ok(status)) {
    read_all(mesh);
  } else {
    require(mesh.vertex_count() == 0 && mesh.triangle_count() == 0 && mesh.planes() == nullptr);
  }
  return 0;
}
