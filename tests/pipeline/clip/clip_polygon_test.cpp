// SPDX-License-Identifier: MIT
// Clipping against the same planes in double precision.
#include <arcspan/clip/clip_polygon.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/raster_stage.hpp>
#include <tests/support/test_share.hpp>
#include <tests/support/vec3.hpp>

#include <algorithm>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;
using Polygon = ClipPolygon<Silhouette>;

namespace {

constexpr int kPlanes = 6;

/// (x, y, w) in a Vec3, w in its z.
double distance(Vec3 p, int plane, const WRange& w_range) {
  switch (plane) {
    case 0:
      return p.z - w_range.nearest;
    case 1:
      return p.z + p.x;
    case 2:
      return p.z - p.x;
    case 3:
      return p.z + p.y;
    case 4:
      return p.z - p.y;
    default:
      return w_range.farthest - p.z;
  }
}

std::vector<Vec3> clipped(std::vector<Vec3> polygon, const WRange& w_range) {
  for (int plane = 0; plane < kPlanes; ++plane) {
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec3 a = polygon[i];
      const Vec3 b = polygon[(i + 1) % polygon.size()];
      const double da = distance(a, plane, w_range);
      const double db = distance(b, plane, w_range);
      if (da >= 0) kept.push_back(a);
      if ((da >= 0) != (db >= 0)) kept.push_back(a + (da / (da - db)) * (b - a));
    }
    polygon = kept;
  }
  return polygon;
}

struct Outline {
  double area = 0;
  double perimeter = 0;
};

/// On the screen, in 16ths of a pixel.
Outline outline(const std::vector<Vec3>& polygon) {
  Outline o;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 p = polygon[i];
    const Vec3 q = polygon[(i + 1) % polygon.size()];
    const double px = 16384 * p.x / p.z;
    const double py = 16384 * p.y / p.z;
    const double qx = 16384 * q.x / q.z;
    const double qy = 16384 * q.y / q.z;
    o.area += (px * qy - qx * py) / 2;
    o.perimeter += std::hypot(qx - px, qy - py);
  }
  return o;
}

std::int32_t random_coordinate(Random& random, double size) {
  return static_cast<std::int32_t>(random.real(-size, size));
}

ClipPosition random_clip_position(Random& random, const WRange& w_range) {
  const double size = random.decades(1 << 18, 1 << 29);
  ClipPosition p{random_coordinate(random, size), random_coordinate(random, size),
                 random_coordinate(random, size)};
  switch (random.integer(0, 9)) {
    case 0:
      p.w = random.chance(0.5) ? w_range.nearest : w_range.farthest;
      break;
    case 1:
      p.x = p.w;
      break;
    case 2:
      p.y = -p.w;
      break;
    case 3:
      p = {0, 0, p.w};
      break;
    case 4:
      p.w = std::abs(p.w);
      p.x /= 1024;
      p.y /= 1024;
      break;
    default:
      break;
  }
  return p;
}

}  // namespace

TEST_CASE("clipping agrees with double precision, within capacity and within the planes") {
  Random random(91);
  int survivors = 0;
  std::size_t most = 0;
  double worst_plane = 0;  // units beyond a plane
  double worst_area = 0;   // difference of area per length of outline, in sixteenths
  for (int i = 0; i < share_of(300000); ++i) {
    const std::int32_t near_w = random.integer(1 << 15, 1 << 20);
    const auto far_w = static_cast<std::int32_t>(random.decades(near_w + 1, 1 << 30));
    const WRange w_range{near_w, far_w};
    Polygon polygon;
    std::vector<Vec3> reference;
    for (std::size_t k = 0; k < 3; ++k) {
      const ClipPosition p = random_clip_position(random, w_range);
      polygon[k].position = p;
      reference.push_back({double(p.x), double(p.y), double(p.w)});
    }
    reference = clipped(reference, w_range);
    clip_polygon(polygon, w_range);
    most = std::max(most, polygon.count());
    std::vector<Vec3> got;
    for (std::size_t k = 0; k < polygon.count(); ++k) {
      const ClipPosition& p = polygon[k].position;
      got.push_back({double(p.x), double(p.y), double(p.w)});
      for (int plane = 0; plane < kPlanes; ++plane) {
        worst_plane = std::max(worst_plane, -distance(got.back(), plane, w_range));
      }
    }
    if (reference.size() < 3 && got.size() < 3) continue;
    ++survivors;
    const Outline truth = outline(reference);
    const Outline ours = outline(got);
    worst_area = std::max(worst_area, std::abs(ours.area - truth.area) / (truth.perimeter + 16));
  }
  CHECK(survivors > share_of(50000));
  CHECK(most <= Polygon::kCapacity);
  CHECK(most >= 7);
  CHECK(worst_plane <= 4);
  CHECK(worst_area < 2);
}

TEST_CASE("a triangle inside stays as it is, one outside vanishes") {
  constexpr WRange kRange{1000, 5000};
  Polygon inside;
  inside[0].position = {-1000, -1000, 1000};
  inside[1].position = {1000, -1000, 1000};
  inside[2].position = {0, 5000, 5000};
  clip_polygon(inside, kRange);
  REQUIRE(inside.count() == 3);
  CHECK(inside[0].position.x == -1000);
  CHECK(inside[2].position.w == 5000);

  for (const ClipPosition& at :
       {ClipPosition{0, 0, -(1 << 29)}, {0, 0, 999}, {-(1 << 29), 0, 4000}, {0, 4001, 4000}, {0, 0, 5001}}) {
    Polygon outside;
    for (std::size_t i = 0; i < 3; ++i) outside[i].position = at;
    clip_polygon(outside, kRange);
    CHECK(outside.count() == 0);
  }
}

TEST_CASE("the two triangles of a cut edge get the same vertex") {
  Random random(92);
  using ArcMethod = Arc<Illumination<1, Highlight::kBlinn>>;
  constexpr WRange kRange{1 << 16, 1 << 26};
  int different = 0;
  int cut = 0;
  for (int i = 0; i < share_of(20000); ++i) {
    ClipVertex<ArcMethod> a{random_clip_position(random, kRange), {}};
    ClipVertex<ArcMethod> b{random_clip_position(random, kRange), {}};
    const Vec3 n = random_unit(random);
    a.shade = ArcMethod::shade_vertex({}, to_direction(n));
    b.shade = ArcMethod::shade_vertex({}, to_direction(tilted(random, n, random.real(0, 2))));
    const auto cut_by = [&](const ClipVertex<ArcMethod>& p, const ClipVertex<ArcMethod>& q) {
      ClipPolygon<ArcMethod> result;
      result[0] = p;
      result[1] = q;
      result[2] = q;  // an edge there and back
      clip_polygon(result, kRange);
      std::vector<std::array<std::int32_t, 6>> list;
      for (std::size_t k = 0; k < result.count(); ++k) {
        const ClipVertex<ArcMethod>& v = result[k];
        list.push_back({v.position.x, v.position.y, v.position.w, v.shade.normal.x.raw(),
                        v.shade.normal.y.raw(), v.shade.normal.z.raw()});
      }
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      return list;
    };
    const auto one = cut_by(a, b);
    different += one == cut_by(b, a) ? 0 : 1;
    const auto has = [&one](const ClipPosition& p) {
      return std::any_of(one.begin(), one.end(), [&p](const auto& v) { return v[0] == p.x && v[2] == p.w; });
    };
    cut += !one.empty() && !(has(a.position) && has(b.position)) ? 1 : 0;
  }
  CHECK(cut > share_of(2000));
  CHECK(different == 0);
}
