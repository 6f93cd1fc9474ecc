// SPDX-License-Identifier: MIT
#include <arcspan/shading/illumination.hpp>

namespace arcspan {

namespace {

bool in_unit_range(Coefficient c) { return c.raw() >= 0 && c <= Coefficient::of(1.0); }

bool in_unit_range(const ChannelCoefficients& c) {
  return in_unit_range(c.r) && in_unit_range(c.g) && in_unit_range(c.b);
}

/// A coefficient times 255 with `bits` fraction bits, rounded; bits <= 8.
std::uint32_t steps(Coefficient c, Coefficient strength, int bits) {
  const std::uint64_t product =
      std::uint64_t{static_cast<std::uint32_t>(c.raw())} * static_cast<std::uint32_t>(strength.raw()) * 255u;
  const int down = 2 * Coefficient::kFraction - bits;
  return static_cast<std::uint32_t>((product + (std::uint64_t{1} << (down - 1))) >> down);
}

std::array<std::uint32_t, 3> steps(const ChannelCoefficients& c, Coefficient strength, int bits) {
  return {steps(c.r, strength, bits), steps(c.g, strength, bits), steps(c.b, strength, bits)};
}

}  // namespace

template <std::size_t Lights, Highlight Model>
Status Illumination<Lights, Model>::make(const Material& material,
                                         const std::array<DirectionalLight, Lights>& lights,
                                         const Direction& to_eye, Illumination& illumination) {
  if (!in_unit_range(material.ambient) || !in_unit_range(material.diffuse) ||
      !in_unit_range(material.specular) || material.shininess < 1 ||
      material.shininess > PowerTable::kMaxExponent) {
    return Status::kInvalidArgument;
  }
  for (const DirectionalLight& light : lights) {
    if (!in_unit_range(light.strength)) return Status::kInvalidArgument;
  }
  // A single light's strength goes into the coefficients; several are weighted pixel by pixel.
  const Coefficient strength = Lights == 1 ? lights[0].strength : Coefficient::of(1.0);
  constexpr int kCoefficientBits = 5;
  illumination.ambient_ = steps(material.ambient, Coefficient::of(1.0), 20);
  illumination.diffuse_ = steps(material.diffuse, strength, kCoefficientBits);
  illumination.specular_ = steps(material.specular, strength, kCoefficientBits);
  for (std::size_t i = 0; i < Lights; ++i) {
    illumination.axes_[i] = lights[i].towards;
    illumination.strength_[i] = static_cast<std::uint32_t>(lights[i].strength.raw());
    illumination.light_eye_[i] = dot(lights[i].towards, to_eye);
    if (Model == Highlight::kBlinn)
      illumination.axes_[(Lights + i) % kScalars] = half_way(lights[i].towards, to_eye);
  }
  if (Model == Highlight::kPhong) illumination.axes_[Lights] = to_eye;
  illumination.power_ = PowerTable(material.shininess);
  return Status::kOk;
}

template class Illumination<1, Highlight::kBlinn>;
template class Illumination<2, Highlight::kBlinn>;
template class Illumination<3, Highlight::kBlinn>;
template class Illumination<4, Highlight::kBlinn>;
template class Illumination<1, Highlight::kPhong>;
template class Illumination<2, Highlight::kPhong>;
template class Illumination<3, Highlight::kPhong>;
template class Illumination<4, Highlight::kPhong>;

}  // namespace arcspan
