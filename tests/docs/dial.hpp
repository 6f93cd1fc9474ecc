// SPDX-License-Identifier: MIT
// The dial and the needle of docs/interaction.md.
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/vertex/rotation.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

using namespace arcspan;

// A tick at 12 o'clock, turned to all hours.
constexpr auto kTicks = [] {
  std::array<ObjectPosition, 48> ticks{};
  constexpr std::int32_t kCorners[4][2] = {{-600, 24000}, {600, 24000}, {600, 32000}, {-600, 32000}};
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const Turn turn{static_cast<std::uint16_t>(i / 4 * 65536 / 12)};
    const std::int64_t s = sine(turn).raw(), c = cosine(turn).raw();  // 30 fraction bits
    const auto& [x, y] = kCorners[i % 4];
    ticks[i] = {static_cast<std::int16_t>((c * x + s * y) >> 30),
                static_cast<std::int16_t>((c * y - s * x) >> 30), 0};
  }
  return ticks;
}();
constexpr auto kTickFaces = [] {
  std::array<std::uint8_t, 72> faces{};
  constexpr std::size_t kTwo[] = {0, 1, 2, 0, 2, 3};
  for (std::size_t i = 0; i < faces.size(); ++i)
    faces[i] = static_cast<std::uint8_t>(i / 6 * 4 + kTwo[i % 6]);
  return faces;
}();
constexpr ObjectPosition kTip{0, 29000, 0};
constexpr std::array<ObjectPosition, 3> kNeedle{{{-1200, -4000, 0}, {1200, -4000, 0}, kTip}};
constexpr std::uint8_t kNeedleFace[] = {0, 1, 2};
constexpr std::array<PackedNormal, 48> kNoNormals{};  // nothing is lit
constexpr MeshView kDialMesh = MeshView::of(kTicks, kNoNormals, kTickFaces);
constexpr MeshView kNeedleMesh = MeshView::of(kNeedle, std::span(kNoNormals).first(3), kNeedleFace);
