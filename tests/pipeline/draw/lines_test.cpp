// SPDX-License-Identifier: MIT
// Lines and points: which pixels they have, at which depth, and that clipping, bands and the order of the
// ends change none of them.
#include <arcspan/draw_lines.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/gray8.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr Viewport kView{101, 62};
const PackedRgb kWhite255 = Unlit::lighting({255, 255, 255});

/// A part of a picture with the depths in it: the rows from `first` on and all columns.
struct Sheet {
  std::int32_t first;
  std::vector<std::uint8_t> words;
  std::vector<std::uint16_t> depths;
  hal::Framebuffer<Gray8> frame;
  DepthBuffer depth;

  explicit Sheet(std::int32_t rows = kView.height, std::int32_t first_row = 0)
      : first(first_row),
        words(static_cast<std::size_t>(kView.width * rows)),
        depths(words.size(), DepthBuffer::kFarthest),
        frame(words, kView.width, rows, first_row),
        depth(depths, kView.width, rows, first_row) {}
};

/// A sink that takes the columns from kLeft to kRight only, and refuses all others.
struct Slit {
  using Format = Gray8;
  static constexpr std::int32_t kLeft = 37;
  static constexpr std::int32_t kRight = 58;
  Sheet& sheet;

  [[nodiscard]] Rect bounds() const { return {kLeft, 0, kRight, kView.height}; }
  [[nodiscard]] Format::Cursor open(const Span& run) {
    if (run.x < kLeft || run.x + run.count > kRight) FAIL("a run outside of the slit");
    return sheet.frame.open(run);
  }
  [[nodiscard]] Status close(const Span& run) { return sheet.frame.close(run); }
};

using Place = std::pair<std::int32_t, std::int32_t>;

std::int64_t floored(std::int64_t v, std::int64_t divisor) { return (v < 0 ? v - divisor + 1 : v) / divisor; }

/// The pixels of a line by LineCommand's definition, relative to the raster origin, with the depth at each
/// one's centre: one per column or row, exactly where the line crosses the middle of it.
std::map<Place, double> exact_pixels(RasterPosition a, RasterPosition b) {
  const bool flat = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
  const auto along = [flat](const RasterPosition& p) { return std::int64_t{flat ? p.x : p.y}; };
  const auto across = [flat](const RasterPosition& p) { return std::int64_t{flat ? p.y : p.x}; };
  if (along(a) > along(b)) std::swap(a, b);
  const std::int64_t length = along(b) - along(a);
  const std::int64_t rise = across(b) - across(a);
  const std::int64_t least = floored(std::min(across(a), across(b)), 16);
  const std::int64_t most = floored(std::max(across(a), across(b)), 16);
  std::map<Place, double> pixels;
  for (std::int64_t i = floored(along(a), 16); i <= floored(along(b), 16); ++i) {
    const std::int64_t centre = 16 * i + 8 - along(a);
    std::int64_t j = least;
    double depth = std::min(a.z, b.z);
    if (length > 0) {
      const std::int64_t at = across(a) * length + rise * centre;  // times length
      // On a border of pixels a line belongs to the lower row if it leads to the right on its way down.
      j = flat && rise >= 0 ? floored(at, 16 * length) : floored(at + 16 * length - 1, 16 * length) - 1;
      depth = a.z + (b.z - a.z) * static_cast<double>(centre) / static_cast<double>(length);
    }
    j = std::clamp(j, least, most);
    pixels[flat ? Place{i, j} : Place{j, i}] = depth;
  }
  return pixels;
}

std::int16_t subpixel(Random& random, std::int32_t reach) {
  const auto v = static_cast<std::int32_t>(random.bits() % static_cast<std::uint32_t>(2 * reach)) - reach;
  return static_cast<std::int16_t>(v);
}

RasterPosition random_end(Random& random, std::int32_t reach) {
  const auto z = static_cast<std::uint16_t>(256 + random.bits() % (65536 - 512));
  return {subpixel(random, reach), subpixel(random, reach), z};
}

}  // namespace

