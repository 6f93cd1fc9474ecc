// SPDX-License-Identifier: MIT
// drawing_jobs OUTPUT METHOD...: reads lines of jobs from standard input,
//
//     MESH WIDTH HEIGHT VIEW_X VIEW_Y blinn|phong SHININESS BAND_ROWS plain|planes|split FOV BITS REPEATS
//     AXES OUTLINES EYE SPECULAR SIDES OPAQUE
//
// writes them for tests/firmware/cost_jobs.hpp, and prints for each of them, as JSON, the events that each
// method draws it by, and the estimate for a Cortex-M3. The method `outlines` has those of its outlines
// alone. FOV is the camera's angle. `split` meshes share few vertices. BITS are log2 of the texture's
// size, 3...7, or 0 for no texture; REPEATS times it is seen along the mesh; AXES, 0...3, are those of the
// mesh that it is mapped along, and 4 is added for one mip level. OUTLINES are `none`, or smoothed, and begin
// with the width of their ink or 0; `c` after it inks creases, `r` curves them. EYE is the
// distance of the camera from the mesh's middle, in its largest coordinate, or 0: the whole mesh is seen.
// SPECULAR is the red of highlights, which have half of it in green and none in blue, or -1: they are white.
// SIDES is 2 if backs are drawn, or 1. OPAQUE is how many of every 8 texels are opaque, or 0: all are.
#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/mesh/compile/neighbours.hpp>
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/render/scene.hpp>
#include <arcspan_tools/simulate/processor_cost.hpp>
#include <nlohmann/json.hpp>
#include <tests/firmware/job_layout.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <memory>
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
  double fov = 0;
  int bits = 0;
  double repeats = 0;
  int axes = 0;
  std::string outlines;
  double eye = 0;
  double specular = -1;
  int sides = 1;
  std::uint32_t opaque = 0;

  [[nodiscard]] bool has(char letter) const { return outlines.find(letter) != std::string::npos; }
  [[nodiscard]] std::uint8_t ink_width() const { return static_cast<std::uint8_t>(outlines[0] - '0'); }
};

Line parse(const std::string& text) {
  std::istringstream in(text);
  Line line;
  if (!(in >> line.mesh >> line.size.width >> line.size.height >> line.view_x >> line.view_y >>
        line.highlight >> line.shininess >> line.band_rows >> line.planes >> line.fov >> line.bits >>
        line.repeats >> line.axes >> line.outlines >> line.eye >> line.specular >> line.sides >>
        line.opaque)) {
    throw std::runtime_error("not a job: " + text);
  }
  return line;
}

/// Maps a grey texture along two axes of a mesh that fills 16 bits.
void add_texture(const Line& line, FixedModel& model) {
  const std::int32_t side = std::int32_t{1} << line.bits;
  auto texture = std::make_shared<FileTexture>();
  texture->picture = RgbaImage(side, side);
  model.looks[0].material.texture = texture;
  FixedMesh& mesh = model.meshes[0];
  mesh.texture_scale.fraction_bits = 11;
  const double scale = line.repeats * (1 << mesh.texture_scale.fraction_bits) / 65536;
  const auto point = [scale](std::int32_t along) {
    return static_cast<std::int16_t>(std::lround(scale * along));
  };
  mesh.texture_points.clear();
  for (const ObjectPosition& p : mesh.positions) {
    mesh.texture_points.push_back({point((line.axes & 1) != 0 ? p.x + p.z / 2 : p.x - p.y / 3),
                                   point((line.axes & 2) != 0 ? p.y - p.z / 2 : p.z + p.y / 4)});
  }
}

FixedModel load(const Line& line) {
  Model file = load_model_file(line.mesh, TexturePointsOf::kTexturedParts, VertexColours::kMean,
                               line.planes == "split" ? 0.0 : kSmoothEverything);
  file.has_curves = line.has('r');
  FixedModel model = to_fixed(file);
  if (model.meshes.size() != 1) throw std::runtime_error(line.mesh + " has several parts");
  if (line.planes == "planes") model.meshes[0] = with_planes(std::move(model.meshes[0]), line.mesh);
  if (line.bits != 0) add_texture(line, model);
  if (line.outlines != "none") model = with_neighbours(std::move(model), line.mesh);
  return model;
}

/// Leaves one level of the texture.
void drop_levels(RenderPart& part) {
  auto texture = std::make_shared<SurfaceTexture>(*part.texture);
  const TextureSize& size = part.texture->view.size();
  if (!ok(Texture<SurfaceTexels>::make(texture->texels, {size.width_bits, size.height_bits, 1},
                                       texture->view)))
    throw std::runtime_error("the texture has too few texels");
  part.texture = std::move(texture);
}

