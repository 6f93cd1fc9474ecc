// SPDX-License-Identifier: MIT
// What must hold bit for bit: seams, reversibility, flat surfaces.
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/arc/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/probe.hpp>
#include <tests/support/raster_stage.hpp>
#include <tests/support/test_share.hpp>
#include <tests/support/vec3.hpp>

#include <algorithm>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Method = Arc<Probe>;
using Vertex = RasterVertex<Method>;

Vertex random_vertex(Random& random, const Probe& probe, Vec3 around, double cone, std::int32_t reach) {
  const auto coordinate = [&] { return static_cast<std::int16_t>(random.integer(-reach, reach - 1)); };
  const Direction normal = to_direction(tilted(random, around, cone * random.unit()));
  return {{coordinate(), coordinate(), 0}, Method::shade_vertex(probe, normal)};
}

/// The arc of the edge between two vertices, as a command has it.
const ArcEdge<3>* edge_between(const Vertex& p, const Vertex& q, const Vertex* const v[3],
                               const TriangleCommand<Method>& command) {
  const Vertex* sorted[3] = {v[0], v[1], v[2]};
  std::stable_sort(sorted, sorted + 3,
                   [](const Vertex* a, const Vertex* b) { return a->position.y < b->position.y; });
  const auto is = [&](const Vertex* a, const Vertex* b) {
    return (a == &p && b == &q) || (a == &q && b == &p);
  };
  if (command.shade.path != Method::Path::kWide || command.shade.wide.is_very_wide) return nullptr;
  const WideTriangle<3>& arcs = command.shade.wide.wide;
  if (is(sorted[0], sorted[2])) return &arcs.long_edge;
  if (is(sorted[0], sorted[1])) return command.first_row < command.middle_row ? &arcs.upper_edge : nullptr;
  return command.middle_row < command.end_row ? &arcs.lower_edge : nullptr;
}

bool same(const ArcEdge<3>& a, const ArcEdge<3>& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.on_chord[i].x != b.on_chord[i].x || a.on_chord[i].step != b.on_chord[i].step) return false;
  }
  return a.base == b.base && a.fraction.t == b.fraction.t && a.fraction.dt == b.fraction.dt &&
         a.shape.excess(Factor::of(0.5)) == b.shape.excess(Factor::of(0.5));
}

}  // namespace

TEST_CASE("the two triangles of an edge have the same scalars along it, bit for bit") {
  Random random(61);
  const RowRange rows{-120, 120};  // many edges begin above the viewport
  int compared = 0;
  int different = 0;
  for (int i = 0; i < share_of(100000); ++i) {
    Probe probe;
    for (Direction& axis : probe.axes) axis = to_direction(random_unit(random));
    const Vec3 around = random_unit(random);
    const std::int32_t reach = random.integer(16, 6000);
    const double cone = radians(random.real(0, 30));
    const Vertex p = random_vertex(random, probe, around, cone, reach);
    const Vertex q = random_vertex(random, probe, around, cone, reach);
    const Vertex r = random_vertex(random, probe, around, cone, reach);
    const Vertex s = random_vertex(random, probe, around, cone, reach);
    // Equal heights make "the" long edge a matter of order; the next test draws such ones.
    if (p.position.y == q.position.y || r.position.y == p.position.y || r.position.y == q.position.y ||
        s.position.y == p.position.y || s.position.y == q.position.y) {
      continue;
    }
    TriangleCommand<Method> one;
    TriangleCommand<Method> other;
    if (!prepare_triangle({}, p, q, r, {}, rows, one) || !prepare_triangle({}, q, p, s, {}, rows, other))
      continue;
    const Vertex* const first[3] = {&p, &q, &r};
    const Vertex* const second[3] = {&q, &p, &s};
    const ArcEdge<3>* const a = edge_between(p, q, first, one);
    const ArcEdge<3>* const b = edge_between(p, q, second, other);
    if (a == nullptr || b == nullptr) continue;
    ++compared;
    different += same(*a, *b) ? 0 : 1;
  }
  CHECK(compared > share_of(20000));
  CHECK(different == 0);
}

