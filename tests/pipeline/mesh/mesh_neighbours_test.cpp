// SPDX-License-Identifier: MIT
// Neighbours written by hand: what they say, and each reason to refuse them.
#include <arcspan/mesh/mesh_neighbours.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <span>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr unsigned kBorder = 0;
constexpr unsigned kEarlier = 1;
constexpr unsigned kLater = 2;
constexpr unsigned kCrease = 3;

constexpr std::uint8_t kinds(unsigned ab, unsigned bc, unsigned ca) {
  return static_cast<std::uint8_t>(ab | (bc << 2) | (ca << 4));
}

/// A square of two triangles, (0, 1, 2) and (0, 2, 3).
constexpr ObjectPosition kCorners[] = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}};
constexpr PackedNormal kNormals[4] = {};
constexpr std::uint8_t kIndices[] = {0, 1, 2, 0, 2, 3};
constexpr MeshView kSquare = MeshView::of(kCorners, kNormals, kIndices);
constexpr std::uint8_t kOfSquare[] = {kinds(kBorder, kBorder, kLater), 0, kinds(kEarlier, kBorder, kBorder)};
constexpr MeshNeighbours kNeighbours = MeshNeighbours::of(kSquare, kOfSquare);
static_assert(kNeighbours.triangle_count() == 2);

Status made(const MeshView& mesh, const Bytes& bytes) {
  MeshNeighbours neighbours = kNeighbours;
  const Status status = MeshNeighbours::make(mesh, bytes, neighbours);
  CHECK(neighbours.bytes() == (ok(status) ? bytes.data() : kOfSquare));
  return status;
}

/// A fan of `count` triangles about one corner, whose last triangle is joined with the first.
TestMesh fan(int count) {
  TestMesh mesh;
  const std::uint16_t middle = mesh.add({0, 0, 0}, {0, 0, 1});
  for (int i = 0; i < count; ++i) {
    const double turn = 2 * std::numbers::pi * i / count;
    mesh.add({20000 * std::cos(turn), 20000 * std::sin(turn), 0}, {0, 0, 1});
  }
  for (int i = 0; i < count; ++i)
    mesh.triangle(middle, static_cast<std::uint16_t>(1 + i), static_cast<std::uint16_t>(1 + (i + 1) % count));
  return mesh;
}

/// The neighbours of a fan: ab of the first is ca of the last, ca of each other is ab of the next.
Bytes neighbours_of_fan(int count) {
  Bytes bytes{kinds(kLater, kBorder, kLater)};
  for (std::size_t far = static_cast<std::size_t>(count) - 2;; far >>= 7) {
    bytes.push_back(static_cast<std::uint8_t>((far & 127) | (far >= 128 ? 128 : 0)));
    if (far < 128) break;
  }
  bytes.push_back(0);
  for (int i = 2; i < count; ++i) {
    bytes.push_back(kinds(kEarlier, kBorder, kLater));
    bytes.push_back(0);
  }
  bytes.push_back(kinds(kEarlier, kBorder, kEarlier));
  return bytes;
}

}  // namespace

TEST_CASE("Neighbours: a distance takes a byte up to 128, two up to 16384 and three above") {
  for (const int count : {3, 129, 130, 16385, 16386, 20000}) {
    CAPTURE(count);
    const TestMesh mesh = fan(count);
    const Bytes bytes = neighbours_of_fan(count);
    const std::size_t of_first = count <= 129 ? 1 : count <= 16385 ? 2 : 3;
    CHECK(bytes.size() == static_cast<std::size_t>(2 * count) - 1 + of_first);
    CHECK(made(mesh.view(), bytes) == Status::kOk);
    const std::uint8_t* at = bytes.data() + 1;
    CHECK(detail::read_distance(at) == static_cast<std::size_t>(count) - 1);
    CHECK(at == bytes.data() + 1 + of_first);
  }
}

TEST_CASE("Neighbours: an edge may be a crease") {
  CHECK(made(kSquare, {kinds(kBorder, kBorder, kCrease), 0, kinds(kEarlier, kBorder, kBorder)}) ==
        Status::kOk);
}

