// SPDX-License-Identifier: MIT
#include <arcspan_c/scene.hpp>

#include <cstdint>
#include <new>
#include <type_traits>

namespace arcspan::c {

namespace {

/// Whether a material is for the method and the texture format of a Choice.
template <class Chosen>
[[nodiscard]] bool is_chosen(const MaterialSource& source) {
  using Texels = typename Chosen::Texels;
  if (source.method != Chosen::kNumber || (source.opacity != kOpaque) != Chosen::kBlends) return false;
  if (source.texture.texels.empty() != std::is_void_v<Texels>) return false;
  if constexpr (std::is_void_v<Texels>) {
    return true;
  } else {
    return has_format<Texels>(source.texture);
  }
}

#if ARCSPAN_C_TOON
template <class Prepared>
[[nodiscard]] Status set_toon(Prepared& prepared, std::int32_t steps) {
  if (steps == 0) return Status::kOk;
  if constexpr (Light::kHasRamp) {
    return prepared.set_toon(steps);
  } else {
    return Status::kUnsupported;
  }
}
#endif

template <class Chosen>
[[nodiscard]] Status make_by(MadeMaterial& made, const LightList& lights) {
  using Texels = typename Chosen::Texels;
  using Prepared = PreparedMaterial<typename Chosen::Method>;
  const MaterialSource& source = made.source;
  auto& prepared = *new (made.prepared) Prepared;
  // Ambient light is in the coefficients: scenes are drawn in white, for which models in flash are made.
  Status status = Prepared::make(arcspan::detail::under(lights.ambient, source.material), {lights.lights},
                                 source.options, prepared);
  if (ok(status)) status = prepared.set_tolerance(source.tolerance);
#if ARCSPAN_C_TOON
  if (ok(status)) status = set_toon(prepared, source.toon_steps);
#endif
  if constexpr (!std::is_void_v<Texels>) {
    Texture<Texels> texture;
    if (ok(status)) status = view_texture(source.texture, texture);
    if (ok(status)) prepared.set(texture);
  }
  if constexpr (Chosen::kBlends) prepared.set(Opacity<>{source.opacity});
  return status;
}

template <class... Chosen>
[[nodiscard]] Status make_by_one_of(ChoiceList<Chosen...>, MadeMaterial& made, const LightList& lights) {
  Status status = Status::kUnsupported;
  (void)((is_chosen<Chosen>(made.source) && (status = make_by<Chosen>(made, lights), true)) || ...);
  return status;
}

}  // namespace

Status make_material(MadeMaterial& made, const LightList& lights) {
  return make_by_one_of(AllChoices{}, made, lights);
}

Status make_materials(arcspan_scene& scene) {
  Status status = Status::kOk;
  for (std::uint16_t i = 0; i < scene.material_count && ok(status); ++i) {
    if (is_kept(scene, i, {scene.object_count}))
      status = make_material(scene.materials[i], scene.light_list());
  }
  return status;
}

bool is_kept(const arcspan_scene& scene, std::uint16_t index, const KeepingParts& parts) {
  for (std::size_t i = 0; i < parts.end; ++i) {
    const bool changes = i >= parts.first_changed && i < parts.end_changed;
    if (scene.own[i] == index || (scene.shown[i] == index && !changes)) return true;
  }
  return false;
}

std::uint16_t find_material(const arcspan_scene& scene, const MaterialSource& source,
                            const KeepingParts& parts) {
  for (std::uint16_t i = 0; i < scene.material_count; ++i) {
    if (is_same(scene.materials[i].source, source) && is_kept(scene, i, parts)) return i;
  }
  return kNotMade;
}

Status find_or_make_material(arcspan_scene& scene, const MaterialSource& source, const KeepingParts& parts,
                             std::uint16_t& index) {
  index = find_material(scene, source, parts);
  if (index != kNotMade) return Status::kOk;
  std::uint16_t i = scene.material_count;
  if (i == scene.limits.materials) {  // one that is not kept; only now, because is_kept() looks at all parts
    i = 0;
    while (i < scene.limits.materials && is_kept(scene, i, parts)) ++i;
  }
  if (i == scene.limits.materials) return Status::kBufferTooSmall;
  if (i == scene.material_count) ++scene.material_count;
  scene.materials[i].source = source;
  index = i;
  return make_material(scene.materials[i], scene.light_list());
}

bool is_same(const MaterialSource& a, const MaterialSource& b) {
  return is_same(a.material, b.material) && a.texture.texels.data() == b.texture.texels.data() &&
         a.method == b.method && a.opacity == b.opacity &&
#if ARCSPAN_C_TOON
         a.toon_steps == b.toon_steps &&
#endif
         a.tolerance == b.tolerance && a.options.two_sided == b.options.two_sided;
}

}  // namespace arcspan::c
