// SPDX-License-Identifier: MIT
#include <arcspan_tools/support/parse.hpp>
#include <arcspan_tools/support/progress.hpp>
#include <catch2/catch.hpp>

#include <cmath>

using namespace arcspan::tools;

TEST_CASE("numbers are taken whole or not at all") {
  CHECK(parse_number("-1.5e2") == -150.0);
  CHECK(parse_number("+2.") == 2.0);
  CHECK(parse_number(".5") == 0.5);
  CHECK(std::isnan(parse_number("nan").value()));
  for (const char* wrong : {"", "+", "-", "+-1", "1 ", " 1", "1,5", "0x10", "one"}) {
    CAPTURE(wrong);
    CHECK_FALSE(parse_number(wrong).has_value());
  }
  CHECK(parse_number("-1e999") == -INFINITY);
  CHECK(parse_number("1e-999") == 0.0);
  CHECK(parse_integer("-7") == -7);
  CHECK_FALSE(parse_integer("7.0").has_value());
  CHECK_FALSE(parse_integer("99999999999999999999").has_value());
}

TEST_CASE("triples are three finite numbers") {
  CHECK(parse_triple("1,-2,0.5") == Vec3{1, -2, 0.5});
  for (const char* wrong : {"", "1", "1,2", "1,2,", "1,2,3,4", "1,2,x", "1,nan,2", "inf,1,2", "1, 2,3"}) {
    CAPTURE(wrong);
    CHECK_FALSE(parse_triple(wrong).has_value());
  }
}

TEST_CASE("sizes are two positive integers") {
  CHECK(parse_size("320x240") == Size{320, 240});
  for (const char* wrong : {"", "320", "320x", "x240", "0x240", "320x-1", "1e3x4", "320X240", "9999999x1"}) {
    CAPTURE(wrong);
    CHECK_FALSE(parse_size(wrong).has_value());
  }
}

TEST_CASE("the progress bar fills from empty to full") {
  CHECK(progress_bar(0, 8, 4) == "[....]   0 %");
  CHECK(progress_bar(2, 8, 4) == "[#...]  25 %");
  CHECK(progress_bar(8, 8, 4) == "[####] 100 %");
  CHECK(progress_bar(9, 8, 4) == "[####] 100 %");
}
