// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// The curves of the papers' figures, computed from definitions, not from the papers' results. Angles in
/// radians.
namespace arcspan::tools {

/// S3: a segment whose end normals are `angle` apart, with the light (or H) in the middle between them; the
/// intensity, cos^n, is exact at the ends and linear inside. Its error in the middle, relative to the
/// reference.
[[nodiscard]] double segment_error(double angle, double n);

/// The widest angle at which segment_error() is at most `error`.
[[nodiscard]] double widest_segment(double error, double n);

/// p(z) ~ 1/sqrt(2 + z), z = 2 cos(angle): how far apart two normals are tells which.
using Polynomial = double (*)(double z);
[[nodiscard]] double s3_linear(double z);
[[nodiscard]] double s3_quadratic(double z);
[[nodiscard]] double minimax_linear(double z);
[[nodiscard]] double minimax_quadratic(double z);
/// In s = 2 - z, exact at s = 0: what dichotomy.hpp computes with.
[[nodiscard]] double flat_linear(double z);
[[nodiscard]] double flat_quadratic(double z);
[[nodiscard]] double flat_cubic(double z);

/// p / (1/sqrt(2 + z)) - 1.
[[nodiscard]] double polynomial_error(Polynomial p, double angle);
/// The largest |polynomial_error|, and the largest |p - 1/sqrt(2 + z)|, over 0 ... `widest`.
[[nodiscard]] double worst_relative(Polynomial p, double widest);
[[nodiscard]] double worst_absolute(Polynomial p, double widest);
/// What is missing of (or added to) unit length after `levels` halvings from `angle`, z by the same
/// polynomial.
[[nodiscard]] double length_after_halvings(Polynomial p, double angle, int levels);

/// Largest error of x(t) = cos(start + t angle / pixels), t = 0 ... pixels, over many starts and over span
/// angles of 10, 30, 60 and 90 degrees:
/// by S0 eq. 14 as printed, x(t+1) = 2 cos(phi) x(t) - x(t-1), with all numbers in `fraction` bits after the
/// point, rounded;
[[nodiscard]] double printed_recurrence_error(int pixels, int fraction);
/// by the pipeline's ArcScalar (difference form, 16 x 16 bit products, 32-bit state).
[[nodiscard]] double difference_recurrence_error(int pixels);

/// S0 eq. 9 to 11 for a scalar x(t) = cos(start + t phi): x(t + ahead) from x(t) and x(t - 1), as printed and
/// as they ought to be (`ahead` 2, 3, 4).
[[nodiscard]] double printed_ahead(int ahead, double start, double phi);
[[nodiscard]] double corrected_ahead(int ahead, double start, double phi);

}  // namespace arcspan::tools
