// SPDX-License-Identifier: MIT
// Only for inclusion after end_counted.hpp: it needs the pipeline as arcspan_counted.
#pragma once

#include <arcspan_tools/counting/count_job.hpp>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace arcspan_counting {

namespace counted = arcspan_counted;

/// Takes colours and keeps none. Operations while a run is open are counted separately from the others.
class CountingSink {
 public:
  struct Format {
    using Encoded = counted::PackedRgb;
    using Word = Encoded;
    static constexpr unsigned kBitsPerPixel = 32;
    static constexpr bool kDithers = false;

    class Cursor {
     public:
      Cursor(Encoded*, Counted<std::int32_t>) {}
      void write(Encoded) {}
      [[nodiscard]] Encoded read() const { return {}; }
      void next() {}
    };

    [[nodiscard]] static std::size_t words_per_row(Counted<std::int32_t>) { return 1; }
    [[nodiscard]] static Encoded encode(counted::PackedRgb c) { return c; }
    [[nodiscard]] static Encoded encode(counted::Rgb8) { return {}; }
    [[nodiscard]] static Encoded encode_dithered(counted::Rgb8, Counted<std::int32_t>,
                                                 Counted<std::int32_t>) {
      return {};
    }
    [[nodiscard]] static counted::Rgb8 decode(Encoded) { return {}; }
  };

  /// The band that `depth` covers. Unless `tests_depth`, the depths under a run are reset when it is opened,
  /// so that all its pixels pass.
  CountingSink(CountedDraw& draw, const counted::DepthBuffer& depth, bool tests_depth)
      : draw_(&draw), depth_(&depth), tests_depth_(tests_depth) {}

  [[nodiscard]] counted::Rect bounds() const { return depth_->bounds(); }
  [[nodiscard]] Format::Cursor open(const counted::Span& run) {
    operation_target = nullptr;
    if (!tests_depth_) {
      std::fill_n(depth_->row(run.y) + run.x, static_cast<int>(run.count), counted::DepthBuffer::kFarthest);
    }
    ++draw_->spans;
    draw_->pixels += static_cast<std::uint64_t>(run.count);
    operation_target = &draw_->in_spans;
    return {nullptr, run.x};
  }
  [[nodiscard]] counted::Status close(const counted::Span&) {
    operation_target = &draw_->around;
    return counted::Status::kOk;
  }

 private:
  CountedDraw* draw_;
  const counted::DepthBuffer* depth_;
  bool tests_depth_;
};

/// Values of the plain pipeline as values of the pipeline that counts.
template <class T>
std::vector<T> copied(std::span<const std::byte> bytes) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (bytes.size() % sizeof(T) != 0) throw std::logic_error("the counting pipeline's types differ in size");
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!bytes.empty()) std::memcpy(static_cast<void*>(values.data()), bytes.data(), bytes.size());
  return values;
}
template <class T>
T one(std::span<const std::byte> bytes) {
  const std::vector<T> values = copied<T>(bytes);
  if (values.size() != 1) throw std::logic_error("the counting pipeline's types differ in size");
  return values[0];
}

template <class Method>
CountedDraw count_draw(const CountJob& job, const typename Method::Lighting& lighting) {
  const auto positions = copied<counted::ObjectPosition>(job.positions);
  const auto normals = copied<counted::PackedNormal>(job.normals);
  const auto indices = copied<Counted<std::uint16_t>>(job.indices);
  const auto transform = one<counted::ClipTransform>(job.transform);
  counted::MeshView mesh;
  if (counted::MeshView::make(positions, normals, std::span(indices), mesh) != counted::Status::kOk) {
    throw std::logic_error("the counting pipeline rejects the mesh");
  }
  const auto planes = copied<counted::FacePlane>(job.planes);
  if (!planes.empty() &&
      mesh.attach(planes, one<counted::PlaneScale>(job.plane_scale)) != counted::Status::kOk) {
    throw std::logic_error("the counting pipeline rejects the planes");
  }
  CountedDraw draw;
  const int width = static_cast<int>(transform.viewport().width);
  const int height = static_cast<int>(transform.viewport().height);
  for (int first = 0; first < height; first += job.band_rows) {
    const int rows = std::min(job.band_rows, height - first);
    std::vector<Counted<std::uint16_t>> depths(counted::DepthBuffer::words(width, rows));
    counted::DepthBuffer depth(depths, width, rows, first);
    depth.clear();
    CountingSink sink(draw, depth, job.depth);
    std::vector<counted::CachedVertex<Method>> cache(mesh.vertex_count());
    operation_target = &draw.around;
    const counted::DrawResult drawn =
        counted::draw_mesh<Method>(mesh, transform, lighting, sink, depth, std::span(cache), {job.two_sided});
    operation_target = nullptr;
    draw.triangles += static_cast<std::uint64_t>(drawn.triangles);
  }
  return draw;
}

template <template <class> class Method, std::size_t Lights, counted::Highlight Model>
CountedDraw count_lit(const CountJob& job) {
  using Lit = counted::Illumination<Lights, Model>;
  const auto given = copied<counted::DirectionalLight>(job.lights);
  // Missing lights are added as dark ones, which saves instantiations; they are counted.
  arcspan_counted_std::array<counted::DirectionalLight, Lights> lights;
  for (std::size_t i = 0; i < Lights; ++i) {
    lights[i] = i < given.size() ? given[i] : counted::DirectionalLight{given[0].towards, {}};
  }
  Lit lighting;
  const auto material = one<counted::Material>(job.material);
  const auto to_eye = one<counted::Direction>(job.to_eye);
  if (Lit::make(material, lights, to_eye, lighting) != counted::Status::kOk) {
    throw std::logic_error("the counting pipeline rejects the material");
  }
  typename Method<Lit>::Lighting lit(lighting);
  counted::Status set = counted::Status::kOk;
  if constexpr (requires { lit.set_segment_bits(1); }) {
    if (job.segment_bits < 0) set = lit.set_adaptive_segments(material.shininess);
    if (job.segment_bits > 0) set = lit.set_segment_bits(job.segment_bits);
  }
  if constexpr (requires { lit.set_tolerance(1); }) set = lit.set_tolerance(job.tolerance);
  if (set != counted::Status::kOk) throw std::logic_error("the counting pipeline rejects the settings");
  return count_draw<Method<Lit>>(job, lit);
}

template <template <class> class Method, counted::Highlight Model>
CountedDraw count_model(const CountJob& job) {
  constexpr std::size_t kMost = 4;
  const std::size_t lights = job.lights.size() / sizeof(counted::DirectionalLight);
  if (lights < 1 || lights > kMost) throw std::logic_error("1 to 4 lights");
  return lights == 1 ? count_lit<Method, 1, Model>(job) : count_lit<Method, kMost, Model>(job);
}

template <template <class> class Method>
CountedDraw count_with(const CountJob& job) {
  return job.phong_highlight ? count_model<Method, counted::Highlight::kPhong>(job)
                             : count_model<Method, counted::Highlight::kBlinn>(job);
}

}  // namespace arcspan_counting
