// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/draw_options.hpp>
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/lighting/illumination.hpp>
#include <arcspan/lighting/toon.hpp>
#include <arcspan/numbers/copy_words.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/scene/scene_light.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/shading/relight.hpp>
#include <arcspan/shading/unlit.hpp>
#include <arcspan/status.hpp>
#include <arcspan/vertex/rotation.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace arcspan {

/// A shading method with the features of draw_mesh() that it is used with. A program lists its combinations
/// in SceneMemory; a method stands for itself with the default features.
///
/// A material is made for one ambient light and, if its method takes a single light, for the strength and
/// colour of that. If these change, draw_scene() returns kLightChanged. With `ChangingLight`, for methods
/// with a single light, it makes the material again instead, for each object whose light differs: under point
/// lights for each. That takes about as many instructions as 20,000 pixels. Methods with several lights
/// follow changes of their strength and colour, but not of the ambient light.
template <ShadingMethod M, DrawFeatures F = DrawFeatures{}, bool ChangingLight = false>
struct Use {
  using Method = M;
  static constexpr DrawFeatures kFeatures = F;
  static constexpr bool kChangingLight = ChangingLight;
};

namespace detail {

template <class T>
struct UseOf {
  using Type = Use<T>;
};
template <class M, DrawFeatures F, bool C>
struct UseOf<Use<M, F, C>> {
  using Type = Use<M, F, C>;
};

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
Illumination<Lights, Model, Features> illumination_in(const Illumination<Lights, Model, Features>&);

/// A Lighting that is or derives from an Illumination.
template <class Lighting>
concept Lit = requires(const Lighting& lighting) {
  illumination_in(lighting);
};

template <Lit Lighting>
using IlluminationOf = decltype(illumination_in(std::declval<Lighting>()));

/// A Lighting that depends on how the camera sees the object: set_rotation() gets the rotation from object to
/// view space.
template <class Lighting>
concept FollowsView = requires(Lighting& lighting, const Rotation& rotation) {
  lighting.set_rotation(rotation);
};

/// The facts of a Use that the code for all of them needs. Its address tells which use a material is for.
struct UseFacts {
  std::uint16_t vertex_bytes;  ///< of a cached vertex
  std::uint8_t lights;         ///< that the method takes; 0 for none
  bool needs_grey_lights;      ///< several lights must not be coloured
};

template <class U>
[[nodiscard]] consteval UseFacts facts_of() {
  using Method = typename U::Method;
  UseFacts facts{sizeof(CachedVertex<Method>), 0, false};
  if constexpr (Lit<typename Method::Lighting>) {
    using Illuminated = IlluminationOf<typename Method::Lighting>;
    facts.lights = static_cast<std::uint8_t>(Illuminated::kLights);
    facts.needs_grey_lights = Illuminated::kLights > 1 && !Illuminated::kFeatures.coloured_lights;
  }
  return facts;
}

template <class U>
inline constexpr UseFacts kUseFacts = facts_of<U>();

/// The lights as one object sees them.
struct ObjectLights {
  std::array<DirectionalLight, 4> lights;  ///< missing ones have no strength
  ChannelCoefficients ambient;
  Direction to_eye;
};

}  // namespace detail

namespace detail::refused {  // further reasons of PreparedMaterial::of()
void ambient_light_outside_0_to_1();
void half_distance_of_light_not_above_0();
}  // namespace detail::refused

/// The base of all PreparedMaterial types: the part of a material that does not depend on the shading method.
class SceneMaterial {
 public:
  /// @cond for draw_mesh() and draw_scene(), not in the reference
  [[nodiscard]] constexpr const detail::UseFacts* use() const { return use_; }
  /// @endcond

 protected:
  /// @cond for draw_mesh() and draw_scene(), not in the reference
  constexpr explicit SceneMaterial(const detail::UseFacts& use) : use_(&use) {}
  /// @endcond

 private:
  const detail::UseFacts* use_;
};

