// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/pixel/colour.hpp>

#include <arcspan_tools/mesh/plain/model.hpp>
#include <arcspan_tools/support/vec3.hpp>

#include <optional>

namespace arcspan::tools {

/// A share of light, 0...1: one for each channel, or one number for all three.
struct Share {
  Vec3 rgb;

  Share(double all) : rgb{all, all, all} {}  // NOLINT(google-explicit-constructor)
  Share(Vec3 channels) : rgb(channels) {}    // NOLINT(google-explicit-constructor)
};

/// A surface in doubles: pixel = emission + ambient colour * ambient + colour * diffuse * max(0, N·L) +
/// specular * highlight, channel by channel. All 0...1.
struct Surface {
  Vec3 colour{0.86, 0.52, 0.30};
  Share ambient = 0.14;
  Share diffuse = 0.78;
  Share specular = 0.45;
  std::int32_t shininess = 40;
  /// The N·L, 0...1, below which the highlight fades out; 0 if it ends at the terminator.
  double highlight_fade = 0;
  std::optional<Vec3> ambient_colour{};  ///< `colour` if unset
  Vec3 emission{};
};

/// Members of a Surface that a user has set, and that the materials of a file leave as they are.
struct SurfaceChoice {
  bool colour = false;
  bool ambient = false;
  bool diffuse = false;
  bool specular = false;
  bool shininess = false;
};

/// `surface` with what the file says of its material, except for what the user has chosen. An unlit surface
/// shows its colour, whatever shares of light the user has chosen. A textured one without a colour is white.
[[nodiscard]] Surface with_material(Surface surface, const FileMaterial& material,
                                    const SurfaceChoice& chosen);

/// A light: where it is seen from the object, a direction of any length, how far away it is, and its colour,
/// 0...1 per channel.
struct SceneLight {
  Vec3 towards;
  double distance = 0;
  Vec3 colour{1, 1, 1};

  SceneLight(Vec3 v, double d = 0) : towards(v), distance(d) {}  // NOLINT(google-explicit-constructor)
  SceneLight(double x, double y, double z) : towards{x, y, z} {}
};

/// The pipeline's form of `light`: its strength is 1 / (d + K) with K = `attenuation` (S1), 1 at most.
/// Colours outside 0...1 are clamped.
[[nodiscard]] DirectionalLight to_fixed(const SceneLight& light, double attenuation);

/// The pipeline's form of `surface`. Values outside 0...1 are clamped.
[[nodiscard]] Material to_fixed(const Surface& surface);

/// A colour of three channels 0...1 in 8 bits.
[[nodiscard]] Rgb8 to_rgb8(Vec3 colour);

}  // namespace arcspan::tools
