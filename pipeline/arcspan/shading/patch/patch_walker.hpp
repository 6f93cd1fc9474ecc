// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/shading/patch/joined_run.hpp>
#include <arcspan/shading/patch/parabola.hpp>
#include <arcspan/shading/patch/patch.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace arcspan {

/// The scalars of a row's pixels, of which there are `Used`, stepped by second differences.
template <std::size_t Used>
class SecondDifferenceRun {
 public:
  [[nodiscard]] constexpr const std::array<Cosine, Used>& scalars() const { return x_; }
  ARCSPAN_INLINE constexpr void next() { step_from<0>(); }

  /// Starts scalar i at a row's first column. `p` is the distance in pixels from the left edge to that
  /// column: 16 fraction bits, 0 or more and below 1.
  ARCSPAN_INLINE constexpr void start(std::size_t i, const PatchScalar& scalar, std::uint32_t p) {
    start_at(i, parabola_from_edge(scalar, p));
  }
  /// Starts scalar i at a pixel from its value, its first difference and its second difference.
  ARCSPAN_INLINE constexpr void start_at(std::size_t i, const Parabola& f) {
    x_[i] = f.x;
    d_[i] = f.d;
    second_difference_[i] = f.second_difference;
  }
  /// Steps `count` pixels at once, the scalars from I on; the result is bit-identical to that of `count`
  /// calls of next().
  template <std::size_t I = 0>
  ARCSPAN_INLINE constexpr void skip(std::int32_t count) {
    const auto steps = static_cast<std::uint32_t>(count);
    const auto pairs = static_cast<std::int32_t>((steps * (steps - 1)) >> 1);
    x_[I] += Cosine::from_raw(
        wrap_add(wrap_mul(d_[I].raw(), count), wrap_mul(second_difference_[I].raw(), pairs)));
    d_[I] += Cosine::from_raw(wrap_mul(second_difference_[I].raw(), count));
    if constexpr (I + 1 < Used) skip<I + 1>(count);
  }
  /// Makes every following next() step 2^bits pixels and returns `bits` (StridedRun). The values are
  /// bit-identical to those of single steps.
  constexpr int stride(int bits) {
    // The sum of the n steps d, d + b, d + 2 b ... is n d + b n (n - 1) / 2.
    const std::int32_t pairs = ((1 << bits) * ((1 << bits) - 1)) >> 1;
    unrolled<Used>([&](auto i) {
      d_[i] = Cosine::from_raw(
          wrap_add(wrap_shl(d_[i].raw(), bits), wrap_mul(second_difference_[i].raw(), pairs)));
      second_difference_[i] = Cosine::from_raw(wrap_shl(second_difference_[i].raw(), 2 * bits));
    });
    return bits;
  }

 private:
  /// Steps the scalars from I on. Not by unrolled(), whose function -Os would call, with scalars in memory.
  template <std::size_t I>
  ARCSPAN_INLINE constexpr void step_from() {
    x_[I] += d_[I];
    d_[I] += second_difference_[I];
    if constexpr (I + 1 < Used) step_from<I + 1>();
  }

  std::array<Cosine, Used> x_;
  std::array<Cosine, Used> d_;
  std::array<Cosine, Used> second_difference_;
};

/// True if the pixels of `Used` scalars are coloured by R·V of one light, from the product of both.
template <class Lighting, std::size_t Used>
inline constexpr bool kHasProduct = kHasWideRegisters&& Used == 2 && requires {
  requires Lighting::kHasTables;
};

/// The pixels of a row (PixelRun), coloured by `Used` scalars: all of the illumination, or without highlight
/// the diffuse_scalar() or N·L of every light.
template <class Lighting, std::size_t Used>
class PatchRun
    : public std::conditional_t<kHasProduct<Lighting, Used>, JoinedRun<1, true>, SecondDifferenceRun<Used>> {
 public:
  static constexpr std::size_t kUsed = Used;
  using Diffuse = PatchRun<Lighting, 1>;  ///< the pixels without highlight

  /// The lighting's type of colours.
  using Shade = decltype(std::declval<const Lighting&>().colour(
      std::declval<const std::array<Cosine, Lighting::kScalars>&>()));
  [[nodiscard]] ARCSPAN_INLINE constexpr Shade colour(const Lighting& lighting) const {
    if constexpr (Used == Lighting::kScalars) {
      return lighting.colour(this->scalars());
    } else {
      return lighting.diffuse_colour(diffuse(lighting));
    }
  }
  /// Returns the parts of colour() (LightRun).
  [[nodiscard]] ARCSPAN_INLINE constexpr PixelLight light(const Lighting& lighting) const {
    if constexpr (Used == Lighting::kScalars) {
      return lighting.light(this->scalars());
    } else {
      return {lighting.diffuse_colour(diffuse(lighting)), {}};
    }
  }

 private:
  [[nodiscard]] ARCSPAN_INLINE constexpr Cosine diffuse(const Lighting& lighting) const {
    if constexpr (Used == 1) {
      return this->scalars()[0];
    } else {
      return lighting.diffuse_sum(this->scalars());
    }
  }
};

/// Steps the scalars of the left edge from row to row (RowWalker). It changes the patch in place. `RunOf` is
/// the type of its runs, a SecondDifferenceRun with colours.
template <class RunOf, std::size_t Count>
class PatchWalker {
 public:
  using Run = RunOf;

  constexpr PatchWalker(Patch<Count>& patch, bool middle_left) : patch_(&patch), middle_left_(middle_left) {}

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    Run run;
    unrolled<Run::kUsed>([&](auto i) { run.start(i, (*patch_)[i], start.fraction); });
    if (start.skipped != 0) run.skip(start.skipped);
    return run;
  }
  ARCSPAN_INLINE constexpr void next_row() {
    unrolled<Run::kUsed>([this](auto i) { (*patch_)[i].left.advance(); });
  }
  constexpr void enter_lower() {
    if (!middle_left_) return;
    unrolled<Run::kUsed>([this](auto i) { (*patch_)[i].left.become((*patch_)[i].lower); });
  }

 private:
  Patch<Count>* patch_;
  bool middle_left_;
};

}  // namespace arcspan
