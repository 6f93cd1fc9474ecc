// SPDX-License-Identifier: MIT
#include <arcspan_tools/counting/count_operations.hpp>
#include <arcspan_tools/counting/counters.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <span>
#include <string>
#include <vector>

namespace arcspan::tools {
namespace {

using arcspan_counting::CountedDraw;

template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& values) {
  return std::as_bytes(std::span(values));
}
template <class T>
std::span<const std::byte> bytes_of_one(const T& value) {
  return std::as_bytes(std::span(&value, 1));
}

void add(CountedDraw& sum, const CountedDraw& draw) {
  for (std::size_t i = 0; i < draw.in_spans.of.size(); ++i) {
    sum.in_spans.of[i] += draw.in_spans.of[i];
    sum.around.of[i] += draw.around.of[i];
  }
  sum.pixels += draw.pixels;
  sum.spans += draw.spans;
  sum.triangles += draw.triangles;
}

}  // namespace

arcspan_counting::CountFunction* find_counter(std::string_view shading) {
  for (const arcspan_counting::Counter& counter : arcspan_counting::counters()) {
    if (counter.shading == shading) return counter.function;
  }
  throw Failure(std::string(shading), "no such shading to count");
}

CountedDraw count_operations(std::string_view shading, const RenderJob& job, const FixedMeshes& meshes) {
  return count_operations(*find_counter(shading), job, meshes);
}

CountedDraw count_operations(arcspan_counting::CountFunction& count, const RenderJob& job,
                             const FixedMeshes& meshes) {
  // Counted with plain illuminations only, because each instantiation takes seconds to compile. A single
  // light's colour is part of the material.
  std::vector<DirectionalLight> lights = job.lights;
  if (lights.size() > 1) {
    for (DirectionalLight& light : lights) light.colour = DirectionalLight{}.colour;
  }
  CountedDraw sum;
  for (std::size_t i = 0; i < job.parts.size(); ++i) {
    Material material = job.parts[i].material;
    material.highlight_fade = {};
    arcspan_counting::CountJob bytes;
    bytes.positions = bytes_of(meshes[i].positions);
    bytes.normals = bytes_of(meshes[i].normals);
    bytes.indices = bytes_of(meshes[i].indices);
    bytes.planes = bytes_of(meshes[i].planes);
    bytes.plane_scale = bytes_of_one(meshes[i].plane_scale);
    bytes.transform = bytes_of_one(job.transform);
    bytes.material = bytes_of_one(material);
    bytes.lights = bytes_of(lights);
    bytes.to_eye = bytes_of_one(job.to_eye);
    bytes.phong_highlight = job.highlight == Highlight::kPhong;
    bytes.two_sided = job.parts[i].two_sided;
    bytes.depth = job.depth;
    bytes.segment_bits = job.segment_bits;
    bytes.tolerance = job.tolerance;
    bytes.band_rows = job.band_rows;
    add(sum, count(bytes));
  }
  return sum;
}

}  // namespace arcspan::tools
