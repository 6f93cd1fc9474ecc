// SPDX-License-Identifier: MIT
// Draws models by one method, each in a section "draw NAME", for scripts/firmware-costs. The emulator loads
// them into memory: scripts/lib/cost_models.py writes the records.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/mesh/mesh_binary.hpp>

#include <tests/firmware/cost_method.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// A mesh binary, its camera and the size of the picture. A record of 0 bytes is the end.
struct ModelRecord {
  char name[24];  ///< ends with zeros
  std::uint32_t bytes;
  std::int32_t width;
  std::int32_t height;
  std::int32_t translation[3];  ///< ObjectLength
  std::int32_t focal;           ///< PixelLength
  std::int32_t near_plane;      ///< ObjectLength
  std::int32_t far_plane;       ///< ObjectLength
};

}  // namespace arcspan

/// Where the emulator loads the records, each followed by its binary, which is padded to a multiple of 4
/// bytes.
extern "C" const std::byte arcspan_models[];

namespace arcspan {
namespace {

/// Light and rotation are those of scenes::set_stage().
bool set_model_stage(const ModelRecord& model, scenes::StageSet& stage) {
  if (!ok(scenes::set_stage({model.width, model.height}, 1, {}, stage))) return false;
  Placement placement{scenes::stage_rotation({}), {}};
  for (std::size_t i = 0; i < 3; ++i) placement.translation[i] = ObjectLength::from_raw(model.translation[i]);
  const Projection projection{PixelLength::from_raw(model.focal), ObjectLength::from_raw(model.near_plane),
                              ObjectLength::from_raw(model.far_plane)};
  return ok(ClipTransform::make(placement, projection, {model.width, model.height}, stage.transform));
}

bool draw_model(const ModelRecord& model, std::span<const std::uint8_t> binary) {
  static scenes::StageSet stage;
  MeshView mesh;
  if (!ok(view_mesh_binary(binary, mesh)) || mesh.vertex_count() > kMostCostVertices) return false;
  if (!set_model_stage(model, stage)) return false;
  const auto& lighting = make_cost_lighting(stage.light);
  CostSink frame(cost_colours, model.width, model.height);
  DepthBuffer depth(cost_depths, model.width, model.height);
  frame.clear({0, 0, 0});
  depth.clear();
  arcspan_mark();
  const DrawResult drawn = draw_mesh<CostMethod>(mesh, stage.transform, lighting, frame, depth, cost_cache);
  arcspan_mark();
  bare::print_line("section: draw ", model.name);
  bare::print_line("section: between");
  return ok(drawn.status) && drawn.triangles != 0;
}

bool draw_models() {
  const std::byte* at = arcspan_models;
  for (;;) {
    const auto& model = *static_cast<const ModelRecord*>(static_cast<const void*>(at));
    if (model.bytes == 0) return true;
    at += sizeof(ModelRecord);
    if (!draw_model(model, {static_cast<const std::uint8_t*>(static_cast<const void*>(at)), model.bytes}))
      return false;
    at += model.bytes;
  }
}

}  // namespace
}  // namespace arcspan

int main() { return arcspan::draw_models() ? 0 : 1; }