TEST_CASE("Neighbours: positions decide, not indices") {
  static constexpr ObjectPosition kApart[] = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0},
                                              {0, 9, 0}, {0, 0, 0}, {9, 9, 0}};
  static constexpr PackedNormal kSix[6] = {};
  static constexpr std::uint8_t kSplit[] = {0, 1, 2, 4, 5, 3};
  constexpr MeshView kSeam = MeshView::of(kApart, kSix, kSplit);
  CHECK(made(kSeam, {std::begin(kOfSquare), std::end(kOfSquare)}) == Status::kOk);
}

TEST_CASE("Neighbours: an empty mesh has none") {
  CHECK(made(MeshView{}, {}) == Status::kOk);
  CHECK(made(MeshView{}, {0}) == Status::kCorrupted);
  CHECK(MeshNeighbours{}.triangle_count() == 0);
}

TEST_CASE("Neighbours: refused bytes") {
  const std::uint8_t first = kinds(kBorder, kBorder, kLater);
  const std::uint8_t second = kinds(kEarlier, kBorder, kBorder);
  CHECK(made(kSquare, {}) == Status::kCorrupted);
  CHECK(made(kSquare, {first}) == Status::kCorrupted);
  CHECK(made(kSquare, {first, 0}) == Status::kCorrupted);
  CHECK(made(kSquare, {first, 0, second, 0}) == Status::kCorrupted);
  CHECK(made(kSquare, {static_cast<std::uint8_t>(first | 64), 0, second}) == Status::kCorrupted);
  CHECK(made(kSquare, {static_cast<std::uint8_t>(first | 128), 0, second}) == Status::kCorrupted);
  CHECK(made(kSquare, {first, 0, kinds(kBorder, kBorder, kBorder)}) == Status::kCorrupted);
  CHECK(made(kSquare, {0, second}) == Status::kCorrupted);
  CHECK(made(kSquare, {second, second}) == Status::kCorrupted);
  // The distance of an edge: beyond the last triangle, unending, of another edge.
  CHECK(made(kSquare, {first, 1, second}) == Status::kIndexOutOfRange);
  CHECK(made(kSquare, {first, 0xFF, 0xFF, 0xFF, 0xFF, 0x7F, second}) == Status::kIndexOutOfRange);
  CHECK(made(kSquare, {first, 0x80, 0x80, 0x80, 0x80, 0x80, 0, second}) == Status::kCorrupted);
  CHECK(made(kSquare, {kinds(kLater, kBorder, kBorder), 0, second}) == Status::kInvalidArgument);
}

TEST_CASE("Neighbours: bits 6 and 7 count distances of a byte between ordinary edges, or are 0") {
  const auto with_bits = [](Bytes bytes, std::size_t i, unsigned bits) {
    bytes[i] = static_cast<std::uint8_t>(bytes[i] | (bits << 6));
    return bytes;
  };
  // A tetrahedron: its triangles have three, two, one and no later neighbours.
  static constexpr ObjectPosition kTips[] = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9}};
  static constexpr std::uint8_t kFaces[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  static constexpr MeshView kSolid = MeshView::of(kTips, kNormals, kFaces);
  const Bytes solid{kinds(kLater, kLater, kLater),
                    2,
                    1,
                    0,
                    kinds(kEarlier, kLater, kLater),
                    0,
                    1,
                    kinds(kEarlier, kLater, kEarlier),
                    0,
                    kinds(kEarlier, kEarlier, kEarlier)};
  const std::size_t at[] = {0, 4, 7, 9};
  for (unsigned i = 0; i < 4; ++i)
    for (unsigned bits = 0; bits < 4; ++bits)
      CHECK(made(kSolid, with_bits(solid, at[i], bits)) ==
            (bits == 0 || bits == 3 - i ? Status::kOk : Status::kCorrupted));
  // Beside a border, and a crease.
  const Bytes square(std::begin(kOfSquare), std::end(kOfSquare));
  CHECK(made(kSquare, with_bits(square, 0, 1)) == Status::kCorrupted);
  CHECK(made(kSolid, {kinds(kLater, kLater, kCrease), 2, 1, 0, solid[4], 0, 1, solid[7], 0, solid[9]}) ==
        Status::kOk);
  CHECK(made(kSolid, {kinds(kLater, kLater, kCrease) | 3 << 6, 2, 1, 0, solid[4], 0, 1, solid[7], 0,
                      solid[9]}) == Status::kCorrupted);
}

