// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/compare/metrics.hpp>
#include <arcspan_tools/counting/count_job.hpp>
#include <arcspan_tools/fixed_point/fixed_mesh.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace arcspan::tools {

/// Operations per pixel, by arcspan_counting::Operation.
using OperationRates = std::array<double, arcspan_counting::kOperationKinds>;

/// Error, cost and picture of one shading method on one job.
struct MethodFigures {
  std::string shading;
  Image picture;
  PictureError error;
  std::optional<PictureError> textured;  ///< error with the model's textures, if it has some
  /// Of the pixels alone; what the span loop itself counts (that is, flat shading) is taken off.
  OperationRates per_pixel{};
  /// All kinds together, spent on vertices, preparation and row starts, per pixel.
  double around = 0;
  double nanoseconds = 0;              ///< per pixel, whole draw, best of several; 0 if it was not measured
  std::optional<double> instructions;  ///< per pixel, whole draw, if they could be counted
};

/// A method as it is measured: the pipeline with it, and the pipeline that counts with it.
struct MeasuredMethod {
  std::string shading;
  RenderFunction* render;
  arcspan_counting::CountFunction* count;
};
/// One of those that the commands offer; throws Failure if there is none of that name.
[[nodiscard]] MeasuredMethod find_method(const std::string& shading);

/// Whether the time of drawing is measured too: the one figure that is another one in every run.
enum class Timing : std::uint8_t { kMeasured, kLeftOut };

/// Draws with one method and compares with the reference; counts operations; measures the time. Not
/// instructions.
[[nodiscard]] MethodFigures measure_method(const MeasuredMethod& method, const RenderJob& job,
                                           const FixedMeshes& meshes, const ReferencePicture& reference,
                                           Timing timing = Timing::kMeasured);
[[nodiscard]] MethodFigures measure_method(const std::string& shading, const RenderJob& job,
                                           const FixedMeshes& meshes, const ReferencePicture& reference);

/// A job with textures, and its reference.
struct TexturedScene {
  RenderJob job;
  ReferencePicture reference;
};
/// The scene of a job whose parts have textures.
[[nodiscard]] TexturedScene textured_scene(const RenderJob& job, ReferenceKind kind);
/// The error of a method's picture of it; nothing if the method draws no textures.
[[nodiscard]] std::optional<PictureError> textured_error(const std::string& shading,
                                                         const TexturedScene& scene);

/// Processor time of drawing a job into rgb565, in milliseconds: the best of several runs.
[[nodiscard]] double best_draw_milliseconds(const RenderJob& job, RenderFunction& render);

/// Nanoseconds and instructions per pixel that others are compared with.
struct Yardstick {
  std::string shading;
  double nanoseconds = 0;
  std::optional<double> instructions;
};

struct Comparison {
  std::string mesh_name;
  std::size_t mesh_triangles = 0;
  std::int32_t width = 0;
  std::int32_t height = 0;
  ReferenceKind reference_kind = ReferenceKind::kPhong;
  Image reference;
  std::vector<MethodFigures> methods;
  std::vector<Yardstick> yardsticks;  ///< gouraud, phong and phong-reciprocal, those that there are
};

}  // namespace arcspan::tools
