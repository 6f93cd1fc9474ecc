// SPDX-License-Identifier: MIT
#include <arcspan/lighting/colour_coefficients.hpp>
#include <arcspan/mesh/mesh_binary.hpp>
#include <arcspan/model/model_binary.hpp>

#include <arcspan_c/binary_part.hpp>
#include <arcspan_c/new_object.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

using namespace arcspan;

namespace {

constexpr Material kWhitePlastic = plastic({255, 255, 255});

[[nodiscard]] Status add_mesh(c::NewObject& object, std::span<const std::uint8_t> binary,
                              const arcspan_look& look) {
  MeshView mesh;
  const Status status = view_mesh_binary(binary, mesh);
  if (!ok(status)) return status;
  return object.add(mesh, nullptr, c::source_of(look, kWhitePlastic, false, {}), bounding_sphere(mesh));
}

[[nodiscard]] Status add_parts(c::NewObject& object, const StoredModel& model, const arcspan_look& look) {
  for (std::size_t i = 0; i < model.part_count(); ++i) {
    const ModelPart part = model.part(i);
    MeshNeighbours neighbours;
    Status status = c::find_neighbours(model, i, neighbours);
    if (ok(status)) {
      status = object.add(part.mesh, &neighbours,
                          c::source_of(look, part.material, part.two_sided, part.texture), part.sphere);
    }
    if (!ok(status)) return status;
  }
  return Status::kOk;
}

}  // namespace

arcspan_status arcspan_add_binary(arcspan_scene* scene, const void* binary, size_t bytes,
                                  const arcspan_look* look, arcspan_object* object) {
  c::NewObject added(*scene);
  const arcspan_look& used = look != nullptr ? *look : c::kUsualLook;
  const std::span data(static_cast<const std::uint8_t*>(binary), bytes);
  if (ARCSPAN_C_TOON == 0 && used.toon_steps != 0) return ARCSPAN_UNSUPPORTED;
  if (binary == nullptr && bytes != 0) return ARCSPAN_INVALID_ARGUMENT;
  StoredModel model;
  Status status = view_model_binary(data, model);
  if (ok(status)) {
    status = add_parts(added, model, used);
  } else if (status == Status::kUnsupported) {  // another magic number
    status = add_mesh(added, data, used);
  }
  scene->make_materials = c::make_materials;
  return added.finish(status, object);
}