TEST_CASE("Neighbours: bits 6 and 7 do not count distances of two bytes") {
  // Two fans about opposite tips: edges ab lead to the other fan, whose triangles come later.
  constexpr int kCount = 200;
  TestMesh mesh;
  const std::uint16_t upper = mesh.add({0, 0, 20000}, {0, 0, 1});
  const std::uint16_t lower = mesh.add({0, 0, -20000}, {0, 0, -1});
  for (int i = 0; i < kCount; ++i) {
    const double turn = 2 * std::numbers::pi * i / kCount;
    mesh.add({20000 * std::cos(turn), 20000 * std::sin(turn), 0}, {0, 0, 1});
  }
  const auto rim = [](int i) { return static_cast<std::uint16_t>(2 + i % kCount); };
  for (int i = 0; i < kCount; ++i) mesh.triangle(rim(i), rim(i + 1), upper);
  for (int i = 0; i < kCount; ++i) mesh.triangle(rim(i + 1), rim(i), lower);
  Bytes bytes;
  const auto edges = [&](unsigned ab, unsigned bc, unsigned ca) { bytes.push_back(kinds(ab, bc, ca)); };
  const auto far = [&](int distance) {
    if (distance > 128) bytes.push_back(static_cast<std::uint8_t>((distance - 1) | 128));
    bytes.push_back(static_cast<std::uint8_t>(distance > 128 ? (distance - 1) >> 7 : distance - 1));
  };
  for (int i = 0; i < kCount; ++i) {
    edges(kLater, i == kCount - 1 ? kEarlier : kLater, i == 0 ? kLater : kEarlier);
    far(kCount);
    if (i != kCount - 1) far(1);
    if (i == 0) far(kCount - 1);
  }
  for (int i = 0; i < kCount; ++i) {
    edges(kEarlier, i == 0 ? kLater : kEarlier, i == kCount - 1 ? kEarlier : kLater);
    if (i == 0) far(kCount - 1);
    if (i != kCount - 1) far(1);
  }
  CHECK(made(mesh.view(), bytes) == Status::kOk);
  bytes[0] |= 3u << 6;
  CHECK(made(mesh.view(), bytes) == Status::kCorrupted);
}

TEST_CASE("Neighbours: those of another mesh are refused") {
  const Bytes bytes = neighbours_of_fan(40);
  TestMesh other = fan(40);
  std::swap(other.indices[3], other.indices[4]);
  CHECK(made(other.view(), bytes) == Status::kInvalidArgument);
  CHECK(made(fan(39).view(), bytes) != Status::kOk);
  CHECK(made(fan(41).view(), bytes) != Status::kOk);
}

TEST_CASE("Neighbours: damaged bytes are refused, or name triangles of the mesh") {
  const TestMesh mesh = fan(200);
  const MeshView view = mesh.view();
  const Bytes whole = neighbours_of_fan(200);
  Random random(46);
  for (int i = 0; i < share_of(20000); ++i) {
    Bytes bytes = whole;
    for (int changes = random.integer(1, 3); changes > 0; --changes)
      bytes[static_cast<std::size_t>(random.integer(0, static_cast<int>(bytes.size()) - 1))] =
          static_cast<std::uint8_t>(random.integer(0, 255));
    MeshNeighbours neighbours;
    if (!ok(MeshNeighbours::make(view, bytes, neighbours))) continue;
    const std::uint8_t* at = neighbours.bytes();
    for (std::size_t t = 0; t < view.triangle_count(); ++t) {
      const std::uint8_t* const first = at;
      const unsigned of_triangle = *at++;
      for (unsigned edge = 0; edge < 3; ++edge) {
        if (!detail::has_distance(detail::edge_kind(of_triangle, edge))) continue;
        if (t + detail::read_distance(at) >= view.triangle_count()) FAIL("beyond the last triangle");
      }
      const unsigned distances = detail::short_distances(of_triangle);
      if (distances != 0 && at != first + 1 + distances) FAIL("other distances than bits 6 and 7 say");
    }
    CHECK(at == bytes.data() + bytes.size());
  }
}
