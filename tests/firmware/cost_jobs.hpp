// SPDX-License-Identifier: MIT
// The jobs that tests/artefacts/drawing_jobs.cpp has written and the emulator has loaded into memory: what
// `arcspan simulate` estimates.
#pragma once

#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/mesh/mesh_neighbours.hpp>
#include <arcspan/texture/texture.hpp>

#include <tests/firmware/cost_method.hpp>
#include <tests/firmware/job_layout.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

/// Where the emulator loads the jobs; CMakeLists.txt gives the address. The memory is zero otherwise.
extern "C" const std::byte arcspan_jobs[];

namespace arcspan {

/// Reads the arrays of a job, one after the other.
class JobReader {
 public:
  explicit JobReader(const std::byte* at) : at_(at) {}
  template <class T>
  std::span<const T> take(std::size_t count) {
    const auto* first = static_cast<const T*>(static_cast<const void*>(at_));
    at_ += padded(count * sizeof(T));
    return {first, count};
  }

 private:
  const std::byte* at_;
};

struct CostJob {
  JobHead head;
  MeshView mesh;
  MeshNeighbours neighbours;
  ClipTransform transform;
};

[[gnu::section(".bss.frame")]] static TriangleRows cost_rows[TriangleRows::entries(20000)];

/// Draws a job in its bands, each of which is a section. Clearing is not measured. Vertices are kept, and in
/// bands the rows of triangles.
inline bool draw_cost_job(std::uint32_t number, const CostJob& job, const CostMethod::Lighting& lighting) {
  const auto width = static_cast<std::int32_t>(job.head.width);
  const auto height = static_cast<std::int32_t>(job.head.height);
  const auto rows = static_cast<std::int32_t>(job.head.band_rows);
  hal::Framebuffer<Rgb565> band(cost_colours, width, rows);
  DepthBuffer depth(cost_depths, width, rows);
  VertexCache<CostMethod> cache(cost_cache, rows < height ? std::span(cost_rows) : std::span<TriangleRows>());
  for (std::int32_t top = 0; top < height; top += rows) {
    band.move_to(top);
    depth.move_to(top);
    band.clear({0, 0, 0});
    depth.clear();
    arcspan_mark();
    const DrawResult drawn = draw_mesh<CostMethod>(job.mesh, job.transform, lighting, band, depth, cache,
                                                   {job.head.two_sided != 0});
    arcspan_mark();
    bare::print_line("section: job ", number);
    bare::print_line("section: between");
    if (!ok(drawn.status)) return false;
  }
  return true;
}

[[gnu::section(".bss.frame")]] alignas(2) static std::uint8_t cost_texels[2 * 21845];

/// Makes a texture of the memory of the texels, whatever their bits. Colour 0 is transparent if there is
/// alpha.
template <class Texels>
Status make_cost_texture(const TextureSize& size, Texture<Texels>& texture) {
  using Word = typename Texels::Word;
  static constexpr std::array<std::uint16_t, 256> kPalette{0, 0xFFFF};
  const auto* const words = static_cast<const Word*>(static_cast<const void*>(cost_texels));
  return Texture<Texels>::make(std::span(words, sizeof cost_texels / sizeof(Word)), size, texture,
                               std::span(kPalette).first(Texels::kPaletteSize));
}

/// Gives the lighting of a textured method the texture of JobHead::texture, with at most 128x128 texels.
template <class Lighting>
Status set_cost_texture([[maybe_unused]] Lighting& lighting, [[maybe_unused]] std::uint32_t texture) {
  if constexpr (requires { lighting.texture; }) {
    for (std::size_t i = 0; i < std::size(cost_texels); ++i)
      cost_texels[i] = is_opaque_texel(i, texture >> 24);
    const auto bits = static_cast<std::uint8_t>(texture);
    return make_cost_texture({bits, bits, static_cast<std::uint8_t>(texture >> 8)}, lighting.texture);
  } else {
    return Status::kOk;
  }
}

inline bool cost_jobs_loaded() { return JobReader(arcspan_jobs).take<JobHead>(1)[0].vertices != 0; }

/// Calls draw(number, job, lighting) for the jobs whose highlight is that of the program, until it returns
/// false.
template <class Draw>
inline bool draw_cost_jobs(const Draw& draw) {
  JobReader reader(arcspan_jobs);
  for (std::uint32_t number = 0;; ++number) {
    CostJob job;
    job.head = reader.take<JobHead>(1)[0];
    if (job.head.vertices == 0) return true;
    const auto positions = reader.take<ObjectPosition>(job.head.vertices);
    const auto normals = reader.take<PackedNormal>(job.head.vertices);
    const auto indices = reader.take<std::uint16_t>(job.head.indices);
    const auto planes = reader.take<FacePlane>(job.head.planes);
    const PlaneScale& scale = reader.take<PlaneScale>(1)[0];
    const Placement& placement = reader.take<Placement>(1)[0];
    const Projection& projection = reader.take<Projection>(1)[0];
    const Material& material = reader.take<Material>(1)[0];
    const DirectionalLight& towards = reader.take<DirectionalLight>(1)[0];
    const Direction& to_eye = reader.take<Direction>(1)[0];
    const auto points = reader.take<TexturePoint>(job.head.texture == 0 ? 0 : job.head.vertices);
    const auto neighbours = reader.take<std::uint8_t>(job.head.neighbours);
    if ((job.head.is_phong != 0) != (CostLight::kModel == Highlight::kPhong)) continue;
    const Viewport size{static_cast<std::int32_t>(job.head.width),
                        static_cast<std::int32_t>(job.head.height)};
    if (!ok(ClipTransform::make(placement, projection, size, job.transform))) return false;
    if (job.head.vertices > kMostCostVertices || !ok(MeshView::make(positions, normals, indices, job.mesh)) ||
        (!planes.empty() && !ok(job.mesh.attach(planes, scale)))) {
      return false;
    }
    if (!points.empty() &&
        !ok(job.mesh.attach(points, TextureScale{static_cast<std::uint8_t>(job.head.texture >> 16)})))
      return false;
    if (!neighbours.empty() && !ok(MeshNeighbours::make(job.mesh, neighbours, job.neighbours))) return false;
    static CostLight light;  // larger than the stack that programs are allowed
    if (!ok(CostLight::make(material, {towards}, to_eye, light))) return false;
    const CostMethod::Lighting& lighting = make_cost_lighting(light);
    if (!ok(set_cost_texture(cost_lighting_memory.lighting, job.head.texture)) ||
        !draw(number, job, lighting))
      return false;
  }
}

}  // namespace arcspan
