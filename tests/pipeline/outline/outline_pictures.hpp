// SPDX-License-Identifier: MIT
#pragma once

// Pictures for tests of outlines: of meshes, and of polygons whose areas are known.
#include <arcspan/draw.hpp>
#include <arcspan/draw/triangle_sides.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/hal/framebuffer_window.hpp>
#include <arcspan/outline/outline_list.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/smooth_outlines.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/neighbours.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace arcspan::test {

inline constexpr Rgb8 kBackground{200, 210, 220};

template <PixelFormat F>
struct PictureOf {
  explicit PictureOf(const Rect& held)
      : colours(hal::Framebuffer<F>::words(held.width(), held.height())),
        depths(DepthBuffer::words(held.width(), held.height())),
        frame(std::as_writable_bytes(std::span(colours)), held,
              hal::FramebufferWindow<F>::least_stride(held)),
        depth(depths, held) {
    frame.clear(kBackground);
    depth.clear();
  }
  std::vector<typename F::Word> colours;
  std::vector<std::uint16_t> depths;
  hal::FramebufferWindow<F> frame;
  DepthBuffer depth;
};
using Picture = PictureOf<Rgb565>;

[[nodiscard]] inline TestCamera camera_of(Random& random, double radius) {
  TestCamera made;
  made.look_in_random_direction(random);
  made.translation = {0, 0, -4 * radius};
  made.near_plane = radius / 10;
  made.far_plane = 10 * radius;
  return made;
}

/// Two spheres, one before the other, with their outlines.
struct OutlineScene {
  using Method = Flat<Illumination<1, Highlight::kBlinn>>;

  explicit OutlineScene(Random& random, bool creases = false)
      : sphere(make_sphere(9, 14, 9000, 0.3, random)),
        neighbours(sphere.view(), creases),
        memory(8 * sphere.view().triangle_count()),
        outlines(memory) {
    for (const double x : {-4000.0, 5000.0}) {
      TestCamera from = camera_of(random, 9000);
      from.translation.x += x;
      from.translation.z += x;
      cameras.push_back(from);
      transforms.push_back(from.transform());
    }
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      std::vector<TriangleSide> sides(sphere.view().triangle_count());
      const auto light = make_light<1, Highlight::kBlinn>(cameras[i]);
      REQUIRE(ok(find_sides<Method>(sphere.view(), transforms[i], light, NoCache{}, sides)));
      REQUIRE(ok(outlines.add(sphere.view(), neighbours.view, VertexPositions(transforms[i]), sides)));
    }
  }

  template <PixelFormat F>
  void draw(PictureOf<F>& picture) const {
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      const auto light = make_light<1, Highlight::kBlinn>(cameras[i]);
      REQUIRE(
          ok(draw_mesh<Method>(sphere.view(), transforms[i], light, picture.frame, picture.depth).status));
    }
  }
  [[nodiscard]] Rect bounds() const { return {0, 0, cameras[0].width, cameras[0].height}; }

  TestMesh sphere;
  TestNeighbours neighbours;
  std::vector<TestCamera> cameras;
  std::vector<ClipTransform> transforms;
  std::vector<OutlineEdge> memory;
  OutlineList outlines;
};

/// The distance of a point from the nearest edge, in sixteenths of a pixel.
[[nodiscard]] inline double distance_from(std::span<const OutlineEdge> edges, double px, double py) {
  double nearest = 1e9;
  for (const OutlineEdge& e : edges) {
    const double dx = e.to.x - e.from.x;
    const double dy = e.to.y - e.from.y;
    const double along = dx * dx + dy * dy;
    const double t =
        along == 0 ? 0 : std::clamp(((px - e.from.x) * dx + (py - e.from.y) * dy) / along, 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(e.from.x + t * dx - px, e.from.y + t * dy - py));
  }
  return nearest;
}

template <PixelFormat F>
[[nodiscard]] Status smooth(const OutlineList& outlines, PictureOf<F>& picture, std::size_t gaps = 4000) {
  std::vector<OutlineGap<F>> memory(gaps);
  return smooth_outlines(outlines, picture.frame, picture.depth, std::span(memory));
}

