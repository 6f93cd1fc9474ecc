// SPDX-License-Identifier: MIT
#include <arcspan_tools/compare/comparison.hpp>
#include <arcspan_tools/counting/count_operations.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <chrono>
#include <limits>

namespace arcspan::tools {
namespace {

using arcspan_counting::CountedDraw;

constexpr int kFewestRuns = 5;
constexpr std::chrono::milliseconds kMeasuringTime{150};

OperationRates rates(const arcspan_counting::OperationCounts& counts, std::uint64_t pixels) {
  OperationRates result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = pixels == 0 ? 0 : static_cast<double>(counts.of[i]) / static_cast<double>(pixels);
  }
  return result;
}

void rate_operations(const MeasuredMethod& method, const RenderJob& job, const FixedMeshes& meshes,
                     MethodFigures& figures) {
  RenderJob all_pixels = job;
  all_pixels.depth = false;  // otherwise hidden pixels would count as cheap ones
  const CountedDraw draw = count_operations(*method.count, all_pixels, meshes);
  const CountedDraw loop = count_operations("flat", all_pixels, meshes);
  figures.per_pixel = rates(draw.in_spans, draw.pixels);
  const OperationRates bare = rates(loop.in_spans, loop.pixels);
  for (std::size_t i = 0; i < bare.size(); ++i) {
    figures.per_pixel[i] = std::max(0.0, figures.per_pixel[i] - bare[i]);
  }
  for (const double rate : rates(draw.around, draw.pixels)) figures.around += rate;
}

double best_nanoseconds(const RenderJob& job, RenderFunction& render) {
  const RenderStats counted = render(job, {"rgb565"}, [](std::size_t) {}).stats;
  if (counted.pixels == 0) return 0;
  return best_draw_milliseconds(job, render) * 1e6 / static_cast<double>(counted.pixels);
}

}  // namespace

double best_draw_milliseconds(const RenderJob& job, RenderFunction& render) {
  using std::chrono::steady_clock;
  const auto end = steady_clock::now() + kMeasuringTime;
  RenderJob timed = job;
  timed.counts = false;
  double best = std::numeric_limits<double>::infinity();
  for (int run = 0; run < kFewestRuns || steady_clock::now() < end; ++run) {
    best = std::min(best, render(timed, {"rgb565"}, [](std::size_t) {}).stats.draw_milliseconds);
  }
  return best;
}

MeasuredMethod find_method(const std::string& shading) {
  arcspan_counting::CountFunction* const count = find_counter(shading);
  return {shading, find_renderer(shading, "rgb888", false).function, count};
}

MethodFigures measure_method(const std::string& shading, const RenderJob& job, const FixedMeshes& meshes,
                             const ReferencePicture& reference) {
  return measure_method(find_method(shading), job, meshes, reference);
}

MethodFigures measure_method(const MeasuredMethod& method, const RenderJob& job, const FixedMeshes& meshes,
                             const ReferencePicture& reference, Timing timing) {
  MethodFigures figures;
  figures.shading = method.shading;
  // The error in full 8-bit channels, the time in the format that a firmware would have.
  figures.picture = method.render(job, {"rgb888"}, [](std::size_t) {}).image;
  figures.error = picture_error(figures.picture, reference, job.background);
  rate_operations(method, job, meshes, figures);
  if (timing == Timing::kMeasured) figures.nanoseconds = best_nanoseconds(job, *method.render);
  return figures;
}

TexturedScene textured_scene(const RenderJob& job, ReferenceKind kind) {
  RenderJob unlit = job;
  constexpr Coefficient kOne = Coefficient::of(1.0);
  for (RenderPart& part : unlit.parts) part.material = {{kOne, kOne, kOne}, {}, {}, 1, {}};
  const Image texels = find_renderer("flat", "rgb888", false).render(unlit, [](std::size_t) {}).image;
  return {job, with_texels(draw_reference(job, kind), texels)};
}

std::optional<PictureError> textured_error(const std::string& shading, const TexturedScene& scene) {
  if (!shading_draws_effects(shading)) return std::nullopt;
  const Image picture = find_renderer(shading, "rgb888", false).render(scene.job, [](std::size_t) {}).image;
  return picture_error(picture, scene.reference, scene.job.background);
}

}  // namespace arcspan::tools