namespace detail {

/// `a` times `b` per channel, rounded.
[[nodiscard]] constexpr ChannelCoefficients product(const ChannelCoefficients& a,
                                                    const ChannelCoefficients& b) {
  return {multiply<Coefficient>(a.r, b.r), multiply<Coefficient>(a.g, b.g), multiply<Coefficient>(a.b, b.b)};
}

/// The material under ambient light of a colour in 0...1.
[[nodiscard]] constexpr Material under(const ChannelCoefficients& ambient, const Material& material) {
  Material lit = material;
  // Out of range in the same cases as the material is.
  if (in_unit_range(material.ambient)) lit.ambient = product(material.ambient, ambient);
  return lit;
}

}  // namespace detail

/// A material ready for drawing by one shading method: colour ramp, power table and all else that does not
/// depend on directions. Usually a constant in flash. `M` is a method or a Use.
template <class M>
class PreparedMaterial : public SceneMaterial {
 public:
  /// @cond for draw_mesh() and draw_scene(), not in the reference
  using Used = typename detail::UseOf<M>::Type;
  static constexpr bool kIsLit = detail::Lit<typename Used::Method::Lighting>;
  /// @endcond
  using Method = typename Used::Method;
  using Lighting = typename Method::Lighting;

  /// Prepares `material` for the lights of a scene. Their directions do not matter. Keeps the texture,
  /// and the parameters of an operation, of `prepared`. Returns, and does not change `prepared` unless kOk,
  /// kTooManyLights or the status of Illumination::make().
  [[nodiscard]] static constexpr Status make(const Material& material, const LightList& lights,
                                             const DrawOptions& options, PreparedMaterial& prepared) {
    using Illumination = detail::IlluminationOf<Lighting>;
    Status status = detail::check_lights(lights, Illumination::kLights);
    if (!ok(status)) return status;
    constexpr Direction kAhead = normalised(0, 0, 1);
    std::array<DirectionalLight, Illumination::kLights> all{};
    for (DirectionalLight& light : all) light = {kAhead, Coefficient{}, kWhite};
    for (std::size_t i = 0; i < lights.lights.size(); ++i) {
      all[i] = {kAhead, lights.lights[i].strength(), lights.lights[i].colour()};
    }
    Illumination& illumination = prepared.lighting_;  // a copy takes 2 KB of stack
    status = Illumination::make(detail::under(lights.ambient, material), all, kAhead, illumination);
    if (!ok(status)) return status;
    detail::relight(prepared.lighting_, illumination);
    (void)prepared.set_tolerance(kDefaultTolerance);
    prepared.options_ = options;
    prepared.made_for_.ambient = lights.ambient;
    if constexpr (kSingleLight) {
      prepared.made_for_.weights = detail::channel_weights(all[0]);
      if constexpr (Used::kChangingLight) prepared.made_for_.material = material;
    }
    return Status::kOk;
  }

  /// make() as a constant. Arguments that make() rejects do not compile.
  [[nodiscard]] static consteval PreparedMaterial of(const Material& material, const LightList& lights,
                                                     const DrawOptions& options = {}) requires(kIsLit) {
    PreparedMaterial prepared;
    const Status status = make(material, lights, options, prepared);
    if (ok(status)) return prepared;
    if (status == Status::kTooManyLights) detail::refuse(status);
    if (!detail::in_unit_range(lights.ambient)) detail::refused::ambient_light_outside_0_to_1();
    detail::refuse_material(material, detail::IlluminationOf<Lighting>::kFeatures);
    for (const SceneLight& light : lights.lights) {
      detail::refuse_light(light.strength(), light.colour());
      if (!light.valid()) detail::refused::half_distance_of_light_not_above_0();
    }
    detail::refused::features_lack_coloured_lights();
    return prepared;
  }
  /// A material from the method's own data, such as Unlit::lighting(colour). A lit one is for scenes whose
  /// ambient light is white; if its method takes a single light, that is white and of strength 1.
  constexpr explicit PreparedMaterial(const Lighting& lighting,
                                      const DrawOptions& options = {}) requires(!kIsLit ||
                                                                                !Used::kChangingLight)
      : PreparedMaterial(lighting, options, Unchecked{}) {}
  /// Black. A place for make().
  constexpr PreparedMaterial() : SceneMaterial(detail::kUseFacts<Used>), lighting_{} {}

