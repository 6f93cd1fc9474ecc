// SPDX-License-Identifier: MIT
#include <arcspan/scene/scene_memory.hpp>
#include <arcspan/scene/scene_pass.hpp>

#include <arcspan_c/model.hpp>
#include <arcspan_c/new_object.hpp>

#include <cstddef>

using namespace arcspan;

arcspan_status arcspan_add_model(arcspan_scene* scene, const arcspan_model* model, arcspan_object* object) {
  using Compiled = SceneMemoryView<c::CompiledMethods>::UseList;
  c::NewObject added(*scene);
  Status status = Status::kOk;
  for (std::size_t i = 0; i < model->count && ok(status); ++i) {
    const c::ModelPart& part = model->parts[i];
    if (!detail::is_for(Compiled{}, *part.material)) status = Status::kUnsupported;
    MeshView mesh;
    if (ok(status)) status = part.make_view(mesh);
    MeshNeighbours neighbours;
    if (ok(status) && ARCSPAN_C_OUTLINES != 0 && part.make_neighbours != nullptr)
      status = part.make_neighbours(mesh, neighbours);
    if (ok(status)) status = added.add(mesh, &neighbours, *part.material, part.sphere);
  }
  return added.finish(status, object);
}
