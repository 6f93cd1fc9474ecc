// SPDX-License-Identifier: MIT
#include <arcspan/lighting/toon.hpp>
#include <arcspan/shading/textured/light_tables.hpp>

#include <arcspan_tools/render/any_illumination.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace arcspan::tools {
namespace {

template <class Wrapped>
class CallsOf final : public IlluminationCalls {
 public:
  CallsOf(const Material& material, const RenderJob& job) {
    std::array<DirectionalLight, kLights> copies;
    std::copy(job.lights.begin(), job.lights.end(), copies.begin());
    Status status = Wrapped::make(material, copies, job.to_eye, wrapped_);
    if constexpr (Wrapped::kHasRamp) {
      if (ok(status) && job.toon_steps != 0) status = wrapped_.set_toon(job.toon_steps);
    }
    if (!ok(status)) throw Failure("illumination", to_string(status));
    if constexpr (Tables::kHasShines) tables_ = Tables(wrapped_);
  }

  [[nodiscard]] bool has_ramp() const override { return Wrapped::kHasRamp; }
  [[nodiscard]] AnyScalars scalars(const Direction& normal) const override {
    const Scalars few = wrapped_.scalars(normal);
    AnyScalars all{};
    for (std::size_t i = 0; i < kLights; ++i) {
      all[i] = few[i];
      all[kAnyLights + i] = few[Wrapped::highlight_index(i)];
    }
    return all;
  }
  [[nodiscard]] PackedRgb colour(const AnyScalars& scalars) const override {
    return wrapped_.colour(few_of(scalars));
  }
  [[nodiscard]] DeepColour deep_colour(const AnyScalars& scalars) const override {
    return wrapped_.deep_colour(few_of(scalars));
  }
  [[nodiscard]] Cosine diffuse_scalar(const AnyScalars& scalars, std::uint32_t lit) const override {
    if constexpr (Wrapped::kHasRamp) return wrapped_.diffuse_scalar(few_of(scalars), lit);
    return {};
  }
  [[nodiscard]] Cosine diffuse_sum(const AnyScalars& scalars) const override {
    if constexpr (Wrapped::kHasRamp && kLights > 1) {
      return wrapped_.diffuse_sum(few_of(scalars));
    } else {
      return scalars[0];
    }
  }
  [[nodiscard]] PackedRgb diffuse_colour(Cosine normal_light) const override {
    if constexpr (Wrapped::kHasRamp) return wrapped_.diffuse_colour(normal_light);
    return {};
  }
  [[nodiscard]] LinearLevel linear_level() const override {
    if constexpr (Wrapped::kHasRamp) return wrapped_.linear_level();
    return {};
  }

  [[nodiscard]] Status set_tolerance(std::int32_t steps) override { return wrapped_.set_tolerance(steps); }
  [[nodiscard]] bool is_dark(const AnyScalars& a, const AnyScalars& b, const AnyScalars& c) const override {
    return wrapped_.is_dark(few_of(a), few_of(b), few_of(c));
  }
  [[nodiscard]] TriangleLight light_over(const AnyScalars& a, const AnyScalars& b, const AnyScalars& c,
                                         std::uint32_t widest) const override {
    return wrapped_.light_over(few_of(a), few_of(b), few_of(c), widest);
  }
  [[nodiscard]] Cosine pixel_scalar(Cosine scalar, std::size_t i) const override {
    const std::size_t light = i % kAnyLights;
    if (light >= kLights) return scalar;
    return wrapped_.pixel_scalar(scalar, i < kAnyLights ? light : Wrapped::highlight_index(light));
  }
  [[nodiscard]] PackedRgb surface_colour(const AnyScalars& scalars) const override {
    return wrapped_.surface_colour(few_of(scalars));
  }
  [[nodiscard]] PixelLight surface_light(const AnyScalars& scalars) const override {
    return wrapped_.surface_light(few_of(scalars));
  }
  [[nodiscard]] ChannelLight channel_light(const AnyScalars& scalars) const override {
    if constexpr (!Wrapped::kHasRamp) return wrapped_.channel_light(few_of(scalars));
    return {};
  }
  [[nodiscard]] std::uint32_t shine(const AnyScalars& scalars) const override {
    if constexpr (Tables::kHasShines) return tables_.shine_at(wrapped_, few_of(scalars));
    return LitTexel<TexelLight::kColoured>::shine_of(surface_light(scalars).highlight);
  }