TEST_CASE("a line has the pixel that contains it in each column or row, at its depth") {
  Random random(91);
  const std::int32_t origin_x = kView.width / 2;
  const std::int32_t origin_y = kView.height / 2;
  for (int i = 0; i < share_of(20000); ++i) {
    const std::int32_t reach = i % 3 == 0 ? 24 : i % 3 == 1 ? 900 : 16384;
    RasterPosition a = random_end(random, reach);
    RasterPosition b = random_end(random, reach);
    if (i % 5 == 1) b.y = static_cast<std::int16_t>(a.y + subpixel(random, 4));
    if (i % 5 == 2) b.x = static_cast<std::int16_t>(a.x + subpixel(random, 4));
    if (i % 5 == 3) a = {static_cast<std::int16_t>(a.x & ~7), static_cast<std::int16_t>(a.y & ~7), a.z};
    if (!in_guard_band(a) || !in_guard_band(b)) continue;
    INFO("(" << a.x << ", " << a.y << ", " << a.z << ") to (" << b.x << ", " << b.y << ", " << b.z << ")");
    Sheet sheet;
    REQUIRE(ok(draw_screen_line(a, b, kView, kWhite255, sheet.frame, sheet.depth)));
    const std::map<Place, double> exact = exact_pixels(a, b);
    const double length = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)) / 16.0;
    const double gradient = std::abs(b.z - a.z) / std::max(length, 1.0 / 16);
    // A gradient above 480 is spread over the whole pixels of the line, and a single pixel has the lesser
    // depth.
    const double tolerance = gradient > 479 || exact.size() == 1 ? 1.1 * gradient + 4 : 4;
    std::int32_t wrong = 0;
    std::ptrdiff_t expected = 0;
    for (const auto& [place, exact_depth] : exact) {
      const std::int32_t x = place.first + origin_x;
      const std::int32_t y = place.second + origin_y;
      if (x < 0 || x >= kView.width || y < 0 || y >= kView.height) continue;
      ++expected;
      const auto at = static_cast<std::size_t>(y * kView.width + x);
      const std::int32_t depth = sheet.depths[at];
      if (sheet.words[at] == 0 || std::abs(depth - exact_depth) > tolerance) ++wrong;
      if (depth < std::min(a.z, b.z) - 250 || depth > std::max(a.z, b.z) + 250) ++wrong;
    }
    REQUIRE(wrong == 0);
    REQUIRE(std::count(sheet.words.begin(), sheet.words.end(), 0) == std::ssize(sheet.words) - expected);

    Sheet reversed;
    REQUIRE(ok(draw_screen_line(b, a, kView, kWhite255, reversed.frame, reversed.depth)));
    REQUIRE(reversed.words == sheet.words);
    REQUIRE(reversed.depths == sheet.depths);

    Sheet part;
    Slit slit{part};
    REQUIRE(ok(draw_screen_line(a, b, kView, kWhite255, slit, part.depth)));
    for (std::size_t at = 0; at < part.words.size(); ++at) {
      const auto x = static_cast<std::int32_t>(at) % kView.width;
      const bool inside = x >= Slit::kLeft && x < Slit::kRight;
      if (part.words[at] != (inside ? sheet.words[at] : 0)) ++wrong;
      if (part.depths[at] != (inside ? sheet.depths[at] : DepthBuffer::kFarthest)) ++wrong;
    }
    REQUIRE(wrong == 0);
    for (std::int32_t row = 0; row + 7 <= kView.height; row += 11) {
      Sheet band(7, row);
      REQUIRE(ok(draw_screen_line(a, b, kView, kWhite255, band.frame, band.depth)));
      const auto offset = row * kView.width;
      REQUIRE(std::equal(band.words.begin(), band.words.end(), sheet.words.begin() + offset));
      REQUIRE(std::equal(band.depths.begin(), band.depths.end(), sheet.depths.begin() + offset));
    }
  }
}

