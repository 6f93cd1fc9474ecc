// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/method.hpp>
#include <arcspan/shading/patch/patch.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstdint>

namespace arcspan {

/// `Used` scalars of a row's pixels, by second differences.
template <std::size_t Used>
class PatchScalars {
 public:
  [[nodiscard]] constexpr const std::array<Cosine, Used>& scalars() const { return x_; }
  constexpr void next() {
    unrolled<Used>([this](auto i) {
      x_[i] += d_[i];
      d_[i] += second_difference_[i];
    });
  }

  /// `p` is the distance of the first pixel from the left edge, 16 fraction bits below 1.
  ARCSPAN_INLINE constexpr void start(std::size_t i, const PatchScalar& scalar, std::uint32_t p) {
    // f(p) = at + p slope + p^2 second_difference / 2; f(p + 1) - f(p) = slope + p second_difference +
    // second_difference / 2.
    const Cosine second_difference = scalar.second_difference;
    const Cosine slope = scalar.left.slope;
    const Cosine turn =
        Cosine::from_raw(wrap_mul(second_difference.raw() >> 8, static_cast<std::int32_t>(p >> 8)));
    const Cosine mean = slope + Cosine::from_raw(turn.raw() >> 1);
    x_[i] = scalar.left.at + Cosine::from_raw(wrap_mul(mean.raw() >> 13, static_cast<std::int32_t>(p >> 3)));
    d_[i] = slope + turn + Cosine::from_raw(second_difference.raw() >> 1);
    second_difference_[i] = second_difference;
  }
  /// As `count` calls of next() would leave it, to the last bit.
  constexpr void skip(std::int32_t count) {
    const std::int32_t pairs = static_cast<std::int32_t>(
        (static_cast<std::uint32_t>(count) * static_cast<std::uint32_t>(count - 1)) >> 1);
    unrolled<Used>([&](auto i) {
      x_[i] += Cosine::from_raw(
          wrap_add(wrap_mul(d_[i].raw(), count), wrap_mul(second_difference_[i].raw(), pairs)));
      d_[i] += Cosine::from_raw(wrap_mul(second_difference_[i].raw(), count));
    });
  }
  /// From here on next() goes 2^bits pixels at once, to the same values, to the last bit. Returns bits.
  constexpr int stride(int bits) {
    // n steps of d, d + b, ... are n d + b n (n - 1) / 2.
    const std::int32_t pairs = ((1 << bits) * ((1 << bits) - 1)) >> 1;
    unrolled<Used>([&](auto i) {
      d_[i] = Cosine::from_raw(
          wrap_add(wrap_shl(d_[i].raw(), bits), wrap_mul(second_difference_[i].raw(), pairs)));
      second_difference_[i] = Cosine::from_raw(wrap_shl(second_difference_[i].raw(), 2 * bits));
    });
    return bits;
  }

 private:
  std::array<Cosine, Used> x_;
  std::array<Cosine, Used> d_;
  std::array<Cosine, Used> second_difference_;
};

/// A row's pixels by the first `Used` scalars of the illumination.
template <class Lighting, std::size_t Used>
class PatchRun : public PatchScalars<Used> {
 public:
  static constexpr std::size_t kUsed = Used;

  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour(const Lighting& lighting) const {
    if constexpr (Used == Lighting::kScalars) {
      return lighting.colour(this->scalars());
    } else {
      return lighting.diffuse_colour(this->scalars()[0]);
    }
  }
  /// The same, encoded; `encoded` is an EncodedColourTable.
  template <class Format, class Colours>
  [[nodiscard]] ARCSPAN_INLINE constexpr typename Format::Encoded encoded(const Lighting& lighting,
                                                                          const Colours& encoded) const {
    if constexpr (Used == Lighting::kScalars) {
      if constexpr (!Colours::kForHighlights) return Format::encode(colour(lighting));
      return lighting.template encoded<Format>(this->scalars(), encoded);
    } else {
      return encoded[this->scalars()[0]];
    }
  }
};

/// The left edge's scalars, from row to row; walks the patch in place. `RunOf` is a PatchScalars, and knows
/// the colours.
template <class RunOf, std::size_t Count>
class PatchWalker {
 public:
  using Run = RunOf;
  static constexpr std::int32_t kLongestRun = 2 * kGuardBand;

  constexpr PatchWalker(Patch<Count>& patch, bool middle_left) : patch_(&patch), middle_left_(middle_left) {}

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    Run run;
    unrolled<Run::kUsed>([&](auto i) { run.start(i, (*patch_)[i], start.fraction); });
    if (start.skipped != 0) run.skip(start.skipped);
    return run;
  }
  constexpr void next_row() {
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
