// SPDX-License-Identifier: MIT
// Draws models by one method, each in a section "draw NAME", for scripts/firmware-costs. The emulator loads
// them into memory: scripts/lib/cost_models.py writes the records.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/mesh/mesh_binary.hpp>

#include <tests/firmware/cost_method.hpp>
#include <tests/firmware/cost_record.hpp>

namespace arcspan {
namespace {

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
  for (const ModelRecord* model = &first_record(); model->bytes != 0; model = &next_record(*model)) {
    if (!draw_model(*model, binary_of(*model))) return false;
  }
  return true;
}

}  // namespace
}  // namespace arcspan

int main() { return arcspan::draw_models() ? 0 : 1; }
