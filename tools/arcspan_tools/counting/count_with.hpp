// SPDX-License-Identifier: MIT
// Only for counted_method.cpp.in, after the pipeline's files have been compiled as arcspan_counted.
#pragma once

#include <arcspan_tools/counting/count_job.hpp>

#include <cstring>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace arcspan_counting {

namespace counted = arcspan_counted;

/// Takes colours and keeps none; while a run is open its operations are counted apart.
class NoteSink {
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

  NoteSink(CountedDraw& draw, const counted::Viewport& size) : draw_(&draw) {
    bounds_.right = size.width;
    bounds_.bottom = size.height;
  }

  [[nodiscard]] counted::Rect bounds() const { return bounds_; }
  [[nodiscard]] Format::Cursor open(const counted::Span& run) {
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
  counted::Rect bounds_{};
};

/// Values of one pipeline as those of the other.
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
    throw std::logic_error("the counting pipeline refuses the mesh");
  }
  CountedDraw draw;
  NoteSink sink(draw, transform.viewport());
  std::vector<counted::CachedVertex<Method>> cache(mesh.vertex_count());
  operation_target = &draw.around;
  (void)counted::draw_mesh<Method>(mesh, transform, lighting, sink, counted::NoDepth{}, std::span(cache),
                                   {job.two_sided});
  operation_target = nullptr;
  return draw;
}

template <template <class> class Method, std::size_t Lights, counted::Highlight Model>
CountedDraw count_lit(const CountJob& job) {
  using Lit = counted::Illumination<Lights, Model>;
  const auto given = copied<counted::DirectionalLight>(job.lights);
  arcspan_counted_std::array<counted::DirectionalLight, Lights> lights;
  for (std::size_t i = 0; i < Lights; ++i) lights[i] = given[i];
  Lit lighting;
  const auto material = one<counted::Material>(job.material);
  const auto to_eye = one<counted::Direction>(job.to_eye);
  if (Lit::make(material, lights, to_eye, lighting) != counted::Status::kOk) {
    throw std::logic_error("the counting pipeline refuses the material");
  }
  typename Method<Lit>::Lighting lit(lighting);
  counted::Status set = counted::Status::kOk;
  if constexpr (requires { lit.set_segment_bits(1); }) set = lit.set_segment_bits(job.segment_bits);
  if constexpr (requires { lit.set_tolerance(1); }) set = lit.set_tolerance(job.tolerance);
  if (set != counted::Status::kOk) throw std::logic_error("the counting pipeline refuses the settings");
  return count_draw<Method<Lit>>(job, lit);
}

template <template <class> class Method, counted::Highlight Model>
CountedDraw count_model(const CountJob& job) {
  switch (job.lights.size() / sizeof(counted::DirectionalLight)) {
    case 1:
      return count_lit<Method, 1, Model>(job);
    case 2:
      return count_lit<Method, 2, Model>(job);
    case 3:
      return count_lit<Method, 3, Model>(job);
    case 4:
      return count_lit<Method, 4, Model>(job);
    default:
      throw std::logic_error("1 to 4 lights");
  }
}

template <template <class> class Method>
CountedDraw count_with(const CountJob& job) {
  return job.phong_highlight ? count_model<Method, counted::Highlight::kPhong>(job)
                             : count_model<Method, counted::Highlight::kBlinn>(job);
}

}  // namespace arcspan_counting