TEST_CASE("lines are clipped where they leave the view") {
  Random random(17);
  std::size_t drawn = 0;
  std::size_t cut = 0;
  std::size_t cut_far = 0;
  for (int i = 0; i < share_of(4000); ++i) {
    TestCamera camera;
    camera.width = kView.width;
    camera.height = kView.height;
    camera.focal = i % 2 == 0 ? 70 : 700;
    if (i % 3 == 0) camera.far_plane = 6000;
    camera.look_in_random_direction(random);
    camera.translation = Vec3{random.real(-3000, 3000), random.real(-3000, 3000), random.real(-9000, 3000)};
    const ClipTransform transform = camera.transform();
    const auto corner = [&] { return subpixel(random, 8000); };
    const ObjectLine line{{corner(), corner(), corner()}, {corner(), corner(), corner()}};
    Sheet sheet;
    REQUIRE(ok(draw_lines({&line, 1}, transform, kWhite255, sheet.frame, sheet.depth)));
    const ObjectLine back{line.to, line.from};
    Sheet reversed;
    REQUIRE(ok(draw_lines({&back, 1}, transform, kWhite255, reversed.frame, reversed.depth)));
    REQUIRE(reversed.words == sheet.words);
    REQUIRE(reversed.depths == sheet.depths);

    // The part between the planes, in double precision.
    const auto view_of = [&](const ObjectPosition& p) {
      return camera.to_view({double(p.x), double(p.y), double(p.z)});
    };
    Vec3 from = view_of(line.from);
    Vec3 to = view_of(line.to);
    if (from.z > to.z) std::swap(from, to);  // `to` is nearer
    if (from.z > -camera.near_plane || to.z < -camera.far_plane) {
      REQUIRE(sheet.words == std::vector<std::uint8_t>(sheet.words.size()));
      continue;
    }
    if (to.z > -camera.near_plane) {
      to = from + ((from.z + camera.near_plane) / (from.z - to.z)) * (to - from);
      ++cut;
    }
    if (from.z < -camera.far_plane) {
      from = to + ((to.z + camera.far_plane) / (to.z - from.z)) * (from - to);
      ++cut_far;
    }
    const auto on_screen = [&](const Vec3& v) {
      return Vec3{kView.width / 2.0 + camera.focal * v.x / -v.z,
                  kView.height / 2.0 - camera.focal * v.y / -v.z, 0};
    };
    const Vec3 p = on_screen(from);
    const Vec3 q = on_screen(to);
    const Vec3 d = q - p;
    const double length = std::hypot(d.x, d.y);
    double farthest = 0;
    for (std::int32_t y = 0; y < kView.height; ++y) {
      for (std::int32_t x = 0; x < kView.width; ++x) {
        if (sheet.words[static_cast<std::size_t>(y * kView.width + x)] == 0) continue;
        ++drawn;
        const double distance = std::abs((x + 0.5 - p.x) * d.y - (y + 0.5 - p.y) * d.x) / length;
        if (length > 2) farthest = std::max(farthest, distance);
      }
    }
    INFO("line " << i << ", length " << length);
    REQUIRE(farthest < 0.85);
    // One pixel in each column whose middle the line crosses well inside the picture.
    if (std::abs(d.x) < 1.5 * std::abs(d.y)) continue;
    for (std::int32_t x = 0; x < kView.width; ++x) {
      const double t = (x + 0.5 - p.x) / d.x;
      const double y = p.y + t * d.y;
      if (t * length < 1 || (1 - t) * length < 1 || y < 1 || y > kView.height - 1) continue;
      int count = 0;
      for (std::int32_t row = 0; row < kView.height; ++row) {
        count += sheet.words[static_cast<std::size_t>(row * kView.width + x)] != 0 ? 1 : 0;
      }
      INFO("line " << i << ", column " << x);
      REQUIRE(count == 1);
    }
  }
  CHECK(drawn > static_cast<std::size_t>(share_of(20000)));
  CHECK(cut > static_cast<std::size_t>(share_of(20)));
  CHECK(cut_far > static_cast<std::size_t>(share_of(20)));
}

TEST_CASE("lines are hidden by what is nearer, with a bias less so") {
  TestCamera camera;
  camera.width = kView.width;
  camera.height = kView.height;
  camera.near_plane = 4000;
  camera.far_plane = 16000;
  camera.translation = {0, 0, -8000};
  const ClipTransform transform = camera.transform();
  const ObjectLine line{{-900, 0, 0}, {900, 0, 0}};
  const auto pixels = [&](std::int32_t surface, DepthBias bias) {
    Sheet sheet;
    std::fill(sheet.depths.begin(), sheet.depths.end(), static_cast<std::uint16_t>(surface));
    REQUIRE(ok(draw_lines({&line, 1}, transform, kWhite255, sheet.frame, sheet.depth, bias)));
    return std::count(sheet.words.begin(), sheet.words.end(), 255);
  };
  const std::int32_t depth = project(transform({}), transform).z;
  CHECK(pixels(depth + 1, {0}) == 46);
  CHECK(pixels(depth, {0}) == 0);
  CHECK(pixels(depth - 99, {100}) == 46);
  CHECK(pixels(depth - 100, {100}) == 0);
  CHECK(pixels(300, {65535}) == 46);  // a bias does not wrap
  CHECK(pixels(256, {65535}) == 0);
}

