// SPDX-License-Identifier: MIT
#include <arcspan_tools/plot/figure_list.hpp>
#include <arcspan_tools/plot/formulas.hpp>
#include <arcspan_tools/support/vec3.hpp>

#include <cmath>

namespace arcspan::tools {
namespace {

constexpr int kPoints = 360;
constexpr int kSpansOfFigure = 200;  // of each point; more are for the claims

Curve segment_curve(double widest_degrees, double n) {
  Curve curve;
  curve.label = "n = " + std::to_string(static_cast<int>(n));
  for (int i = 1; i <= kPoints; ++i) {
    const double degrees = widest_degrees * i / kPoints;
    curve.points.emplace_back(degrees, 100 * segment_error(degrees * kDegree, n));
  }
  return curve;
}

Curve polynomial_curve(const char* label, Polynomial p) {
  Curve curve;
  curve.label = label;
  for (int i = 0; i <= kPoints; ++i) {
    const double degrees = 90.0 * i / kPoints;
    // Exact values (error 0) cannot be shown on a logarithmic axis.
    curve.points.emplace_back(degrees, std::max(std::fabs(polynomial_error(p, degrees * kDegree)), 1e-8));
  }
  return curve;
}

template <class Error>
Curve growth_curve(const char* label, const Error& error) {
  Curve curve;
  curve.label = label;
  for (int pixels = 4; pixels <= 2048; pixels *= 2) curve.points.emplace_back(pixels, error(pixels));
  return curve;
}

}  // namespace

Figure diffuse_error_figure() {
  Figure figure;
  figure.title = "Segment with linear intensity: error in its middle, diffuse";
  figure.x_label = "angle between the normals at its ends, degrees";
  figure.y_label = "error, % of the exact intensity";
  figure.curves = {segment_curve(90, 1)};
  figure.curves[0].label = "1 - cos(angle/2)";
  return figure;
}

Figure absolute_error_figure() {
  Figure figure;
  figure.title = "Segment with linear intensity: absolute error in its middle, diffuse";
  figure.x_label = "angle between the normals at its ends, degrees";
  figure.y_label = "error, % of the light's full intensity";
  Curve bound;
  bound.label = "S3's formula, both ends fully lit";
  Curve reached = segment_curve(90, 1);
  reached.label = "largest that occurs where all is lit";
  for (const auto& [degrees, error] : reached.points) {
    bound.points.emplace_back(degrees, 100 * s3_absolute_error(degrees * kDegree));
  }
  figure.curves = {bound, reached};
  return figure;
}

Figure specular_error_figure() {
  Figure figure;
  figure.title = "Segment with linear intensity: error in its middle, highlight (N·H)^n";
  figure.x_label = "angle between the normals at its ends, degrees";
  figure.y_label = "error, % of the exact intensity";
  for (const double n : {4.0, 16.0, 64.0, 100.0, 128.0, 256.0}) {
    figure.curves.push_back(segment_curve(10, n));
  }
  figure.curves.push_back({"S3: 4 % at 4° for n = 100", {{4, 4}}, true});
  return figure;
}

Figure polynomial_figure() {
  Figure figure;
  figure.title = "Dichotomy: polynomials for 1/sqrt(2 + z), z = 2 cos(angle)";
  figure.x_label = "angle between the normals, degrees";
  figure.y_label = "relative error";
  figure.logarithmic_y = true;
  figure.curves = {polynomial_curve("S3, linear, as printed", &s3_linear),
                   polynomial_curve("S3, quadratic, as printed", &s3_quadratic),
                   polynomial_curve("minimax to 45°, linear", &minimax_linear),
                   polynomial_curve("minimax to 45°, quadratic", &minimax_quadratic),
                   polynomial_curve("in 2 - z, linear", &flat_linear),
                   polynomial_curve("in 2 - z, quadratic", &flat_quadratic),
                   polynomial_curve("in 2 - z, cubic", &flat_cubic)};
  return figure;
}

Figure recurrence_figure() {
  Figure figure;
  figure.title = "The recurrence: largest error of N·L over a span";
  figure.x_label = "pixels of the span";
  figure.y_label = "largest error";
  figure.logarithmic_x = true;
  figure.logarithmic_y = true;
  struct WordLength {
    const char* label;
    int fraction;
  };
  for (const WordLength& words :
       {WordLength{"as printed, 12-bit words", 10}, WordLength{"as printed, 16-bit words", 14},
        WordLength{"as printed, 24-bit words", 22}, WordLength{"as printed, 32-bit words", 30}}) {
    figure.curves.push_back(growth_curve(words.label, [&words](int pixels) {
      return printed_recurrence_error(pixels, words.fraction, kSpansOfFigure);
    }));
  }
  figure.curves.push_back(growth_curve("differences, 16x16 multiply, 32-bit state", [](int pixels) {
    return difference_recurrence_error(pixels, kSpansOfFigure);
  }));
  return figure;
}

}  // namespace arcspan::tools
