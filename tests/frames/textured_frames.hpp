// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw.hpp>
#include <arcspan/draw/wireframe.hpp>
#include <arcspan/draw_billboards.hpp>
#include <arcspan/draw_lines.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/fog.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/grey_gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/shading/textured/environment_map.hpp>
#include <arcspan/shading/textured/textured.hpp>
#include <arcspan/shading/with_operation.hpp>
#include <arcspan/span/depth_mode.hpp>

#include <tests/frames/frame_hash.hpp>
#include <tests/frames/stage_set.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <new>

/// Frames with textures, fog and transparency that every host must draw alike, band by band;
/// tests/frames/textured_hashes.txt pins them.
namespace arcspan::scenes {

/// 32×32 texels of 8 bits with their mip levels: a grid of cells in changing colours.
inline constexpr TextureSize kGridSize{5, 5, 6};
inline constexpr auto kGrid = [] {
  std::array<std::uint8_t, Texture<Palette8Texels<>>::words(kGridSize)> texels{};
  std::size_t at = 0;
  for (std::uint32_t level = 0; level < 6; ++level) {
    for (std::uint32_t y = 0; y < 32u >> level; ++y) {
      for (std::uint32_t x = 0; x < 32u >> level; ++x) {
        const std::uint32_t column = x << level;
        const std::uint32_t row = y << level;
        const bool line = column % 8 == 0 || row % 8 == 0;
        texels[at++] = static_cast<std::uint8_t>(line ? 255 : 8 * (column / 8 + 4 * (row / 8)) + level);
      }
    }
  }
  return texels;
}();
/// Colours of all alphas, in rrrrggggbbbbaaaa.
inline constexpr auto kGridColours = [] {
  std::array<std::uint16_t, 256> colours{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    const std::uint32_t mixed = i * 2654435761u;
    colours[i] = static_cast<std::uint16_t>((mixed >> 16 & 0xFFF0u) | (i == 255 ? 15u : 4 + (i & 7)));
  }
  return colours;
}();

/// A floor that leads towards the horizon, behind the camera too, so that it is clipped.
inline constexpr std::array<ObjectPosition, 4> kFloorCorners{
    {{-30000, -9000, 30000}, {30000, -9000, 30000}, {30000, -9000, -32000}, {-30000, -9000, -32000}}};
inline constexpr std::array<PackedNormal, 4> kFloorNormals{};
inline constexpr std::array<std::uint8_t, 6> kFloorTriangles{0, 1, 2, 0, 2, 3};
inline constexpr std::array<TexturePoint, 4> kFloorPoints{
    {{-8192, 8192}, {8192, 8192}, {8192, -8192}, {-8192, -8192}}};

/// Lines that end before the camera, behind it and beyond the guard band, and places of points and
/// billboards.
inline constexpr std::array<ObjectLine, 4> kStrokes{{{{-30000, 9000, -30000}, {30000, -9000, 12000}},
                                                     {{-20000, -6000, -30000}, {-3000, 30000, -9000}},
                                                     {{32000, 0, -8000}, {-32000, 1000, -7000}},
                                                     {{0, -9000, -32000}, {300, -9000, -2000}}}};
inline constexpr std::array<ObjectPosition, 5> kPlaces{{{-9000, 0, -20000},
                                                        {9000, 2000, -12000},
                                                        {3500, -1500, -6000},
                                                        {1000, 9000, -30000},
                                                        {-1700, -700, -1500}}};

using GridTexels = Palette8Texels<Alpha4Colour>;
inline constexpr auto kOpaque = Texture<Palette8Texels<>>::of(kGrid, kGridSize, kGridColours);
inline constexpr auto kSheer = Texture<GridTexels>::of(kGrid, kGridSize, kGridColours);

using BallMethod = Textured<Arc<Light>, Palette8Texels<>>;
using FloorSurface = Textured<Unlit, Palette8Texels<>>;
using BubbleSurface = Textured<GreyGouraud<Light>, GridTexels, TexelLight::kGrey, TextureFilter::kBilinear>;
using Bubble = WithOperation<BubbleSurface, Opacity<>>;

/// Memory to draw textured frames in.
template <std::int32_t Rows>
struct TexturedSpace {
  static_assert(kHeight % Rows == 0);
  static constexpr std::size_t kPixels = static_cast<std::size_t>(kWidth) * static_cast<std::size_t>(Rows);
  std::uint16_t colours[kPixels];
  std::uint16_t depths[kPixels];
  std::array<TexturePoint, 114> points;
  // Bytes, because default values would be initialised data.
  alignas(8) unsigned char stage[sizeof(StageSet)];
  alignas(8) unsigned char lighting[std::max(sizeof(BallMethod::Lighting), sizeof(Bubble::Lighting))];
};

/// Draws the frame of `draw(frame, depth)` band by band and returns its hash.
template <std::int32_t Rows, class Draw>
[[nodiscard]] Status hash_textured(TexturedSpace<Rows>& space, std::uint32_t& value, const Draw& draw) {
  hal::Framebuffer<Rgb565> band(space.colours, kWidth, Rows);
  DepthBuffer depth(space.depths, kWidth, Rows);
  Hash hash;
  for (std::int32_t top = 0; top < kHeight; top += Rows) {
    band.move_to(top);
    depth.move_to(top);
    band.clear({16, 16, 32});
    depth.clear();
    const Status status = draw(band, depth);
    if (!ok(status)) return status;
    for (std::int32_t y = top; y < top + Rows; ++y) {
      for (std::int32_t x = 0; x < kWidth; ++x) hash.add(band.pixel(x, y));
    }
  }
  value = hash.value();
  return Status::kOk;
}

/// Calls report(name, status, hash) for every textured frame.
template <std::int32_t Rows, class Report>
void textured_frames(TexturedSpace<Rows>& space, const Report& report) {
  using Floor = WithOperation<FloorSurface, Fogged>;
  using Chrome = Arc<EnvironmentMap<Palette8Texels<>>>;
  static constexpr Fog kMist = [] {
    Fog fog;
    if (!ok(Fog::make({500, 60000, 8000, 40000}, {150, 160, 180}, fog))) detail::refused::constant_refused();
    return fog;
  }();

  static constexpr auto kBall = make_sphere<16, 8>();
  MeshView ball;
  StageSet& stage = *::new (space.stage) StageSet;
  Status status = kBall.view(ball);
  if (ok(status)) status = set_stage({kWidth, kHeight}, kFrameRadius, Turn{3000}, stage);
  for (std::size_t i = 0; i < ball.vertex_count(); ++i) {
    space.points[i] = {static_cast<std::int16_t>(ball.position(i).x >> 2),
                       static_cast<std::int16_t>(-(ball.position(i).y >> 2))};
  }
  if (ok(status)) status = ball.attach({space.points.data(), ball.vertex_count()}, TextureScale{12});
  const MeshView floor =
      MeshView::of(kFloorCorners, kFloorNormals, kFloorTriangles).with(kFloorPoints, TextureScale{11});
  ClipTransform ahead;
  if (ok(status)) {
    status = ClipTransform::make({Rotation::identity(), {}},
                                 {PixelLength::of(100), ObjectLength::of(500), ObjectLength::of(60000)},
                                 {kWidth, kHeight}, ahead);
  }
  const auto frame = [&](const char* name, const auto& draw) {
    std::uint32_t hash = 0;
    if (ok(status)) status = hash_textured(space, hash, draw);
    report(name, status, hash);
  };
  const auto draw_floor = [&](auto& band, const auto& depth) {
    const Floor::Lighting lighting(FloorSurface::Lighting(PackedRgb{}, kOpaque), Fogged{&kMist});
    return draw_mesh<Floor>(floor, ahead, lighting, band, depth).status;
  };
  frame("ball", [&](auto& band, const auto& depth) {
    auto* const lighting = ::new (space.lighting) BallMethod::Lighting(stage.light, kOpaque);
    static_cast<void>(lighting->set_tolerance(1));
    return draw_mesh<BallMethod>(ball, stage.transform, *lighting, band, depth).status;
  });
  frame("floor", draw_floor);
  frame("bubble", [&](auto& band, const auto& depth) {
    const Status drawn = draw_floor(band, depth);
    if (!ok(drawn)) return drawn;
    // In place, because a copy on the stack would stay there while the frame is drawn.
    auto* const lighting = ::new (space.lighting) Bubble::Lighting(stage.light, Opacity<>{24});
    lighting->set(kSheer);
    return draw_mesh<Bubble>(ball, stage.transform, *lighting, band, ReadOnlyDepth(depth)).status;
  });
  frame("strokes", [&](auto& band, const auto& depth) {
    const Floor::Lighting lighting(FloorSurface::Lighting(PackedRgb{}, kOpaque), Fogged{&kMist});
    Status drawn = draw_floor(band, depth);
    if (ok(drawn)) {
      drawn = draw_mesh<Wireframe<>>(ball, stage.transform,
                                     Wireframe<>::Lighting(Unlit::lighting({255, 255, 255})), band, depth)
                  .status;
    }
    if (ok(drawn)) drawn = draw_billboards<Floor>(kPlaces, {1600, 2400}, ahead, lighting, band, depth);
    if (ok(drawn)) drawn = draw_lines(kStrokes, ahead, Unlit::lighting({255, 200, 0}), band, depth);
    if (ok(drawn)) {
      drawn = draw_points(kPlaces, 5, ahead, Unlit::lighting({0, 255, 80}), band, depth, DepthBias{4});
    }
    return drawn;
  });
  frame("chrome", [&](auto& band, const auto& depth) {
    const EnvironmentMap<Palette8Texels<>> lighting(kOpaque, Rotation::about_x(Turn{4551}));
    return draw_mesh<Chrome>(ball, stage.transform, lighting, band, depth).status;
  });
}

}  // namespace arcspan::scenes