TEST_CASE("a point is a square of pixels around its place, cut at the borders") {
  TestCamera camera;
  camera.width = kView.width;
  camera.height = kView.height;
  camera.translation = {0, 0, -8000};
  const ClipTransform transform = camera.transform();
  const auto columns_and_rows = [&](ObjectPosition at, std::uint8_t size) {
    Sheet sheet;
    REQUIRE(ok(draw_points({&at, 1}, size, transform, kWhite255, sheet.frame, sheet.depth)));
    std::int32_t left = kView.width;
    std::int32_t right = 0;
    std::int32_t top = kView.height;
    std::int32_t bottom = 0;
    std::int32_t count = 0;
    for (std::int32_t y = 0; y < kView.height; ++y) {
      for (std::int32_t x = 0; x < kView.width; ++x) {
        if (sheet.words[static_cast<std::size_t>(y * kView.width + x)] == 0) continue;
        left = std::min(left, x);
        right = std::max(right, x + 1);
        top = std::min(top, y);
        bottom = std::max(bottom, y + 1);
        ++count;
      }
    }
    CHECK(count == std::max(0, right - left) * std::max(0, bottom - top));
    return std::vector<std::int32_t>{left, top, right, bottom};
  };
  using Box = std::vector<std::int32_t>;
  // The middle of 101 x 62 pixels is the centre of column 50, and the border of rows 30 and 31.
  CHECK(columns_and_rows({}, 1) == Box{50, 31, 51, 32});
  CHECK(columns_and_rows({}, 4) == Box{49, 29, 53, 33});
  CHECK(columns_and_rows({}, 5) == Box{48, 29, 53, 34});
  CHECK(columns_and_rows({}, 0) == Box{kView.width, kView.height, 0, 0});
  CHECK(columns_and_rows({}, 255) == Box{0, 0, kView.width, kView.height});
  CHECK(columns_and_rows({-2040, 1240, 0}, 9) == Box{0, 0, 4, 5});
  CHECK(columns_and_rows({0, 0, 8000}, 9) == Box{kView.width, kView.height, 0, 0});  // at the eye
}

TEST_CASE("lines and points end where the sink first fails") {
  struct Failing {
    using Format = Gray8;
    Sheet& sheet;
    int runs = 0;
    [[nodiscard]] Rect bounds() const { return {0, 0, kView.width, kView.height}; }
    [[nodiscard]] Format::Cursor open(const Span& run) { return sheet.frame.open(run); }
    [[nodiscard]] Status close(const Span&) { return ++runs == 3 ? Status::kTimeout : Status::kOk; }
  };
  TestCamera camera;
  camera.width = kView.width;
  camera.height = kView.height;
  camera.translation = {0, 0, -8000};
  Sheet sheet;
  Failing sink{sheet};
  const ObjectLine flat{{-900, -300, 0}, {900, 300, 0}};
  CHECK(draw_lines({&flat, 1}, camera.transform(), kWhite255, sink, NoDepth{}) == Status::kTimeout);
  CHECK(std::exchange(sink.runs, 0) == 3);
  const ObjectLine tall{{-300, -900, 0}, {300, 900, 0}};
  CHECK(draw_lines({&tall, 1}, camera.transform(), kWhite255, sink, NoDepth{}) == Status::kTimeout);
  CHECK(std::exchange(sink.runs, 0) == 3);
  CHECK(draw_points({&flat.from, 1}, 5, camera.transform(), kWhite255, sink, NoDepth{}) == Status::kTimeout);
  CHECK(sink.runs == 3);
}

TEST_CASE("lines say why they draw nothing") {
  TestCamera camera;
  camera.width = kView.width;
  camera.height = kView.height;
  camera.translation = {0, 0, -8000};
  const ObjectLine line{{-900, 0, 0}, {900, 0, 0}};
  Sheet sheet;
  Sheet band(8, 16);
  CHECK(draw_lines({&line, 1}, camera.transform(), kWhite255, sheet.frame, band.depth) ==
        Status::kDepthMismatch);
  hal::Framebuffer<Gray8> none({}, 8, 8);
  CHECK(draw_lines({&line, 1}, camera.transform(), kWhite255, none, NoDepth{}) == Status::kBufferTooSmall);
  const RasterPosition inside{0, 0, 500};
  const RasterPosition outside{0, 16384, 500};
  CHECK(draw_screen_line(inside, outside, kView, kWhite255, sheet.frame, sheet.depth) ==
        Status::kInvalidArgument);
  CHECK(draw_screen_line(inside, inside, {0, 8}, kWhite255, sheet.frame, sheet.depth) ==
        Status::kInvalidArgument);
  CHECK(draw_screen_line(inside, inside, {8, 2049}, kWhite255, sheet.frame, sheet.depth) ==
        Status::kInvalidArgument);
}
