// SPDX-License-Identifier: MIT
// The papers' claims and misprints: each that is said to be wrong is shown to be, and what is right instead.
#include <arcspan_tools/plot/figure.hpp>
#include <arcspan_tools/plot/formulas.hpp>
#include <arcspan_tools/plot/gnuplot.hpp>
#include <arcspan_tools/plot/worked_example.hpp>
#include <catch2/catch.hpp>
#include <tests/artefacts/normal_operations.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace arcspan::tools;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

}  // namespace

TEST_CASE("S0 eq. 9 is right, eq. 10 and 11 are misprinted") {
  for (const double start : {0.0, 0.3, 1.9}) {
    for (const double degrees : {0.5, 5.0, 20.0}) {
      const double phi = degrees * kDegree;
      for (const int ahead : {2, 3, 4}) {
        const double reference = std::cos(start + ahead * phi);
        CAPTURE(start, degrees, ahead);
        CHECK(std::fabs(corrected_ahead(ahead, start, phi) - reference) < 1e-12);
        CHECK((std::fabs(printed_ahead(ahead, start, phi) - reference) < 1e-12) == (ahead == 2));
      }
    }
  }
  CHECK(std::cos(0.3 + 15 * kDegree) == Approx(0.846298).margin(5e-7));
  CHECK(printed_ahead(3, 0.3, 5 * kDegree) == Approx(-0.146009).margin(5e-7));
  CHECK(printed_ahead(4, 0.3, 5 * kDegree) == Approx(0.598599).margin(5e-7));
}

TEST_CASE("S3: 4 % at 4 degrees holds for n up to 66, not 100") {
  CHECK(segment_error(4 * kDegree, 100) == Approx(0.0591).margin(5e-5));
  CHECK(segment_error(4 * kDegree, 66) < 0.04);
  CHECK(segment_error(4 * kDegree, 67) > 0.04);
  CHECK(widest_segment(0.04, 100) / kDegree == Approx(3.27).margin(0.01));
  CHECK(segment_error(20 * kDegree, 1) < 1.0 / 64);
}

TEST_CASE("S3's polynomials are rounded further than their stated errors") {
  constexpr double k45 = 45 * kDegree;
  CHECK(worst_absolute(&s3_linear, k45) > 2 * 5e-4);
  CHECK(worst_absolute(&s3_quadratic, k45) > 40 * 2e-5);
  // With digits enough they are as good as S3 says, or nearly.
  CHECK(worst_absolute(&minimax_linear, k45) < 6.2e-4);
  CHECK(worst_absolute(&minimax_quadratic, k45) < 2.1e-5);
  CHECK(worst_relative(&flat_quadratic, k45) < 4.8e-5);
  CHECK(worst_relative(&flat_cubic, k45) < 1.7e-6);
  // Those in 2 - z leave flat spans alone.
  CHECK(worst_relative(&flat_linear, k45) < 1.6e-3);
  CHECK(flat_linear(2) == 0.5);
  CHECK(flat_quadratic(2) == 0.5);
  CHECK(flat_cubic(2) == 0.5);
  CHECK(std::fabs(s3_quadratic(2) - 0.5) > 5e-4);
}

TEST_CASE("after five halvings from 45 degrees, the worst of all nodes") {
  constexpr double k45 = 45 * kDegree;
  CHECK(length_error_after_halvings(&s3_linear, k45, 5) == Approx(1.6e-3).epsilon(0.02));
  CHECK(length_error_after_halvings(&s3_quadratic, k45, 5) == Approx(4.7e-3).epsilon(0.02));
  CHECK(length_error_after_halvings(&flat_linear, k45, 5) == Approx(1.58e-3).epsilon(0.02));
  CHECK(length_error_after_halvings(&flat_quadratic, k45, 5) == Approx(6.5e-5).epsilon(0.02));
  CHECK(length_error_after_halvings(&flat_cubic, k45, 5) == Approx(1.55e-6).epsilon(0.02));
  CHECK(length_error_after_halvings([](double z) { return 1 / std::sqrt(2 + z); }, k45, 5) < 1e-14);
}

TEST_CASE("S3, figure 2: its absolute error is a bound, which no light reaches") {
  for (const double degrees : {1.0, 10.0, 45.0, 90.0}) {
    const double angle = degrees * kDegree;
    double worst = 0;
    const double farthest = 90 * kDegree - angle / 2;  // the whole segment is lit
    for (int light = -400; light <= 400; ++light) {
      const double at = light / 400.0 * farthest;  // of the light, from the middle
      const auto lit = [at](double normal) { return std::cos(normal - at); };
      worst = std::max(worst, std::fabs(lit(0) - (lit(-angle / 2) + lit(angle / 2)) / 2));
    }
    CAPTURE(degrees);
    CHECK(worst == Approx(segment_error(angle, 1)).margin(1e-12));
    CHECK(s3_absolute_error(angle) == Approx(1 / std::cos(angle / 2) - 1).margin(1e-12));
    CHECK(s3_absolute_error(angle) > worst);
  }
}

