// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/image/image.hpp>
#include <arcspan_tools/render/render.hpp>
#include <arcspan_tools/support/vec3.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace arcspan::tools {

/// The correct picture by one of two definitions: Phong's own interpolation (normals along chords, then
/// normalised), or the spherical one (S0 eq. 2, along the edges and then along the rows).
enum class ReferenceKind : std::uint8_t { kPhong, kSlerp };

/// Red, green, blue in 8-bit steps, 0...255, not rounded.
using ChannelLevels = std::array<double, 3>;

/// Ambient and diffuse light, and highlights, which textures leave as they are; not clamped.
struct LightLevels {
  ChannelLevels diffuse{};
  ChannelLevels highlight{};

  /// The light that a surface reflects which reflects these shares of diffuse light and all of the highlight;
  /// clamped to 0...255.
  [[nodiscard]] ChannelLevels reflected(const std::array<double, 3>& shares = {1, 1, 1}) const {
    ChannelLevels sum;
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] = std::clamp(std::min(diffuse[c], 255.0) * shares[c] + highlight[c], 0.0, 255.0);
    }
    return sum;
  }
};

/// S0 eq. 1 or 12 in doubles.
struct ReferenceIllumination {
  ChannelLevels ambient{};
  ChannelLevels diffuse{};
  ChannelLevels specular{};
  double shininess = 1;
  double highlight_fade = 0;  ///< N·L below which the highlight fades out
  bool phong_highlight = false;
  struct Light {
    Vec3 towards;
    std::array<double, 3> weights{1, 1, 1};  ///< strength times colour, per channel
  };
  std::vector<Light> lights;
  Vec3 to_eye;

  ReferenceIllumination() = default;
  /// The illumination of one part of a job, which has `material`.
  ReferenceIllumination(const RenderJob& job, const Material& material);
  [[nodiscard]] LightLevels light(Vec3 normal) const;
  [[nodiscard]] ChannelLevels levels(Vec3 normal) const { return light(normal).reflected(); }
};

struct ReferenceSample {
  Vec3 normal;  ///< unit length
  ChannelLevels levels{};
  LightLevels light{};  ///< of which `levels` is the clamped sum
};

/// A picture in doubles.
struct ReferencePicture {
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::vector<ReferenceSample> samples;
  /// For every pixel the number of its sample plus 1, or 0 where nothing was drawn.
  std::vector<std::uint32_t> numbers;

  /// Null where nothing was drawn.
  [[nodiscard]] const ReferenceSample* at(std::int32_t x, std::int32_t y) const {
    const std::uint32_t number =
        numbers[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    return number == 0 ? nullptr : &samples[number - 1];
  }
  /// Rounded to 8 bits.
  [[nodiscard]] Image image(Rgb8 background) const;
};

/// Draws the job in doubles: the pipeline's own geometry, coverage and depth, from the same 16-bit positions
/// and packed normals, and the same directions and coefficients.
[[nodiscard]] ReferencePicture draw_reference(const RenderJob& job, ReferenceKind kind);

/// The reference picture of a textured job. `texels` is the picture of the job in full light: it multiplies
/// ambient and diffuse light, and highlights are added.
[[nodiscard]] ReferencePicture with_texels(const ReferencePicture& reference, const Image& texels);

[[nodiscard]] Vec3 to_vec3(const Direction& direction);

}  // namespace arcspan::tools
