// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <tests/frames/frame_hash.hpp>
#include <tests/frames/stage_set.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

/// Frames that every host must draw alike, in whatever bands its memory allows; tests/frames/hashes.txt pins
/// them.
namespace arcspan::scenes {

inline constexpr auto kSmallSphere = make_sphere<16, 8>();
inline constexpr auto kSmallPlanes = planes_of(kSmallSphere);
inline constexpr auto kSphere = make_sphere<32, 16>();
inline constexpr auto kTorus = make_torus<24, 12>();

/// Room for `Count` transformed vertices of any of the methods.
template <std::size_t Count>
union VertexMemory {
  CachedVertex<Flat<Light>> flat[Count == 0 ? 1 : Count];
  CachedVertex<Gouraud<Light>> gouraud[Count == 0 ? 1 : Count];
  CachedVertex<Arc<Light>> arc[Count == 0 ? 1 : Count];

  constexpr VertexMemory() : flat{} {}

  template <class Method>
  [[nodiscard]] std::span<CachedVertex<Method>> of() {
    if constexpr (std::same_as<Method, Flat<Light>>) return {flat, Count};
    if constexpr (std::same_as<Method, Gouraud<Light>>) return {gouraud, Count};
    if constexpr (std::same_as<Method, Arc<Light>>) return {arc, Count};
  }
};

/// Memory to draw in: the colours and depths of `Rows` rows, a divisor of kHeight, and a cache of `Vertices`.
template <std::int32_t Rows, std::size_t Vertices>
struct Workspace {
  static_assert(kHeight % Rows == 0);
  static constexpr std::int32_t kRows = Rows;
  static constexpr std::size_t kPixels = static_cast<std::size_t>(kWidth) * static_cast<std::size_t>(Rows);
  std::uint16_t colours[kPixels];
  std::uint16_t depths[kPixels];
  VertexMemory<Vertices> vertices;
};

/// Hashes the pixels of a band. Not a part of hash_frame(), whose stack frame lies below that of the drawing.
[[gnu::noinline]] inline void hash_band(const hal::Framebuffer<Rgb565>& band, std::int32_t top,
                                        std::int32_t rows, Hash& hash) {
  for (std::int32_t y = top; y < top + rows; ++y) {
    for (std::int32_t x = 0; x < kWidth; ++x) hash.add(band.pixel(x, y));
  }
}

/// Draws one frame band by band and hashes its pixels from left to right and top to bottom.
template <class Method, class Space>
[[nodiscard]] Status hash_frame(const MeshView& mesh, const StageSet& stage, Space& space, Hash& hash) {
  hal::Framebuffer<Rgb565> band(space.colours, kWidth, Space::kRows);
  DepthBuffer depth(space.depths, kWidth, Space::kRows);
  for (std::int32_t top = 0; top < kHeight; top += Space::kRows) {
    band.move_to(top);
    depth.move_to(top);
    band.clear({16, 16, 32});
    depth.clear();
    // Boards with little memory have room for the small shapes only.
    auto cache = space.vertices.template of<Method>();
    if (cache.size() < mesh.vertex_count()) cache = {};
    const DrawResult drawn = draw_mesh<Method>(mesh, stage.transform, stage.light, band, depth, cache);
    if (!ok(drawn.status)) return drawn.status;
    hash_band(band, top, Space::kRows, hash);
  }
  return Status::kOk;
}

constexpr bool all_frames(int /*shape*/, int /*method*/) { return true; }

/// Calls report(shape, method, status, hash) for every frame: each shape by each method, turned a little
/// further each time. One shape has planes, which do not change its hashes. `Wanted(shape, method)`, both
/// counted from 0: which are built at all, for machines too small for all of them.
template <bool (*Wanted)(int, int) = all_frames, class Space, class Report>
void golden_frames(Space& space, const Report& report) {
  Turn turn{0};
  const auto frames_of = [&]<int ShapeIndex>(const char* name, const auto& shape, const auto&... planes) {
    const auto frame = [&]<class Method, int MethodIndex>(const char* method) {
      if constexpr (Wanted(ShapeIndex, MethodIndex)) {
        MeshView mesh;
        Status status = shape.view(mesh);
        ((status = ok(status) ? planes.attach_to(mesh) : status), ...);
        StageSet stage;
        if (ok(status)) status = set_stage({kWidth, kHeight}, kFrameRadius, turn, stage);
        Hash hash;
        if (ok(status)) status = hash_frame<Method>(mesh, stage, space, hash);
        report(name, method, status, hash.value());
      }
      turn = turn + Turn{1234};
    };
    frame.template operator()<Flat<Light>, 0>("flat");
    frame.template operator()<Gouraud<Light>, 1>("gouraud");
    frame.template operator()<Arc<Light>, 2>("arc");
  };
  frames_of.template operator()<0>("sphere-16x8", kSmallSphere, kSmallPlanes);
  frames_of.template operator()<1>("sphere-32x16", kSphere);
  frames_of.template operator()<2>("torus-24x12", kTorus);
}

}  // namespace arcspan::scenes
