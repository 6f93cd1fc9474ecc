// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/literature/linear_normal.hpp>

#include <array>
#include <cstddef>

namespace arcspan {

/// N·N along a row by second differences: N is linear in the pixel, so N·N is a quadratic. `square` has 30
/// fraction bits; differences have 38, for their rounding adds up to m^2 / 4 units over m pixels.
struct SquaredLength {
  static constexpr int kFine = 8;
  std::int32_t square;
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
  /// 54 fraction bits become 38.
  [[nodiscard]] static constexpr std::int64_t product(Linear a, Linear b) {
    return (std::int64_t{a.raw()} * b.raw() + (std::int32_t{1} << 15)) >> 16;
  }
};

/// x / |N| by a root and one division a scalar. The span stage divides here.
class RootAndDivision {
 public:
  /// `square` = N·N with 30 fraction bits. Below 2^-15 it counts as 2^-15, and no quotient exceeds 1.
  constexpr explicit RootAndDivision(std::int32_t square)
      : length_(nearest_root(
            static_cast<std::uint32_t>(square < (std::int32_t{1} << 15) ? std::int32_t{1} << 15 : square))) {}

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

/// What Duff's and Lyon's methods share: the scalars of the normal are linear on the screen, and so is the
/// normal, of which only the squared length is used. `Normaliser` makes a unit normal's scalar of a linear
/// one: `Normaliser n(square); n(scalar)`, 27 fraction bits to Cosine.
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
  };
  static constexpr bool kNeedsFaceNormal = false;

  [[nodiscard]] static Vertex shade_vertex(const Lighting& lighting, const Direction& normal) {
    return {normal, lighting.scalars(normal)};
  }
  [[nodiscard]] static constexpr Face shade_face(const Lighting&, const Direction&) { return {}; }

  /// A vertex's scalars and its normal are cut alike: by the chord's fraction, then divided by its length.
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
  [[nodiscard]] static constexpr bool too_wide(const Vertex&, const Vertex&) { return false; }

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
    SquaredLength length;

    [[nodiscard]] constexpr PackedRgb colour(const Lighting& lighting) const {
      const Normaliser normalise(length.square);
      typename Lighting::Scalars values;
      unrolled<kScalars>([&](auto i) { values[i] = normalise(scalars[i]); });
      return lighting.colour(values);
    }
    constexpr void next() {
      unrolled<kScalars>([this](auto i) { scalars[i] += steps[i]; });
      length.next();
    }
  };

  class Walker {
   public:
    using Run = LinearScalars::Run;
    /// Then N·N starts anew, before the rounding of its differences shows.
    static constexpr std::int32_t kLongestRun = 256;
    constexpr explicit Walker(Prepared& prepared) : p_(&prepared) {}
    [[nodiscard]] constexpr Run row(const RowStart& start) const {
      Run run;
      unrolled<kScalars>([&](auto i) {
        run.scalars[i] = linear_at(p_->scalars[i], start);
        run.steps[i] = p_->scalars[i].dx;
      });
      run.length = SquaredLength::of(p_->normal.at(start), p_->normal.step());
      return run;
    }
    constexpr void next_row() {
      p_->normal.next_row();
      unrolled<kScalars>([this](auto i) { p_->scalars[i].next_row(); });
    }
    constexpr void enter_lower() {
      p_->normal.enter_lower(p_->middle_left);
      unrolled<kScalars>([this](auto i) { p_->scalars[i].enter_lower(p_->middle_left); });
    }

   private:
    Prepared* p_;
  };

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    return draw(Walker(prepared));
  }
};

}  // namespace arcspan
