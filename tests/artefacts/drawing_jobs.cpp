// SPDX-License-Identifier: MIT
// drawing_jobs OUTPUT METHOD...: reads lines of jobs from standard input,
//
//     MESH WIDTH HEIGHT VIEW_X VIEW_Y blinn|phong SHININESS BAND_ROWS plain|planes
//
// writes them for tests/firmware/cost_jobs.hpp, and prints for each of them, as JSON, the methods' terms of
// the estimate that `arcspan simulate` makes, and the estimate itself if the method has one.
#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/render/scene.hpp>
#include <arcspan_tools/simulate/processor_cost.hpp>
#include <nlohmann/json.hpp>
#include <tests/firmware/job_layout.hpp>

#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace arcspan;
using namespace arcspan::tools;

namespace {

struct Line {
  std::string mesh;
  Size size;
  double view_x = 0;
  double view_y = 0;
  std::string highlight;
  std::int32_t shininess = 0;
  std::int32_t band_rows = 0;
  std::string planes;
};

Line parse(const std::string& text) {
  std::istringstream in(text);
  Line line;
  if (!(in >> line.mesh >> line.size.width >> line.size.height >> line.view_x >> line.view_y >>
        line.highlight >> line.shininess >> line.band_rows >> line.planes)) {
    throw std::runtime_error("not a job: " + text);
  }
  return line;
}

FixedModel load(const Line& line) {
  FixedModel model = to_fixed(
      load_model_file(line.mesh, TexturePointsOf::kTexturedParts, VertexColours::kMean, kSmoothEverything));
  if (model.meshes.size() != 1) throw std::runtime_error(line.mesh + " has several parts");
  if (line.planes == "planes") model.meshes[0] = with_planes(std::move(model.meshes[0]), line.mesh);
  return model;
}

Scene scene_of(const Line& line) {
  Scene scene;
  scene.size = line.size;
  scene.camera.view = {line.view_x, line.view_y, 1};
  scene.highlight = line.highlight == "phong" ? Highlight::kPhong : Highlight::kBlinn;
  scene.surface.shininess = line.shininess;
  scene.chosen.shininess = true;
  scene.band_rows = line.band_rows;
  return scene;
}

template <class T>
void write(std::ostream& out, std::span<const T> values) {
  constexpr char kZeros[8] = {};
  out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size_bytes()));
  out.write(kZeros, static_cast<std::streamsize>(padded(values.size_bytes()) - values.size_bytes()));
}
template <class T>
void write_one(std::ostream& out, const T& value) {
  write(out, std::span<const T>(&value, 1));
}

void write_job(std::ostream& out, const RenderJob& job, const FixedMesh& mesh) {
  JobHead head;
  head.vertices = static_cast<std::uint32_t>(mesh.positions.size());
  head.indices = static_cast<std::uint32_t>(mesh.indices.size());
  head.planes = static_cast<std::uint32_t>(mesh.planes.size());
  head.is_phong = job.highlight == Highlight::kPhong;
  head.width = static_cast<std::uint32_t>(job.transform.viewport().width);
  head.height = static_cast<std::uint32_t>(job.transform.viewport().height);
  head.band_rows = static_cast<std::uint32_t>(job.band_rows);
  write_one(out, head);
  write(out, std::span(std::as_const(mesh.positions)));
  write(out, std::span(std::as_const(mesh.normals)));
  write(out, std::span(std::as_const(mesh.indices)));
  write(out, std::span(std::as_const(mesh.planes)));
  write_one(out, mesh.plane_scale);
  write_one(out, job.transform);
  write_one(out, job.parts[0].material);
  write_one(out, job.lights.front());
  write_one(out, job.to_eye);
}

nlohmann::json figures(const RenderJob& job, const FixedModel& model, const std::string& method) {
  const RenderStats stats = find_renderer(method, "rgb565", false).render(job, [](std::size_t) {}).stats;
  const std::vector<CostTerm> terms = cost_terms(method, job, model, stats);
  nlohmann::json result;
  for (const CostTerm& term : terms) result["terms"][term.name] = term.amount;
  if (const auto estimate = weighted_sum(method, job.highlight, terms)) result["estimate"] = *estimate;
  return result;
}

}  // namespace

int main(int count, char** arguments) try {
  if (count < 3) throw std::runtime_error("usage: drawing_jobs OUTPUT METHOD...");
  std::ofstream out(arguments[1], std::ios::binary);
  nlohmann::json jobs = nlohmann::json::array();
  for (std::string text; std::getline(std::cin, text);) {
    const Line line = parse(text);
    const FixedModel model = load(line);
    const RenderJob job = make_job(scene_of(line), model, line.mesh);
    write_job(out, job, model.meshes[0]);
    nlohmann::json of_methods;
    for (int i = 2; i < count; ++i) of_methods[arguments[i]] = figures(job, model, arguments[i]);
    jobs.push_back(std::move(of_methods));
  }
  write_one(out, JobHead{});
  if (!out.flush()) throw std::runtime_error(std::string(arguments[1]) + ": cannot write");
  std::cout << jobs << '\n';
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "drawing_jobs: %s\n", error.what());
  return 1;
}
