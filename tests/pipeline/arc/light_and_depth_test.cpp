// SPDX-License-Identifier: MIT
// N·L and the depth in one register have the bits of both planes stepped apart.
#include <arcspan/shading/adaptive/light_and_depth.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <cstdint>

using namespace arcspan;
using namespace arcspan::test;

namespace {

struct NoLighting {};
using Walker = LightAndDepthWalker<NoLighting>;

constexpr std::int32_t kRows = 12;  ///< of each half of the triangle
constexpr std::int32_t kColumns = 24;

/// A value that is linear over the rows of a half; `skipped` columns may precede its first one.
struct Slopes {
  std::int32_t at;
  std::int32_t per_row;
  std::int32_t per_column;

  /// True if it stays in 32 bits in all rows, which start less than a pixel right of the edge.
  [[nodiscard]] bool stays_in_range(std::int32_t columns) const {
    for (const std::int64_t row : {0, kRows}) {
      for (const std::int64_t column : {0, columns + 1}) {
        const std::int64_t value = at + row * per_row + column * per_column;
        if (value != static_cast<std::int32_t>(value)) return false;
      }
    }
    return true;
  }
};

std::int32_t any(Random& random) { return random.integer(INT32_MIN, INT32_MAX); }

/// N·L along the edge of one half, as steep as its rows allow with this gradient along them.
Slopes light_with(Random& random, std::int32_t per_column, std::int32_t columns) {
  Slopes light{0, any(random), per_column};
  do {
    light.at = any(random);
    light.per_row /= 2;
  } while (!light.stays_in_range(columns));
  return light;
}

struct Planes {
  FullLinearPlane light;
  LinearPlane depth;
};

Planes random_planes(Random& random, std::int32_t columns) {
  // Over all rows N·L changes by less than a quarter of its range, so that light_with() ends.
  const std::int32_t per_column = random.chance(0.1) ? 0 : any(random) / (4 * (columns + 1));
  const Slopes upper = light_with(random, per_column, columns);
  const Slopes lower = light_with(random, per_column, columns);
  const auto light = [](std::int32_t raw) { return FullLinear::from_raw(raw); };
  const auto depth = [&random] { return Linear::from_raw(any(random) >> random.integer(0, 12)); };
  return {
      {{light(upper.at), light(upper.per_row)}, {light(lower.at), light(lower.per_row)}, light(per_column)},
      {{depth(), depth()}, {depth(), depth()}, depth()}};
}

struct Figures {
  int wrong = 0;
  int below_zero = 0;
};

void compare_row(const Planes& planes, const Walker& walker, const RowStart& start, std::int32_t columns,
                 Figures& figures) {
  Walker::Run run = walker.row(start);
  FullLinear light = linear_at(planes.light, start);
  Linear depth = linear_at(planes.depth, start);
  for (std::int32_t column = start.skipped; column < columns; ++column) {
    figures.wrong += run.normal_light().raw() == light.raw() && run.depth() == depth ? 0 : 1;
    figures.below_zero += light.raw() < 0 ? 1 : 0;
    run.next();
    light += planes.light.dx;
    depth += planes.depth.dx;
  }
}

/// Draws the rows of one half from the row `skipped` on.
void compare_half(Random& random, Planes& planes, Walker& walker, std::int32_t columns, Figures& figures) {
  const std::int32_t skipped = random.chance(0.5) ? random.integer(1, kRows - 1) : 0;
  if (skipped != 0) {
    planes.light.skip_rows(skipped);
    planes.depth.skip_rows(skipped);
    walker.skip_rows(skipped);
  }
  for (std::int32_t row = skipped; row < kRows; ++row) {
    const auto fraction = static_cast<std::uint32_t>(random.chance(0.2) ? 65535 * random.integer(0, 1)
                                                                        : random.integer(0, 65535));
    const std::int32_t first = random.chance(0.3) ? random.integer(1, columns - 1) : 0;
    compare_row(planes, walker, {fraction, first, 0, 0, 16, 0}, columns, figures);
    planes.light.next_row();
    planes.depth.next_row();
    walker.next_row();
  }
}

}  // namespace

TEST_CASE("N·L and the depth in one register have the bits of both stepped apart") {
  Random random(183);
  Figures figures;
  for (int i = 0; i < share_of(1500); ++i) {
    const std::int32_t columns = random.integer(2, kColumns);
    Planes planes = random_planes(random, columns);
    const bool middle_left = random.chance(0.7);
    Walker walker(planes.light, planes.depth, middle_left);
    compare_half(random, planes, walker, columns, figures);
    if (!middle_left) continue;
    planes.light.enter_lower(middle_left);
    planes.depth.enter_lower(middle_left);
    walker.enter_lower();
    compare_half(random, planes, walker, columns, figures);
  }
  CHECK(figures.wrong == 0);
  CHECK(figures.below_zero > share_of(1500));
}