  [[nodiscard]] bool lit_throughout(const AnyScalars& a, const AnyScalars& b, const AnyScalars& c,
                                    std::uint32_t& lit) const override {
    return wrapped_.lit_throughout(few_of(a), few_of(b), few_of(c), lit);
  }
  [[nodiscard]] bool may_shine(const AnyScalars& a, const AnyScalars& b, const AnyScalars& c,
                               Cosine headroom) const override {
    return arcspan::may_shine(wrapped_, few_of(a), few_of(b), few_of(c), headroom);
  }
  [[nodiscard]] HighlightBound highlights_over(const AnyScalars& a, const AnyScalars& b, const AnyScalars& c,
                                               std::uint32_t ab, std::uint32_t ac,
                                               std::uint32_t bc) const override {
    return arcspan::highlights_over(wrapped_, few_of(a), few_of(b), few_of(c), ab, ac, bc);
  }
  [[nodiscard]] std::uint32_t widest_patch() const override { return wrapped_.widest_patch(); }
  [[nodiscard]] const PowerTable& power() const override { return wrapped_.power(); }

 private:
  static constexpr std::size_t kLights = Wrapped::kLights;
  using Scalars = typename Wrapped::Scalars;
  using Tables = LightTables<Wrapped, TexelLight::kColoured>;

  [[nodiscard]] static Scalars few_of(const AnyScalars& all) {
    Scalars few;
    for (std::size_t i = 0; i < kLights; ++i) {
      few[i] = all[i];
      few[Wrapped::highlight_index(i)] = all[kAnyLights + i];
    }
    return few;
  }

  Wrapped wrapped_;
  Tables tables_;
};

using Calls = std::unique_ptr<IlluminationCalls>;

template <Highlight Model, bool kColoured>
Calls calls_for(const Material& material, const RenderJob& job) {
  // A fade of 0, which firmware leaves out, changes no pixel.
  constexpr IlluminationFeatures kFeatures{.coloured_lights = kColoured, .fading_highlights = true};
  const auto by = [&]<std::size_t Lights>(std::integral_constant<std::size_t, Lights>) -> Calls {
    return std::make_unique<CallsOf<Illumination<Lights, Model, kFeatures>>>(material, job);
  };
  switch (job.lights.size()) {
    case 1:
      // A single light may be coloured anyway.
      if constexpr (!kColoured) return by(std::integral_constant<std::size_t, 1>{});
      break;
    case 2:
      return by(std::integral_constant<std::size_t, 2>{});
    case 3:
      return by(std::integral_constant<std::size_t, 3>{});
    case 4:
      return by(std::integral_constant<std::size_t, 4>{});
  }
  throw Failure("--light", "1 to 4 lights, not " + std::to_string(job.lights.size()));
}

}  // namespace

std::unique_ptr<IlluminationCalls> make_any_illumination(const Material& material, const RenderJob& job) {
  const std::vector<DirectionalLight>& lights = job.lights;
  const bool coloured =
      lights.size() > 1 && std::any_of(lights.begin(), lights.end(), [](const DirectionalLight& light) {
        return light.colour.r != light.colour.g || light.colour.g != light.colour.b;
      });
  if (coloured && job.toon_steps != 0) throw Failure("--toon", "several lights must not be coloured");
  const auto make = coloured ? (job.highlight == Highlight::kBlinn ? &calls_for<Highlight::kBlinn, true>
                                                                   : &calls_for<Highlight::kPhong, true>)
                             : (job.highlight == Highlight::kBlinn ? &calls_for<Highlight::kBlinn, false>
                                                                   : &calls_for<Highlight::kPhong, false>);
  return make(material, job);
}

}  // namespace arcspan::tools