template <PixelFormat F>
[[nodiscard]] bool same_pixels(const PictureOf<F>& a, const PictureOf<F>& b, const Rect& rect) {
  for (std::int32_t y = rect.top; y < rect.bottom; ++y) {
    for (std::int32_t x = rect.left; x < rect.right; ++x)
      if (!(a.frame.pixel(x, y) == b.frame.pixel(x, y))) return false;
  }
  return true;
}

/// Edges that were made without a mesh, for a picture of 32x32.
struct Drawing {
  explicit Drawing(const std::vector<OutlineEdge>& edges) : memory(edges.size()), outlines(memory) {
    // A square gives the memory its count and viewport; then the edges replace its own.
    TestMesh mesh;
    const std::size_t triangles = (edges.size() + 2) / 3;
    for (std::size_t i = 0; i < 3; ++i) mesh.add({9000.0 * (i == 1), 9000.0 * (i == 2), 0}, {0, 0, 1});
    for (std::size_t i = 0; i < triangles; ++i) mesh.triangle(0, 1, 2);
    memory.resize(3 * triangles);
    outlines = OutlineList(memory);
    TestCamera from;
    from.width = 32;
    from.height = 32;
    from.translation = {0, 0, -40000};
    transform = from.transform();
    std::vector<std::uint8_t> borders(triangles);
    MeshNeighbours none;
    REQUIRE(ok(MeshNeighbours::make(mesh.view(), borders, none)));
    const std::vector<TriangleSide> sides(triangles, TriangleSide::kFront);
    REQUIRE(ok(outlines.add(mesh.view(), none, VertexPositions(transform), sides)));
    std::fill(memory.begin(), memory.end(), OutlineEdge{});
    std::copy(edges.begin(), edges.end(), memory.begin());
  }
  ClipTransform transform;
  std::vector<OutlineEdge> memory;
  OutlineList outlines;
};

/// The raster position of a point of the picture, in sixteenths of a pixel.
[[nodiscard]] inline RasterPosition at(std::int32_t x, std::int32_t y, std::uint16_t z = 1000) {
  return {static_cast<std::int16_t>(x - 256), static_cast<std::int16_t>(y - 256), z};
}

/// A line across a picture of 32x32, steep or flat.
struct LineAcross {
  explicit LineAcross(Random& random)
      : steep(random.chance(0.5)),
        from(random.integer(128, 384)),
        to(random.integer(128, 384)),
        a(steep ? at(from, 0) : at(0, from)),
        b(steep ? at(to, 512) : at(512, to)) {}

  bool steep;
  std::int32_t from;  ///< where it begins and ends, in sixteenths of a pixel
  std::int32_t to;
  RasterPosition a;
  RasterPosition b;
};

/// The outline of a polygon whose corners run counter-clockwise on the screen.
[[nodiscard]] inline std::vector<OutlineEdge> polygon(const std::vector<RasterPosition>& corners) {
  std::vector<OutlineEdge> edges;
  for (std::size_t i = 0; i < corners.size(); ++i)
    edges.push_back({corners[i], corners[(i + 1) % corners.size()]});
  return edges;
}

/// True if the centre of a pixel belongs to a convex polygon, by the top-left rule.
[[nodiscard]] inline bool covers(const std::vector<OutlineEdge>& edges, std::int32_t x, std::int32_t y) {
  for (const OutlineEdge& e : edges) {
    const std::int32_t dx = e.to.x - e.from.x;
    const std::int32_t dy = e.to.y - e.from.y;
    const std::int32_t px = 16 * x + 8 - 256 - e.from.x;
    const std::int32_t py = 16 * y + 8 - 256 - e.from.y;
    const std::int32_t cross = dx * py - dy * px;  // negative inside
    const bool left_or_top = dy > 0 || (dy == 0 && dx < 0);
    if (cross > 0 || (cross == 0 && !left_or_top)) return false;
  }
  return true;
}

