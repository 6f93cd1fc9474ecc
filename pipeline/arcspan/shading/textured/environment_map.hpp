// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/triangle_light.hpp>
#include <arcspan/numbers/direction.hpp>
#include <arcspan/shading/textured/texel_light.hpp>
#include <arcspan/target.hpp>
#include <arcspan/texture/texture.hpp>
#include <arcspan/vertex/rotation.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// A picture of a shiny sphere as the whole illumination of an object: chrome, gold, clay. The x and y of a
/// normal in view space are the two scalars, which arcs interpolate as they do N·L, and a texel is looked up
/// by them: S0's reflection map with a picture that the artist makes ("matcap"). It is the `Illumination` of
/// Arc:
///
///     using Chrome = Arc<EnvironmentMap<DirectTexels<>>>;
///
/// The sphere fills the picture. Of what is outside of it, interpolated normals show a texel or two beyond
/// the rim, so the surround should continue the sphere's colours. As the eye is taken to be far away, a plane
/// surface has one colour.
template <TexelFormat Texels>
class EnvironmentMap {
 public:
  static constexpr std::size_t kLights = 1;
  static constexpr std::size_t kScalars = 2;
  static constexpr bool kHasRamp = false;
  using Scalars = std::array<Cosine, kScalars>;

  constexpr EnvironmentMap() = default;
  /// `rotation`: see set_rotation(). draw_scene() sets it for each object.
  constexpr explicit EnvironmentMap(const Texture<Texels>& picture,
                                    const Rotation& rotation = Rotation::identity())
      : words_(picture.at(0)),
        palette_(picture.palette()),
        width_bits_(picture.size().width_bits),
        height_bits_(picture.size().height_bits) {
    set_rotation(rotation);
  }

  /// False if no picture was given.
  [[nodiscard]] constexpr bool is_made() const { return words_ != Texture<Texels>().at(0); }

  /// `rotation` is from object to view space, orthonormal: the rotation of the Placement.
  constexpr void set_rotation(const Rotation& rotation) {
    axes_ = {rotation.to_object(kRight), rotation.to_object(kDown)};
  }

  /// The view-space x and -y of a unit normal.
  [[nodiscard]] constexpr Scalars scalars(const Direction& normal) const {
    return {dot(normal, axes_[0]), dot(normal, axes_[1])};
  }

  // The further functions that `Arc` calls; Illumination describes them.

  [[nodiscard]] static constexpr bool is_dark(const Scalars&, const Scalars&, const Scalars&) {
    return false;
  }
  /// A plane is off by at most a sixth of the widest squared chord: half a texel.
  [[nodiscard]] constexpr TriangleLight light_over(const Scalars&, const Scalars&, const Scalars&,
                                                   std::uint32_t widest) const {
    const int bits = width_bits_ > height_bits_ ? width_bits_ : height_bits_;
    const bool linear = (widest >> 16) << bits <= std::uint32_t{3} << 12;
    return {LightReach::kHighlight, linear, 0, 0, kWidestQuadratic};
  }
  [[nodiscard]] static constexpr Cosine pixel_scalar(Cosine scalar, std::size_t) { return scalar; }
  /// The texel at (x, -y).
  [[nodiscard]] ARCSPAN_INLINE constexpr UnlitTexel surface_colour(const Scalars& scalars) const {
    const std::uint32_t column = place(scalars[0], width_bits_);
    const std::uint32_t row = place(scalars[1], height_bits_);
    const std::uint32_t index = (row << width_bits_) | column;
    return UnlitTexel(Texels::ColourFormat::rgb565(Texels::stored(words_, palette_, index)));
  }

 private:
  /// The texel of a scalar of -1...1, of 2^bits.
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint32_t place(Cosine scalar, int bits) {
    // Rounding may leave the range by less than a texel.
    constexpr std::int32_t kOne = (std::int32_t{1} << Cosine::kFraction) - 1;
    const std::int32_t inside = scalar.raw() < -kOne ? -kOne : scalar.raw() > kOne ? kOne : scalar.raw();
    return (static_cast<std::uint32_t>(inside) + (std::uint32_t{1} << 30)) >> (31 - bits);
  }

  static constexpr Direction kRight = normalised(1, 0, 0);
  static constexpr Direction kDown = normalised(0, -1, 0);
  std::array<Direction, 2> axes_{};
  const typename Texels::Word* words_ = Texture<Texels>().at(0);
  const std::uint16_t* palette_ = Texture<Texels>().palette();
  int width_bits_ = 3;
  int height_bits_ = 3;
};

}  // namespace arcspan