TEST_CASE("the two patches of an edge have the same scalars along it") {
  Random random(64);
  const RowRange rows{-120, 120};
  int compared = 0;
  double worst = 0;
  for (int i = 0; i < share_of(100000); ++i) {
    Probe probe;
    for (Direction& axis : probe.axes) axis = to_direction(random_unit(random));
    const Vec3 around = random_unit(random);
    const std::int32_t reach = random.integer(16, 2000);
    const double cone = radians(random.real(0, 8));
    const Vertex p = random_vertex(random, probe, around, cone, reach);
    const Vertex q = random_vertex(random, probe, around, cone, reach);
    const Vertex r = random_vertex(random, probe, around, cone, reach);
    const Vertex s = random_vertex(random, probe, around, cone, reach);
    TriangleCommand<Method> right;
    TriangleCommand<Method> left;
    if (!prepare_triangle({}, p, q, r, {}, rows, right) || !prepare_triangle({}, q, p, s, {}, rows, left)) {
      continue;
    }
    if (right.shade.path != Method::Path::kPatch || left.shade.path != Method::Path::kPatch) continue;
    // pq is the long edge of both, on the left of one and on the right of the other.
    const std::int32_t top = std::min(p.position.y, q.position.y);
    const std::int32_t bottom = std::max(p.position.y, q.position.y);
    if (r.position.y <= top || r.position.y >= bottom || s.position.y <= top || s.position.y >= bottom ||
        right.middle_left || !left.middle_left) {
      continue;
    }
    for (std::int32_t row = left.first_row; row < left.end_row; ++row) {
      if (row == left.middle_row) {
        left.left = left.lower;
        for (PatchScalar& scalar : left.shade.patch) scalar.left.become(scalar.lower);
      }
      const double width = static_cast<double>(left.right.x - left.left.x) / 4294967296.0;
      for (std::size_t k = 0; k < 3; ++k) {
        PatchScalar& scalar = left.shade.patch[k];
        PatchEdge& on = right.shade.patch[k].left;
        const double there = to_double(scalar.left.at) + width * to_double(scalar.left.slope) +
                             width * width / 2 * to_double(scalar.second_difference);
        worst = std::max(worst, std::abs(there - to_double(on.at)));
        scalar.left.advance();
        on.advance();
      }
      left.left.advance();
      left.right.advance();
    }
    ++compared;
  }
  CAPTURE(worst);
  CHECK(compared > share_of(2000));
  CHECK(worst < 3e-5);
}

TEST_CASE("a flat surface is exactly constant") {
  Random random(63);
  StrictSink sink({0, 0, 128, 128});
  std::uint64_t pixels = 0;
  std::int32_t largest = 0;
  std::vector<ProbeSample> samples;
  Probe probe;
  Probe::Blinn dark;
  Probe::Phong dark_phong;
  probe.matt = probe.blinn = &dark;
  probe.phong = &dark_phong;
  probe.samples = &samples;
  for (int i = 0; i < share_of(4000); ++i) {
    for (Direction& axis : probe.axes) axis = to_direction(random_unit(random));
    const Vec3 normal = random_unit(random);
    const Vertex v[3] = {random_vertex(random, probe, normal, 0, 1024),
                         random_vertex(random, probe, normal, 0, 1024),
                         random_vertex(random, probe, normal, 0, 1024)};
    samples.clear();
    RasterStage<Method, StrictSink> stage(sink, 128, 128, probe);
    stage.draw(v[0], v[1], v[2]);
    for (const ProbeSample& sample : samples) {
      for (std::size_t k = 0; k < 3; ++k) {
        largest = std::max(largest, std::abs(sample.scalars[k].raw() - v[0].shade.scalars[k].raw()));
      }
    }
    pixels += samples.size();
  }
  CHECK(pixels > static_cast<std::uint64_t>(share_of(1000000)));
  // Halving the two ends for their mean may drop the last of 30 bits, once on the edge and once on the row.
  CHECK(largest <= 2);
}

TEST_CASE("a pixel in a corner has the corner's scalars") {
  Random random(64);
  StrictSink sink({0, 0, 128, 128});
  std::vector<ProbeSample> samples;
  Probe probe;
  Probe::Blinn dark;
  Probe::Phong dark_phong;
  probe.matt = probe.blinn = &dark;
  probe.phong = &dark_phong;
  probe.samples = &samples;
  double worst = 0;
  int hits = 0;
  for (int i = 0; i < share_of(20000); ++i) {
    for (Direction& axis : probe.axes) axis = to_direction(random_unit(random));
    const Vec3 around = random_unit(random);
    Vertex v[3] = {random_vertex(random, probe, around, 0.25, 1000),
                   random_vertex(random, probe, around, 0.25, 1000),
                   random_vertex(random, probe, around, 0.25, 1000)};
    // The first corner on a pixel's centre; the pixel is drawn if the corner is top-left.
    v[0].position = {static_cast<std::int16_t>((v[0].position.x & ~15) | 8),
                     static_cast<std::int16_t>((v[0].position.y & ~15) | 8), 0};
    samples.clear();
    sink.clear();
    RasterStage<Method, StrictSink> stage(sink, 128, 128, probe);
    stage.draw(v[0], v[1], v[2]);
    const std::int32_t x = (v[0].position.x >> 4) + 64;
    const std::int32_t y = (v[0].position.y >> 4) + 64;
    if (sink.cell(x, y).count == 0) continue;
    // Its sample is the one after those of the drawn pixels before it in reading order.
    std::size_t before = 0;
    for (std::int32_t j = 0; j <= y; ++j) {
      for (std::int32_t k = 0; k < (j < y ? 128 : x); ++k) before += sink.cell(k, j).count;
    }
    ++hits;
    for (std::size_t k = 0; k < 3; ++k) {
      worst = std::max(worst,
                       std::abs(to_double(samples.at(before).scalars[k]) - to_double(v[0].shade.scalars[k])));
    }
  }
  CHECK(hits > share_of(2000));
  CHECK(worst < 0x1p-12);
}
