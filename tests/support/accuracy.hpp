// SPDX-License-Identifier: MIT
#pragma once

#include <tests/support/probe.hpp>

#include <cstdint>

namespace arcspan::test {

/// Largest and mean square error over many pixels.
struct ErrorFigure {
  double max = 0;
  double sum_of_squares = 0;
  std::uint64_t count = 0;

  void add(double error);
  void add(const ErrorFigure& other);
  [[nodiscard]] double rms() const;
};

/// What was measured over random triangles whose normals are up to some angle apart.
struct AccuracyFigures {
  std::uint64_t triangles = 0;
  std::uint64_t pixels = 0;
  ErrorFigure normal_light;  ///< N·L
  ErrorFigure normal_half;   ///< N·H
  ErrorFigure normal_eye;    ///< N·V
  /// Colour channels in 8-bit steps, against the unrounded truth.
  ErrorFigure matt;
  ErrorFigure blinn;
  ErrorFigure phong;
  /// The same against the truth rounded to 8 bits: whole steps.
  int matt_steps = 0;
  int blinn_steps = 0;
  int phong_steps = 0;
  std::uint64_t missing_pixels = 0;  ///< samples that did not come with their run

  void add(const AccuracyFigures& other);
};

struct AccuracyTask {
  double from_degrees = 0;  ///< the widest angle between two of a triangle's normals lies in from ... to
  double to_degrees = 0;
  double smallest = 0.3;  ///< sizes in pixels, uniform in their logarithm
  double largest = 64;
  int triangles = 0;
  std::uint64_t seed = 1;
  int shininess = 64;  ///< of the materials, at most
  /// kSharpest: the figures of both models are valid. Otherwise those of the model that is named.
  Probe::Limits limits = Probe::Limits::kSharpest;
};

/// Draws random triangles through triangle preparation and the span stage, and compares every pixel with the
/// oracle. Large triangles are looked at through a random window of the picture.
[[nodiscard]] AccuracyFigures measure_accuracy(const AccuracyTask& task);

}  // namespace arcspan::test
