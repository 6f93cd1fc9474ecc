// SPDX-License-Identifier: MIT
#include <arcspan/literature/recurrence.hpp>

#include <arcspan_tools/plot/formulas.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace arcspan::tools {
namespace {

constexpr double kPi = std::numbers::pi;

/// The largest f(start, angle) of random spans.
template <class F>
double worst_over_spans(int spans, const F& f) {
  std::mt19937_64 random(1);  // its numbers are the same everywhere, those of distributions are not
  const auto up_to = [&random](double limit) {
    return limit * std::ldexp(static_cast<double>(random() >> 11), -53);
  };
  double worst = 0;
  for (int i = 0; i < spans; ++i) {
    const double start = up_to(2 * kPi);
    worst = std::max(worst, f(start, up_to(kPi / 2)));
  }
  return worst;
}

double printed_error(double start, double angle, int pixels, int fraction) {
  const double phi = angle / pixels;
  const auto fixed = [fraction](double v) {
    return static_cast<std::int64_t>(std::llround(std::ldexp(v, fraction)));
  };
  const std::int64_t twice_cosine = fixed(2 * std::cos(phi));
  std::int64_t before = fixed(std::cos(start - phi));
  std::int64_t x = fixed(std::cos(start));
  double worst = 0;
  for (int t = 0; t <= pixels; ++t) {
    const double error = std::ldexp(static_cast<double>(x), -fraction) - std::cos(start + t * phi);
    worst = std::max(worst, std::fabs(error));
    const std::int64_t product = (twice_cosine * x + (std::int64_t{1} << (fraction - 1))) >> fraction;
    const std::int64_t next = product - before;
    before = x;
    x = next;
  }
  return worst;
}

double difference_error(double start, double angle, int pixels) {
  const double phi = angle / pixels;
  const auto unit = [](double v) {
    return Cosine::from_raw(static_cast<std::int32_t>(std::lround(std::ldexp(v, Cosine::kFraction))));
  };
  // k = mantissa 2^-(16 + shift), with 15 bits of mantissa.
  const double k = 2 - 2 * std::cos(phi);
  int shift = 0;
  while (shift < 31 && std::ldexp(k, 16 + shift + 1) < 32768) ++shift;
  const auto mantissa = static_cast<std::int32_t>(std::lround(std::ldexp(k, 16 + shift)));
  RecurrenceScalar scalar{unit(std::cos(start)), unit(std::cos(start + phi) - std::cos(start))};
  double worst = 0;
  for (int t = 0; t <= pixels; ++t) {
    const double x = std::ldexp(scalar.x.raw(), -Cosine::kFraction);
    worst = std::max(worst, std::fabs(x - std::cos(start + t * phi)));
    scalar.step(std::min(mantissa, 32767), std::max(shift, 1));
  }
  return worst;
}

double exact(double z) { return 1 / std::sqrt(2 + z); }

template <class F>
double worst_over_angles(double widest, const F& f) {
  constexpr int kSteps = 4000;
  double worst = 0;
  for (int i = 0; i <= kSteps; ++i) worst = std::max(worst, std::fabs(f(widest * i / kSteps)));
  return worst;
}

}  // namespace

double segment_error(double angle, double n) {
  // The middle's intensity is 1.
  return 1 - std::pow(std::cos(angle / 2), n);
}

double widest_segment(double error, double n) { return 2 * std::acos(std::pow(1 - error, 1 / n)); }

double s3_linear(double z) { return 0.64 - 0.07 * z; }
double s3_quadratic(double z) { return 0.681 - 0.119 * z + 0.014 * z * z; }
double minimax_linear(double z) { return 0.640040939 - 0.0703261419 * z; }
double minimax_quadratic(double z) { return 0.680849766 - 0.118921801 * z + 0.0142534991 * z * z; }
double flat_linear(double z) { return 0.5 + 0.0688625867 * (2 - z); }
double flat_quadratic(double z) {
  const double s = 2 - z;
  return 0.5 + s * (0.0620584825 + 0.0140394938 * s);
}
double flat_cubic(double z) {
  const double s = 2 - z;
  return 0.5 + s * (0.0625262157 + s * (0.0114552316 + 0.0031711712 * s));
}

double polynomial_error(Polynomial p, double angle) {
  const double z = 2 * std::cos(angle);
  return p(z) / exact(z) - 1;
}

double worst_relative(Polynomial p, double widest) {
  return worst_over_angles(widest, [p](double angle) { return polynomial_error(p, angle); });
}

double worst_absolute(Polynomial p, double widest) {
  return worst_over_angles(widest, [p](double angle) {
    const double z = 2 * std::cos(angle);
    return p(z) - exact(z);
  });
}

double length_error_after_halvings(Polynomial p, double angle, int levels) {
  // All nodes of one level have the same z, but their lengths differ: halves are made from halves.
  struct Normal {
    double x;
    double y;
  };
  std::vector<Normal> nodes{{1, 0}, {std::cos(angle), std::sin(angle)}};
  double z = 2 * std::cos(angle);
  for (int level = 0; level < levels; ++level) {
    const double factor = p(z);
    std::vector<Normal> halved;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      halved.push_back(nodes[i]);
      halved.push_back({(nodes[i].x + nodes[i + 1].x) * factor, (nodes[i].y + nodes[i + 1].y) * factor});
    }
    halved.push_back(nodes.back());
    nodes = std::move(halved);
    z = (2 + z) * factor;  // sqrt(2 + z): twice the cosine of half the angle
  }
  double worst = 0;
  for (const Normal& node : nodes) worst = std::max(worst, std::fabs(std::hypot(node.x, node.y) - 1));
  return worst;
}

double s3_absolute_error(double angle) { return 2 * (1 / std::sqrt(2 * (1 + std::cos(angle))) - 0.5); }

double printed_recurrence_error(int pixels, int fraction, int spans) {
  return worst_over_spans(
      spans, [=](double start, double angle) { return printed_error(start, angle, pixels, fraction); });
}

double difference_recurrence_error(int pixels, int spans) {
  return worst_over_spans(spans,
                          [=](double start, double angle) { return difference_error(start, angle, pixels); });
}

double printed_ahead(int ahead, double start, double phi) {
  const double now = std::cos(start);
  const double before = std::cos(start - phi);
  const double c = std::cos(phi);
  const double c2 = std::cos(2 * phi);
  switch (ahead) {
    case 2:
      return now * (2 * c2 + 1) - 2 * before * c;
    case 3:
      return c2 * (4 * now * c - before) - 3 * before;
    default:
      return 2 * now * c2 * (2 * c2 + 3) - 2 * before * c * (c2 + 4) + now;
  }
}

double corrected_ahead(int ahead, double start, double phi) {
  const double now = std::cos(start);
  const double before = std::cos(start - phi);
  const double c = std::cos(phi);
  const double c2 = std::cos(2 * phi);
  switch (ahead) {
    case 2:
      return now * (2 * c2 + 1) - 2 * before * c;
    case 3:
      return c2 * (4 * c * now - 2 * before) - before;
    default:
      return 2 * c2 * (2 * c2 + 1) * now - 4 * c * c2 * before - now;
  }
}

}  // namespace arcspan::tools