  [[nodiscard]] constexpr const DrawOptions& options() const { return options_; }
  [[nodiscard]] constexpr const Lighting& lighting() const { return lighting_; }
  /// Illumination::set_tolerance(), which is kDefaultTolerance after make() and of().
  constexpr Status set_tolerance(std::int32_t steps) requires(kIsLit) {
    return lighting_.set_tolerance(steps);
  }
  static constexpr std::int32_t kDefaultTolerance = 1;
  /// Illumination::set_toon(), for a material that draw_scene() does not make again (Use).
  constexpr Status set_toon(std::int32_t steps) requires(kIsLit && !Used::kChangingLight) {
    if constexpr (requires(const detail::IlluminationOf<Lighting>& lit) { lighting_.relight(lit); }) {
      detail::IlluminationOf<Lighting> illumination = lighting_;
      const Status status = illumination.set_toon(steps);
      if (ok(status)) lighting_.relight(illumination);
      return status;
    } else {
      return lighting_.set_toon(steps);
    }
  }

  /// Changes the texture (Textured), or the parameters of an operation (WithOperation).
  template <class Part>
  constexpr void set(const Part& part) {
    lighting_.set(part);
  }
  /// A copy changed by set().
  template <class Part>
  [[nodiscard]] constexpr PreparedMaterial with(const Part& part) const {
    PreparedMaterial copy = *this;
    copy.set(part);
    return copy;
  }

  /// @cond for draw_mesh() and draw_scene(), not in the reference
  /// Sets `lighting` to this material under the lights of one object. Returns kLightChanged as Use states.
  [[nodiscard]] constexpr Status light(const detail::ObjectLights& seen, Lighting& lighting) const {
    using Illumination = detail::IlluminationOf<Lighting>;
    std::array<DirectionalLight, Illumination::kLights> lights{};
    std::array<Direction, Illumination::kLights> towards{};
    for (std::size_t i = 0; i < lights.size(); ++i) {
      lights[i] = seen.lights[i];
      towards[i] = lights[i].towards;
    }
    if (!is_made_for(seen)) {
      if constexpr (kSingleLight && Used::kChangingLight) {
        // A point light in the object's middle has no direction, which make() takes without a strength only.
        if (towards[0] == Direction{}) lights[0].strength = {};
        copy_words(lighting_, lighting);
        Illumination& illumination = lighting;
        Status status = Illumination::make(detail::under(seen.ambient, made_for_.material), lights,
                                           seen.to_eye, illumination);
        if (ok(status)) status = illumination.set_tolerance(lighting_.tolerance());
        if (ok(status)) detail::relight(lighting, illumination);
        return status;
      }
      return Status::kLightChanged;
    }
    copy_words(lighting_, lighting);
    lighting.set_directions(towards, seen.to_eye);
    if constexpr (!kSingleLight) lighting.set_strengths(lights);
    return Status::kOk;
  }
  /// @endcond

 private:
  struct Unchecked {};
  constexpr PreparedMaterial(const Lighting& lighting, const DrawOptions& options, Unchecked)
      : SceneMaterial(detail::kUseFacts<Used>), options_(options), lighting_(lighting) {}

  struct Nothing {};
  /// The ambient light that the material was made for.
  struct MadeFor {
    ChannelCoefficients ambient = kWhite;
  };
  /// With a single light also its weights, and the material from which it is made again if Use allows that.
  struct MadeForOne : MadeFor {
    detail::ChannelWeights weights = detail::kFullWeights;
    std::conditional_t<Used::kChangingLight, Material, Nothing> material{};
  };
  static constexpr bool kSingleLight = detail::kUseFacts<Used>.lights == 1;

  /// Whether the material was made for these lights, as far as they are part of it.
  [[nodiscard]] constexpr bool is_made_for(const detail::ObjectLights& seen) const {
    if (seen.ambient != made_for_.ambient) return false;
    if constexpr (kSingleLight) {
      const detail::ChannelWeights now = detail::channel_weights(seen.lights[0]);
      const detail::ChannelWeights& then = made_for_.weights;
      return now[0] == then[0] && now[1] == then[1] && now[2] == then[2];  // == would call memcmp
    } else {
      return true;
    }
  }

  DrawOptions options_{};
  Lighting lighting_;
  [[no_unique_address]] std::conditional_t<kSingleLight, MadeForOne,
                                           std::conditional_t<kIsLit, MadeFor, Nothing>>
      made_for_{};
};

}  // namespace arcspan
