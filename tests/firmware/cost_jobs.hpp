// SPDX-License-Identifier: MIT
// The jobs that tests/artefacts/drawing_jobs.cpp has written and the emulator has loaded into memory: what
// `arcspan simulate` estimates.
#pragma once

#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>

#include <tests/firmware/cost_method.hpp>
#include <tests/firmware/job_layout.hpp>

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
  const ClipTransform* transform = nullptr;
};

/// Draws a job in its bands, each of which is a section. Clearing is not measured.
inline bool draw_cost_job(std::uint32_t number, const CostJob& job, const CostMethod::Lighting& lighting) {
  const auto width = static_cast<std::int32_t>(job.head.width);
  const auto height = static_cast<std::int32_t>(job.head.height);
  const auto rows = static_cast<std::int32_t>(job.head.band_rows);
  hal::Framebuffer<Rgb565> band(cost_colours, width, rows);
  DepthBuffer depth(cost_depths, width, rows);
  for (std::int32_t top = 0; top < height; top += rows) {
    band.move_to(top);
    depth.move_to(top);
    band.clear({0, 0, 0});
    depth.clear();
    arcspan_mark();
    const DrawResult drawn =
        draw_mesh<CostMethod>(job.mesh, *job.transform, lighting, band, depth, cost_cache);
    arcspan_mark();
    bare::print_line("section: job ", number);
    bare::print_line("section: between");
    if (!ok(drawn.status)) return false;
  }
  return true;
}

inline bool cost_jobs_loaded() { return JobReader(arcspan_jobs).take<JobHead>(1)[0].vertices != 0; }

/// Draws the jobs whose highlight is that of the program.
inline bool draw_cost_jobs() {
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
    job.transform = &reader.take<ClipTransform>(1)[0];
    const Material& material = reader.take<Material>(1)[0];
    const DirectionalLight& towards = reader.take<DirectionalLight>(1)[0];
    const Direction& to_eye = reader.take<Direction>(1)[0];
    if ((job.head.is_phong != 0) != (CostLight::model() == Highlight::kPhong)) continue;
    if (job.head.vertices > kMostCostVertices || !ok(MeshView::make(positions, normals, indices, job.mesh)) ||
        (!planes.empty() && !ok(job.mesh.attach(planes, scale)))) {
      return false;
    }
    static CostLight light;  // larger than the stack that programs are allowed
    if (!ok(CostLight::make(material, {towards}, to_eye, light))) return false;
    if (!draw_cost_job(number, job, make_cost_lighting(light))) return false;
  }
}

}  // namespace arcspan
