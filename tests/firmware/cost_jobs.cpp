// SPDX-License-Identifier: MIT
// Draws the jobs that tests/artefacts/drawing_jobs.cpp has written and the emulator has loaded into memory,
// each as a section for instruction_count.py: what `arcspan simulate` estimates. The program has one call of
// draw_mesh(), for the method and the highlight that CMakeLists.txt defines; jobs with the other highlight
// are skipped.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <tests/firmware/job_layout.hpp>

#include <cstddef>
#include <new>
#include <span>

#include ARCSPAN_METHOD_HEADER

using namespace arcspan;

namespace {

constexpr std::int32_t kMostWidth = 320;
constexpr std::int32_t kMostHeight = 320;
constexpr std::size_t kMostVertices = 20000;

using Light = Illumination<1, ARCSPAN_HIGHLIGHT>;
using Method = ARCSPAN_METHOD<Light>;

[[gnu::section(".bss.frame")]] std::uint16_t colours[kMostWidth * kMostHeight];
[[gnu::section(".bss.frame")]] std::uint16_t depths[kMostWidth * kMostHeight];
[[gnu::section(".bss.frame")]] CachedVertex<Method> cache[kMostVertices];

union LightingMemory {
  Method::Lighting lighting;
  constexpr LightingMemory() {}
};
[[gnu::section(".bss.frame")]] LightingMemory lighting_memory;

/// Reads the arrays of a job, one after the other.
class Reader {
 public:
  explicit Reader(const std::byte* at) : at_(at) {}
  template <class T>
  std::span<const T> take(std::size_t count) {
    const auto* first = static_cast<const T*>(static_cast<const void*>(at_));
    at_ += padded(count * sizeof(T));
    return {first, count};
  }

 private:
  const std::byte* at_;
};

struct Job {
  JobHead head;
  MeshView mesh;
  const ClipTransform* transform = nullptr;
};

/// Draws a job in its bands. Clearing is not measured.
bool measure(std::uint32_t number, const Job& job) {
  const auto& lighting = lighting_memory.lighting;
  const auto height = static_cast<std::int32_t>(job.head.height);
  const auto rows = static_cast<std::int32_t>(job.head.band_rows);
  hal::Framebuffer<Rgb565> band(colours, static_cast<std::int32_t>(job.head.width), rows);
  DepthBuffer depth(depths, static_cast<std::int32_t>(job.head.width), rows);
  for (std::int32_t top = 0; top < height; top += rows) {
    band.move_to(top);
    depth.move_to(top);
    band.clear({0, 0, 0});
    depth.clear();
    arcspan_mark();
    const DrawResult drawn =
        draw_mesh<Method>(job.mesh, *job.transform, lighting, band, depth, std::span(cache));
    arcspan_mark();
    bare::print_line("section: job ", number);
    bare::print_line("section: between");
    if (!ok(drawn.status)) return false;
  }
  return true;
}

}  // namespace

int main() {
  Reader reader(reinterpret_cast<const std::byte*>(kJobsAddress));
  for (std::uint32_t number = 0;; ++number) {
    Job job;
    job.head = reader.take<JobHead>(1)[0];
    if (job.head.vertices == 0) return 0;
    const auto positions = reader.take<ObjectPosition>(job.head.vertices);
    const auto normals = reader.take<PackedNormal>(job.head.vertices);
    const auto indices = reader.take<std::uint16_t>(job.head.indices);
    const auto planes = reader.take<FacePlane>(job.head.planes);
    const PlaneScale& scale = reader.take<PlaneScale>(1)[0];
    job.transform = &reader.take<ClipTransform>(1)[0];
    const Material& material = reader.take<Material>(1)[0];
    const DirectionalLight& towards = reader.take<DirectionalLight>(1)[0];
    const Direction& to_eye = reader.take<Direction>(1)[0];
    if ((job.head.is_phong != 0) != (ARCSPAN_HIGHLIGHT == Highlight::kPhong)) continue;
    if (job.head.vertices > kMostVertices || !ok(MeshView::make(positions, normals, indices, job.mesh)) ||
        (!planes.empty() && !ok(job.mesh.attach(planes, scale)))) {
      return 1;
    }
    static Light light;  // larger than the stack that programs are allowed
    if (!ok(Light::make(material, {towards}, to_eye, light))) return 2;
    new (&lighting_memory.lighting) Method::Lighting(light);
    if (!measure(number, job)) return 3;
  }
}
