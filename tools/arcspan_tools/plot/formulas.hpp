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
/// The largest error of a normal's length among all nodes after `levels` halvings of an arc of `angle`, with
/// the z of each level by the same polynomial.
[[nodiscard]] double length_error_after_halvings(Polynomial p, double angle, int levels);

/// S3's formula for the largest absolute error in a segment's middle, (I_l + I_p) (1/sqrt(2 (1 + cos(angle)))
/// - 1/2), for I_l = I_p = 1 (its figure 2). It is a bound: a light in the middle between the normals gives
/// ends of cos(angle/2), and the error is segment_error(angle, 1), relative and absolute.
[[nodiscard]] double s3_absolute_error(double angle);

/// Spans that the errors of recurrences are tried on, if nothing else is asked for.
inline constexpr int kRandomSpans = 20'000;

/// Largest error of x(t) = cos(start + t angle / pixels), t = 0 ... pixels, over `spans` random spans, always
/// the same: starts of 0 ... 360 degrees, span angles up to 90 degrees; by S0 eq. 14 as printed, x(t+1) = 2
/// cos(phi) x(t) - x(t-1), with all numbers in `fraction` bits after the point, rounded;
[[nodiscard]] double printed_recurrence_error(int pixels, int fraction, int spans = kRandomSpans);
/// by the pipeline's RecurrenceScalar (difference form, 16 x 16 bit products, 32-bit state).
[[nodiscard]] double difference_recurrence_error(int pixels, int spans = kRandomSpans);

/// S0 eq. 9 to 11 for a scalar x(t) = cos(start + t phi): x(t + ahead) from x(t) and x(t - 1), as printed and
/// as they ought to be (`ahead` 2, 3, 4).
[[nodiscard]] double printed_ahead(int ahead, double start, double phi);
[[nodiscard]] double corrected_ahead(int ahead, double start, double phi);

}  // namespace arcspan::tools
