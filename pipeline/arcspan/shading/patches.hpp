// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/patch.hpp>
#include <arcspan/shading/method.hpp>

#include <array>
#include <cstdint>

namespace arcspan {

/// `Used` scalars of a row's pixels, by second differences.
template <std::size_t Used>
class PatchScalars {
 public:
  [[nodiscard]] constexpr const std::array<Unit, Used>& scalars() const { return x_; }
  constexpr void next() {
    unrolled<Used>([this](auto i) {
      x_[i] += d_[i];
      d_[i] += bend_[i];
    });
  }

  /// `p` is the distance of the first pixel from the left edge, 16 fraction bits below 1.
  [[gnu::always_inline]] constexpr void start(std::size_t i, const PatchScalar& scalar, std::uint32_t p) {
    // f(p) = at + p slope + p^2 bend / 2; f(p + 1) - f(p) = slope + p bend + bend / 2.
    const Unit bend = scalar.bend;
    const Unit slope = scalar.left.slope;
    const Unit turn = Unit::from_raw(wrap_mul(bend.raw() >> 8, static_cast<std::int32_t>(p >> 8)));
    const Unit mean = slope + Unit::from_raw(turn.raw() >> 1);
    x_[i] = scalar.left.at + Unit::from_raw(wrap_mul(mean.raw() >> 13, static_cast<std::int32_t>(p >> 3)));
    d_[i] = slope + turn + Unit::from_raw(bend.raw() >> 1);
    bend_[i] = bend;
  }
  /// As `count` calls of next() would leave it, to the last bit.
  constexpr void skip(std::int32_t count) {
    const std::int32_t pairs = static_cast<std::int32_t>(
        (static_cast<std::uint32_t>(count) * static_cast<std::uint32_t>(count - 1)) >> 1);
    unrolled<Used>([&](auto i) {
      x_[i] += Unit::from_raw(wrap_add(wrap_mul(d_[i].raw(), count), wrap_mul(bend_[i].raw(), pairs)));
      d_[i] += Unit::from_raw(wrap_mul(bend_[i].raw(), count));
    });
  }
  /// From here on next() goes 2^bits pixels at once, to the same values, to the last bit. Returns bits.
  constexpr int stride(int bits) {
    // n steps of d, d + b, ... are n d + b n (n - 1) / 2.
    const std::int32_t pairs = ((1 << bits) * ((1 << bits) - 1)) >> 1;
    unrolled<Used>([&](auto i) {
      d_[i] = Unit::from_raw(wrap_add(wrap_shl(d_[i].raw(), bits), wrap_mul(bend_[i].raw(), pairs)));
      bend_[i] = Unit::from_raw(wrap_shl(bend_[i].raw(), 2 * bits));
    });
    return bits;
  }

 private:
  std::array<Unit, Used> x_;
  std::array<Unit, Used> d_;
  std::array<Unit, Used> bend_;
};

/// A row's pixels by the first `Used` scalars of the illumination.
template <class Object, std::size_t Used>
class PatchRun : public PatchScalars<Used> {
 public:
  static constexpr std::size_t kUsed = Used;

  [[nodiscard, gnu::always_inline]] constexpr PackedRgb colour(const Object& object) const {
    if constexpr (Used == Object::kScalars) {
      return object.colour(this->scalars());
    } else {
      return object.diffuse_colour(this->scalars()[0]);
    }
  }
  /// The same, encoded; `codes` is a CodeTable.
  template <class Format, class Codes>
  [[nodiscard, gnu::always_inline]] constexpr typename Format::Code code(const Object& object,
                                                                         const Codes& codes) const {
    if constexpr (Used == Object::kScalars) {
      if constexpr (!Codes::kForHighlights) return Format::encode(colour(object));
      return object.template code<Format>(this->scalars(), codes);
    } else {
      return codes[this->scalars()[0]];
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

  [[nodiscard, gnu::always_inline]] constexpr Run row(const RowStart& start) const {
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