TEST_CASE("the recurrence as printed is lost in 16-bit words, the difference form is not") {
  const int spans = arcspan::test::share_of(kRandomSpans);
  CHECK(printed_recurrence_error(64, 14, 100) > 0.01);
  CHECK(printed_recurrence_error(256, 14, 100) > 0.5);
  CHECK(printed_recurrence_error(256, 30, 100) < 1e-4);
  for (const int pixels : {8, 64, 256}) {
    CAPTURE(pixels);
    CHECK(difference_recurrence_error(pixels, spans) < 7e-5);
  }
  // Beyond the 256 pixels after which the pipeline starts again. Few spans show it: 96 regular ones
  // have 5.5e-5.
  const double long_span = difference_recurrence_error(1024, spans);
  CHECK(long_span > 2e-4);
  CHECK(long_span < 5e-4);
}

TEST_CASE("a pixel's normal takes the long operations that S0 counts") {
  using arcspan_counting::Operation;
  using arcspan_counting::OperationCounts;
  const OperationCounts classic = arcspan_counting::classic_normal_operations();
  CHECK(classic[Operation::kDivide] == 3);
  CHECK(classic[Operation::kRoot] == 1);
  CHECK(classic[Operation::kMultiply] == 3 + 1);  // one rounds the root
  CHECK(classic[Operation::kAdd] >= 5);
  const OperationCounts reciprocal = arcspan_counting::reciprocal_normal_operations();
  CHECK(reciprocal[Operation::kDivide] == 0);
  CHECK(reciprocal[Operation::kRoot] == 1);
  CHECK(reciprocal[Operation::kMultiply] == 3 + 3);
  CHECK(arcspan_counting::four_steps_operations()[Operation::kMultiply] == 4 + 3);
  CHECK(arcspan_counting::four_steps_operations()[Operation::kDivide] == 0);
  const OperationCounts recurrence = arcspan_counting::recurrence_operations();
  CHECK(recurrence[Operation::kMultiply] == 1);
  CHECK(recurrence[Operation::kDivide] + recurrence[Operation::kRoot] + recurrence[Operation::kLookUp] == 0);
  const OperationCounts lyon = arcspan_counting::lyon_operations();
  CHECK(lyon[Operation::kDivide] + lyon[Operation::kRoot] == 0);
  const OperationCounts duff = arcspan_counting::duff_operations();
  CHECK(duff[Operation::kRoot] == 1);
  CHECK(duff[Operation::kMultiply] + 3 == classic[Operation::kMultiply]);
  CHECK(arcspan_counting::slerp_normal_operations()[Operation::kDivide] == 0);
  CHECK(arcspan_counting::slerp_normal_operations()[Operation::kLookUp] == 4);
}

TEST_CASE("S1's worked example, exactly") {
  const WorkedExample example = worked_example();
  CHECK(example.flat == Approx(3.859864).margin(1e-6));
  CHECK(example.vertices[0] == Approx(4.203998).margin(1e-6));
  CHECK(example.vertices[1] == Approx(4.550902).margin(1e-6));
  CHECK(example.vertices[2] == Approx(4.477745).margin(1e-6));
  CHECK(example.gouraud == Approx(4.470548).margin(1e-6));
  CHECK(example.phong_not_normalised == Approx(4.469560).margin(1e-6));
  CHECK(example.phong == Approx(4.488482).margin(1e-6));
  CHECK(example.arc == Approx(4.488443).margin(1e-6));
  CHECK(example.gouraud_as_defined == Approx(4.4212).margin(5e-5));
  CHECK(example.phong_as_defined == Approx(4.4407).margin(5e-5));
}

TEST_CASE("every figure has curves with points, axes, and a script that names them") {
  for (const FigureMaker& maker : figure_makers()) {
    const std::string name(maker.name);
    CAPTURE(name);
    const Figure figure = maker.make();
    CHECK_FALSE(figure.x_label.empty());
    CHECK_FALSE(figure.y_label.empty());
    REQUIRE_FALSE(figure.curves.empty());
    const std::string script = gnuplot_script(figure, PlotFormat::kSvg, "a\"b");
    CHECK(script.find("set output \"a\\\"b\"") != std::string::npos);
    for (const Curve& curve : figure.curves) {
      CHECK_FALSE(curve.points.empty());
      CHECK(script.find(curve.label) != std::string::npos);
      for (const auto& [x, y] : curve.points) CHECK((std::isfinite(x) && std::isfinite(y)));
    }
    const std::string csv = to_csv(figure);
    CHECK(csv.rfind("curve,x,y\n\"" + figure.curves[0].label + "\",", 0) == 0);
  }
}
