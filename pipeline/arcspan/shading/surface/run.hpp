// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/shading/surface/normalise.hpp>
#include <arcspan/shading/surface/surface.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

/// The scalars of a row's pixels in the three orders, and their colours.
namespace arcspan {

/// Scalars stepped by one addition each.
template <std::size_t Used>
struct LinearSteps {
  std::array<Cosine, Used> x;
  std::array<Cosine, Used> d;

  /// Starts scalar i. `p` is the distance from the left edge to the first column inside, 16 fraction bits.
  ARCSPAN_INLINE constexpr void start(std::size_t i, const PlaneScalar& scalar, std::uint32_t p) {
    const std::int32_t inside = wrap_mul(scalar.slope >> 12, static_cast<std::int32_t>(p >> 3));
    x[i] = scalar.left.at + Cosine::from_raw(inside);
    d[i] = Cosine::from_raw(wrap_shl(scalar.slope, 1));
  }
  template <std::size_t I = 0>
  ARCSPAN_INLINE constexpr void next() {
    x[I] += d[I];
    if constexpr (I + 1 < Used) next<I + 1>();
  }
  template <std::size_t I = 0>
  ARCSPAN_INLINE constexpr void skip(std::int32_t count) {
    x[I] += Cosine::from_raw(wrap_mul(d[I].raw(), count));
    if constexpr (I + 1 < Used) skip<I + 1>(count);
  }
  [[nodiscard]] ARCSPAN_INLINE constexpr const std::array<Cosine, Used>& scalars() const { return x; }
};

/// Scalars stepped by two additions each.
template <std::size_t Used>
struct QuadraticSteps {
  std::array<Cosine, Used> x;
  std::array<Cosine, Used> d;
  std::array<Cosine, Used> second_difference;

  /// As above. With b the second difference: f(p) = at + p slope + p^2 b / 2, f(p + 1) - f(p) = slope + p b +
  /// b / 2. What changes along x has `dropped` fraction bits less than 30.
  ARCSPAN_INLINE constexpr void start(std::size_t i, const BentScalar& scalar, std::uint32_t p,
                                      int dropped = 0) {
    const auto times_p = [p](std::int32_t v) { return wrap_mul(v >> 13, static_cast<std::int32_t>(p >> 3)); };
    // With all bits, because each pixel adds its error again. Those of large triangles are small.
    const std::int32_t change = scaled_down(scalar.second_difference, p >> 1, 15);
    const std::int32_t inside = times_p(wrap_add(scalar.left.slope, change >> 1));
    const std::int32_t first = wrap_add(wrap_add(scalar.left.slope, change), scalar.second_difference >> 1);
    x[i] = scalar.left.at + Cosine::from_raw(wrap_shl(inside, dropped));
    d[i] = Cosine::from_raw(wrap_shl(first, dropped));
    second_difference[i] = Cosine::from_raw(wrap_shl(scalar.second_difference, dropped));
  }
  template <std::size_t I = 0>
  ARCSPAN_INLINE constexpr void next() {
    x[I] += d[I];
    d[I] += second_difference[I];
    if constexpr (I + 1 < Used) next<I + 1>();
  }
  /// Steps `count` pixels at once; the result is that of `count` calls of next().
  template <std::size_t I = 0>
  ARCSPAN_INLINE constexpr void skip(std::int32_t count) {
    const auto n = static_cast<std::uint32_t>(count);
    const auto pairs = static_cast<std::int32_t>((n * (n - 1)) >> 1);
    x[I] +=
        Cosine::from_raw(wrap_add(wrap_mul(d[I].raw(), count), wrap_mul(second_difference[I].raw(), pairs)));
    d[I] += Cosine::from_raw(wrap_mul(second_difference[I].raw(), count));
    if constexpr (I + 1 < Used) skip<I + 1>(count);
  }
  [[nodiscard]] ARCSPAN_INLINE constexpr const std::array<Cosine, Used>& scalars() const { return x; }
};

/// Linear scalars of the normalised normal.
template <std::size_t Used>
struct NormalisedSteps {
  LinearSteps<Used> linear;
  QuadraticSteps<1> missing;  ///< 1 - |M|^2

  ARCSPAN_INLINE constexpr void next() {
    linear.next();
    missing.next();
  }
  ARCSPAN_INLINE constexpr void skip(std::int32_t count) {
    linear.skip(count);
    missing.skip(count);
  }
  [[nodiscard]] ARCSPAN_INLINE constexpr std::array<Cosine, Used> scalars() const {
    const std::int32_t k = lengthening(missing.x[0].raw());
    std::array<Cosine, Used> result;
    set<0>(k, result);
    return result;
  }

 private:
  template <std::size_t I>
  ARCSPAN_INLINE constexpr void set(std::int32_t k, std::array<Cosine, Used>& result) const {
    result[I] = lengthened(linear.x[I], k);
    if constexpr (I + 1 < Used) set<I + 1>(k, result);
  }
};

/// The pixels of a row (PixelRun), coloured by all scalars of the lighting, or by the diffuse scalar alone.
template <class Lighting, std::size_t Used, class Steps>
struct SurfaceRun : Steps {
  static constexpr std::size_t kUsed = Used;

  [[nodiscard]] ARCSPAN_INLINE constexpr auto colour(const Lighting& lighting) const {
    if constexpr (Used == Lighting::kScalars) {
      return lighting.surface_colour(this->scalars());
    } else {
      return lighting.diffuse_colour(this->scalars()[0]);
    }
  }
  /// Returns the scalar of diffuse_colour().
  [[nodiscard]] ARCSPAN_INLINE constexpr Cosine diffuse_scalar(const Lighting& lighting) const {
    if constexpr (Used == 1 || Lighting::kLights == 1) {
      return this->scalars()[0];
    } else {
      return lighting.diffuse_sum(this->scalars());
    }
  }
  /// Returns the parts of colour() (LightRun).
  [[nodiscard]] ARCSPAN_INLINE constexpr PixelLight light(const Lighting& lighting) const {
    if constexpr (Used == Lighting::kScalars) {
      return lighting.surface_light(this->scalars());
    } else {
      return {lighting.diffuse_colour(this->scalars()[0]), {}};
    }
  }
};

template <class Lighting, std::size_t Used>
using LinearRun = SurfaceRun<Lighting, Used, LinearSteps<Used>>;
template <class Lighting, std::size_t Used>
using QuadraticRun = SurfaceRun<Lighting, Used, QuadraticSteps<Used>>;
template <class Lighting, std::size_t Used>
using NormalisedRun = SurfaceRun<Lighting, Used, NormalisedSteps<Used>>;

}  // namespace arcspan