/// The share of a pixel that a convex polygon covers, by 64x64 samples where an edge crosses it.
[[nodiscard]] inline double coverage(const std::vector<OutlineEdge>& edges, std::int32_t x, std::int32_t y) {
  const auto is_inside = [x, y](const OutlineEdge& e, double across, double down) {
    const double sx = 16 * (x + across) - 256;
    const double sy = 16 * (y + down) - 256;
    return (e.to.x - e.from.x) * (sy - e.from.y) - (e.to.y - e.from.y) * (sx - e.from.x) <= 0;
  };
  std::vector<OutlineEdge> crossing;
  for (const OutlineEdge& e : edges) {
    const int corners = is_inside(e, 0, 0) + is_inside(e, 1, 0) + is_inside(e, 0, 1) + is_inside(e, 1, 1);
    if (corners == 0) return 0;
    if (corners != 4) crossing.push_back(e);
  }
  if (crossing.empty()) return 1;
  int inside = 0;
  for (int j = 0; j < 64; ++j) {
    for (int i = 0; i < 64; ++i) {
      const auto holds = [&](const OutlineEdge& e) { return is_inside(e, (i + 0.5) / 64, (j + 0.5) / 64); };
      inside += std::all_of(crossing.begin(), crossing.end(), holds) ? 1 : 0;
    }
  }
  return inside / 4096.0;
}

/// How many edges, prolonged, pass within two pixels of a pixel's centre.
[[nodiscard]] inline int edges_near(const std::vector<OutlineEdge>& edges, std::int32_t x, std::int32_t y) {
  int found = 0;
  for (const OutlineEdge& e : edges) {
    const double dx = e.to.x - e.from.x;
    const double dy = e.to.y - e.from.y;
    const double cross = dx * (16 * y + 8 - 256 - e.from.y) - dy * (16 * x + 8 - 256 - e.from.x);
    if (std::abs(cross) < 32 * std::hypot(dx, dy)) ++found;
  }
  return found;
}

/// A picture of 32x32 with a white polygon on black, as the raster draws it.
template <PixelFormat F>
[[nodiscard]] PictureOf<F> drawn(const std::vector<OutlineEdge>& edges, std::uint16_t z = 1000) {
  PictureOf<F> picture({0, 0, 32, 32});
  picture.frame.clear({0, 0, 0});
  for (std::int32_t y = 0; y < 32; ++y) {
    for (std::int32_t x = 0; x < 32; ++x) {
      if (!covers(edges, x, y)) continue;
      typename F::Cursor(picture.frame.row(y), x).write(F::encode(Rgb8{255, 255, 255}));
      picture.depth.row(y)[x] = z;
    }
  }
  return picture;
}

[[nodiscard]] inline std::vector<OutlineEdge> random_triangle(Random& random, std::int32_t step) {
  for (;;) {
    const auto corner = [&] {
      return at(step * random.integer(16 / step, 496 / step), step * random.integer(16 / step, 496 / step));
    };
    const std::vector<OutlineEdge> edges = polygon({corner(), corner(), corner()});
    if (doubled_area(edges[0].from, edges[1].from, edges[2].from) < -4000) return edges;
  }
}

/// A sink that cannot be read.
struct StreamSink {
  using Format = Rgb565;
  [[nodiscard]] static Rect bounds() { return {0, 0, 32, 32}; }
  [[nodiscard]] Format::Cursor open(const Span& run) { return {line, run.x}; }
  [[nodiscard]] static Status close(const Span&) { return Status::kOk; }
  std::uint16_t line[32] = {};
};

/// Fails at the n-th run.
struct FailingSink {
  using Format = Rgb565;
  using RowsInMemory = FailingSink;
  [[nodiscard]] Rect bounds() const { return picture.frame.bounds(); }
  [[nodiscard]] Format::Cursor open(const Span& run) { return {row(run.y), run.x}; }
  [[nodiscard]] Status close(const Span& run) {
    inside = inside && run.count == 1 && run.x >= 0 && run.x < 32 && run.y >= 0 && run.y < 32;
    return --left == 0 ? Status::kTransferFailed : Status::kOk;
  }
  [[nodiscard]] std::uint16_t* row(std::int32_t y) const { return picture.frame.row(y); }
  [[nodiscard]] std::int32_t stride_bytes() const { return picture.frame.stride_bytes(); }
  Picture& picture;
  int left;
  bool inside = true;
};

}  // namespace arcspan::test