/// Makes all but `opaque` of every 8 texels transparent.
void mask_texels(std::uint32_t opaque, RenderPart& part) {
  auto texture = std::make_shared<SurfaceTexture>(*part.texture);
  for (std::size_t i = 0; i < texture->texels.size(); ++i) {
    if (!is_opaque_texel(i, opaque)) texture->texels[i] = 0;
  }
  const TextureSize size = part.texture->view.size();
  if (!ok(Texture<SurfaceTexels>::make(texture->texels, size, texture->view)))
    throw std::runtime_error("the texture has too few texels");
  part.texture = std::move(texture);
}

/// Where the camera stands that is so near that it sees a part of the mesh.
Vec3 near_eye(const Line& line, const FixedMesh& mesh) {
  std::int32_t most = 0;
  for (const ObjectPosition& p : mesh.positions)
    most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return mesh.centre + normalised({line.view_x, line.view_y, 1}) * (line.eye * most * mesh.unit);
}

Scene scene_of(const Line& line) {
  Scene scene;
  scene.size = line.size;
  scene.camera.view = {line.view_x, line.view_y, 1};
  scene.camera.fov_degrees = line.fov;
  scene.camera.fov_given = true;
  scene.highlight = line.highlight == "phong" ? Highlight::kPhong : Highlight::kBlinn;
  scene.surface.shininess = line.shininess;
  scene.chosen.shininess = true;
  scene.band_rows = line.band_rows;
  scene.two_sided = line.sides == 2;
  scene.chosen.specular = line.specular >= 0;
  if (line.specular >= 0) scene.surface.specular.rgb = {line.specular, line.specular / 2, 0};
  if (line.outlines == "none") return scene;
  scene.outlines.curved = line.has('r');
  if (line.ink_width() != 0) scene.outlines.ink = OutlineInk{{}, line.ink_width(), line.has('c')};
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

void write_job(std::ostream& out, const Line& line, const RenderJob& job, const FixedCamera& camera,
               const FixedMesh& mesh) {
  JobHead head;
  head.vertices = static_cast<std::uint32_t>(mesh.positions.size());
  head.indices = static_cast<std::uint32_t>(mesh.indices.size());
  head.planes = static_cast<std::uint32_t>(mesh.planes.size());
  head.is_phong = job.highlight == Highlight::kPhong;
  head.width = static_cast<std::uint32_t>(job.transform.viewport().width);
  head.height = static_cast<std::uint32_t>(job.transform.viewport().height);
  head.band_rows = static_cast<std::uint32_t>(job.band_rows);
  if (job.parts[0].texture != nullptr) {
    const TextureSize& size = job.parts[0].texture->view.size();
    head.texture = static_cast<std::uint32_t>(size.width_bits) |
                   static_cast<std::uint32_t>(size.levels) << 8 |
                   static_cast<std::uint32_t>(mesh.texture_scale.fraction_bits) << 16 | line.opaque << 24;
  }
  head.two_sided = job.parts[0].two_sided ? 1 : 0;
  head.neighbours = static_cast<std::uint32_t>(mesh.neighbours.size());
  if (job.outlines.ink) head.outlines = job.outlines.ink->width | (job.outlines.ink->creases ? 256u : 0u);
  if (job.outlines.curved) head.outlines |= 65536;
  write_one(out, head);
  write(out, std::span(std::as_const(mesh.positions)));
  write(out, std::span(std::as_const(mesh.normals)));
  write(out, std::span(std::as_const(mesh.indices)));
  write(out, std::span(std::as_const(mesh.planes)));
  write_one(out, mesh.plane_scale);
  write_one(out, camera.placement);
  write_one(out, camera.projection);
  write_one(out, job.parts[0].material);
  write_one(out, job.lights.front());
  write_one(out, job.to_eye);
  if (head.texture != 0) write(out, std::span(std::as_const(mesh.texture_points)));
  write(out, std::span(std::as_const(mesh.neighbours)));
}

nlohmann::json figures(const RenderJob& job, const std::string& method) {
  nlohmann::json result;
  auto picture = picture_events(method == kOutlineWeights ? "flat" : method, job);
  if (!picture) throw std::runtime_error(method + " has no events");
  if (method == kOutlineWeights) picture->erase(picture->begin(), picture->end() - 1);
  for (const CostTerm& term : picture->at(0).terms) result["terms"][term.name] = term.amount;
  if (const auto estimate = instructions_on(kSimulatedCore, *picture)) result["estimate"] = *estimate;
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
    Scene scene = scene_of(line);
    if (line.eye != 0) scene.camera.eye = near_eye(line, model.meshes[0]);
    RenderJob job = make_job(scene, model, line.mesh);
    if ((line.axes & 4) != 0) drop_levels(job.parts[0]);
    if (line.opaque != 0) mask_texels(line.opaque, job.parts[0]);
    const Camera camera = place_camera(scene.camera, model, scene.size);
    write_job(out, line, job, to_fixed(camera, model, scene.size), model.meshes[0]);
    nlohmann::json of_methods;
    for (int i = 2; i < count; ++i) of_methods[arguments[i]] = figures(job, arguments[i]);
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
