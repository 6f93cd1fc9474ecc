// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/linear_normal.hpp>
#include <arcspan/literature/prepared_walker.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>

namespace arcspan {

/// N·N along a row by second differences: N is linear along the row, so N·N is a quadratic.
struct SquaredLength {
  static constexpr int kFine = 8;  ///< more fraction bits of the differences than of the square
  std::int32_t square;             ///< 30 fraction bits
  /// First and second difference per pixel, 38 fraction bits: over m pixels their rounding adds up to
  /// m^2 / 4 units.
  std::int64_t first;
  std::int64_t second;

  [[nodiscard]] static constexpr SquaredLength of(const LinearNormal& n, const LinearNormal& step) {
    const std::int64_t square = product(n.x, n.x) + product(n.y, n.y) + product(n.z, n.z);
    const std::int64_t cross = product(n.x, step.x) + product(n.y, step.y) + product(n.z, step.z);
    const std::int64_t second_difference =
        product(step.x, step.x) + product(step.y, step.y) + product(step.z, step.z);
    return {static_cast<std::int32_t>(square >> kFine), 2 * cross + second_difference, 2 * second_difference};
  }
  constexpr void next() {
    square = wrap_add(square, static_cast<std::int32_t>(first >> kFine));
    first += second;
  }

 private:
  /// a * b, 38 fraction bits of the exact product's 54.
  [[nodiscard]] static constexpr std::int64_t product(Linear a, Linear b) {
    return (std::int64_t{a.raw()} * b.raw() + (std::int32_t{1} << 15)) >> 16;
  }
};

/// Divides scalars by |N|, with one root per normal and one division per scalar. In the methods that use it
/// the span stage divides.
class RootAndDivision {
 public:
  /// `square` is N·N with 30 fraction bits; below 2^-15 it counts as 2^-15.
  constexpr explicit RootAndDivision(std::int32_t square)
      : length_(nearest_root(
            static_cast<std::uint32_t>(square < (std::int32_t{1} << 15) ? std::int32_t{1} << 15 : square))) {}

  /// scalar / |N|, saturated to -1...1.
  [[nodiscard]] constexpr Cosine operator()(Linear scalar) const {
    const std::int32_t rounded = round_shift(scalar.raw(), Linear::kFraction - 1);  // 16 fraction bits
    const std::uint32_t size = static_cast<std::uint32_t>(rounded < 0 ? -rounded : rounded);
    const std::uint32_t held = size < (length_ << 1) ? size : length_ << 1;
    const std::uint32_t quotient = ((held << 15) + (length_ >> 1)) / length_;
    const std::int32_t value = static_cast<std::int32_t>(quotient << 14);
    return Cosine::from_raw(rounded < 0 ? -value : value);
  }

 private:
  std::uint32_t length_;  ///< 15 fraction bits
};

/// A shading method that interpolates the scalars of the normal linearly on the screen: the common part of
/// Duff, Lyon and Dichotomy. The normal is linear as well, but only its squared length is used.
/// `Normaliser(square)(scalar)` divides a scalar (Linear, 27 fraction bits in all) by the root of the squared
/// length (30 fraction bits) and returns a Cosine.
template <class Illumination, class Normaliser>
struct LinearScalars {
  static constexpr std::size_t kScalars = Illumination::kScalars;
  using Lighting = Illumination;
  struct Face {};
  struct Vertex {
    Direction normal;
    std::array<Cosine, kScalars> scalars;
  };
  struct Prepared {
    NormalPlane normal;
    std::array<LinearPlane, kScalars> scalars;
    bool middle_left;

    constexpr void next_row() {
      normal.next_row();
      unrolled<kScalars>([this](auto i) { scalars[i].next_row(); });
    }
    constexpr void enter_lower() {
      normal.enter_lower(middle_left);
      unrolled<kScalars>([this](auto i) { scalars[i].enter_lower(middle_left); });
    }
  };
  static constexpr bool kNeedsFaceNormal = false;

  [[nodiscard]] static Vertex shade_vertex(const Lighting& lighting, const Direction& normal) {
    return {normal, lighting.scalars(normal)};
  }
  [[nodiscard]] static constexpr Face shade_face(const Lighting&, const Direction&) { return {}; }

  /// The scalars are cut like the normal: linearly between a and b, then divided by the length of the linear
  /// normal.
  [[nodiscard]] static Vertex between(const Vertex& a, const Vertex& b, Factor t) {
    Vertex cut{between_normalised(a.normal, b.normal, t), {}};
    const std::uint32_t chord = squared_chord(to_normal(a.normal), to_normal(b.normal));
    const auto weight = static_cast<std::uint32_t>(wrap_mul(t.raw(), 32768 - t.raw())) >> 15;
    // |a (1-t) + b t|^2 = 1 - t (1-t) |a-b|^2, 30 fraction bits; the chord has 28.
    const std::int32_t square = (std::int32_t{1} << 30) - static_cast<std::int32_t>((chord >> 13) * weight);
    const RootAndDivision normalise(square);
    for (std::size_t i = 0; i < kScalars; ++i) {
      const Cosine from = a.scalars[i];
      const std::int64_t rise = (std::int64_t{b.scalars[i].raw()} - from.raw()) * t.raw();
      cut.scalars[i] =
          normalise(Linear::from_raw(static_cast<std::int32_t>((from.raw() + (rise >> 15)) >> 3)));
    }
    return cut;
  }

  template <class Method>
  static constexpr void prepare(const Lighting&, const TriangleFrame<Method>& frame, const Face&,
                                Prepared& prepared) {
    const Vertex& top = frame.top->shade;
    const Vertex& middle = frame.middle->shade;
    const Vertex& bottom = frame.bottom->shade;
    const auto attribute = [](Cosine scalar) { return as_attribute(round_shift(scalar.raw(), 15)); };
    make_normal_plane(frame, top.normal, middle.normal, bottom.normal, prepared.normal);
    for (std::size_t i = 0; i < kScalars; ++i) {
      make_linear_plane(frame, attribute(top.scalars[i]), attribute(middle.scalars[i]),
                        attribute(bottom.scalars[i]), prepared.scalars[i]);
    }
    prepared.middle_left = frame.middle_left;
  }

  struct Run {
    std::array<Linear, kScalars> scalars;
    std::array<Linear, kScalars> steps;
    SquaredLength squared;

    [[nodiscard]] static constexpr Run of_row(const Prepared& prepared, const RowStart& start) {
      Run run;
      unrolled<kScalars>([&](auto i) {
        run.scalars[i] = linear_at(prepared.scalars[i], start);
        run.steps[i] = prepared.scalars[i].dx;
      });
      run.squared = SquaredLength::of(prepared.normal.at(start), prepared.normal.step());
      return run;
    }
    [[nodiscard]] constexpr PackedRgb colour(const Lighting& lighting) const {
      const Normaliser normalise(squared.square);
      typename Lighting::Scalars values;
      unrolled<kScalars>([&](auto i) { values[i] = normalise(scalars[i]); });
      return lighting.colour(values);
    }
    /// A new piece starts N·N again before the rounding of its differences is visible.
    [[nodiscard]] static constexpr std::int32_t length() { return 256; }
    constexpr void next() {
      unrolled<kScalars>([this](auto i) { scalars[i] += steps[i]; });
      squared.next();
    }
  };

  using Walker = PreparedWalkerInPieces<Prepared, Run>;

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    return draw(Walker(prepared));
  }
};

}  // namespace arcspan
