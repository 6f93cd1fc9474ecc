// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>

#include <array>
#include <vector>

namespace arcspan::test {

/// What the span stage had at one pixel.
struct ProbeSample {
  std::array<Cosine, 3> scalars;  ///< N·L, N·H, N·V
  Rgb8 matt;
  Rgb8 blinn;
  Rgb8 phong;
};

/// An illumination for methods of the literature that writes down every pixel: its scalars, and the colours
/// that the real illuminations make of them. Pixels come in the order of the sink's runs.
struct Probe {
  using Blinn = Illumination<1, Highlight::kBlinn>;
  using Phong = Illumination<1, Highlight::kPhong>;
  static constexpr std::size_t kScalars = 3;
  static constexpr std::size_t kLights = 3;  ///< not one, so that every triangle carries all scalars
  static constexpr bool kHasRamp = false;
  using Scalars = std::array<Cosine, kScalars>;

  [[nodiscard]] Scalars scalars(const Direction& normal) const {
    return {dot(normal, axes[0]), dot(normal, axes[1]), dot(normal, axes[2])};
  }
  [[nodiscard]] PackedRgb colour(const Scalars& s) const {
    samples->push_back({s, matt->colour({s[0], s[1]}).rgb8(), blinn->colour({s[0], s[1]}).rgb8(),
                        phong->colour({s[0], s[2]}).rgb8()});
    return {};
  }

  std::array<Direction, 3> axes{};
  const Blinn* matt = nullptr;
  const Blinn* blinn = nullptr;
  const Phong* phong = nullptr;
  std::vector<ProbeSample>* samples = nullptr;
};

}  // namespace arcspan::test
