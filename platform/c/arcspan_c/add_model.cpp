// SPDX-License-Identifier: MIT
#include <arcspan_c/model.hpp>
#include <arcspan_c/new_object.hpp>

#include <cstddef>

using namespace arcspan;

namespace {

/// Whether the method of a material is compiled, for the layout of its texture.
template <class... Chosen>
[[nodiscard]] bool is_compiled(c::ChoiceList<Chosen...>, const SceneMaterial& material) {
  return ((material.use() == &detail::kUseFacts<typename detail::UseOf<typename Chosen::Method>::Type>) ||
          ...);
}

}  // namespace

arcspan_status arcspan_add_model(arcspan_scene* scene, const arcspan_model* model, arcspan_object* object) {
  c::NewObject added(*scene);
  Status status = Status::kOk;
  for (std::size_t i = 0; i < model->count && ok(status); ++i) {
    const c::ModelPart& part = model->parts[i];
    if (!is_compiled(c::AllChoices{}, *part.material)) status = Status::kUnsupported;
    MeshView mesh;
    if (ok(status)) status = part.make_view(mesh);
    MeshNeighbours neighbours;
    if (ok(status) && ARCSPAN_C_OUTLINES != 0 && part.make_neighbours != nullptr)
      status = part.make_neighbours(mesh, neighbours);
    if (ok(status)) status = added.add(mesh, &neighbours, *part.material, part.sphere);
  }
  return added.finish(status, object);
}
