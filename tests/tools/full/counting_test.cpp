// SPDX-License-Identifier: MIT
#include <arcspan_tools/compare/comparison.hpp>
#include <arcspan_tools/counting/count_operations.hpp>
#include <arcspan_tools/counting/counted_integer.hpp>
#include <arcspan_tools/counting/counters.hpp>
#include <arcspan_tools/mesh/plain/generate.hpp>
#include <arcspan_tools/render/scene.hpp>
#include <catch2/catch.hpp>
#include <tests/support/random.hpp>

using namespace arcspan::tools;
using namespace arcspan_counting;

namespace {

using Int = Counted<std::int32_t>;
using Word = Counted<std::uint32_t>;
using Short = Counted<std::int16_t>;

/// The operations that `work` performs.
template <class Work>
OperationCounts counted(const Work& work) {
  OperationCounts counts;
  operation_target = &counts;
  work();
  operation_target = nullptr;
  return counts;
}

RenderJob sphere_job(const FixedMesh& mesh) {
  Scene scene;
  scene.size = {160, 120};
  return make_job(scene, mesh, "sphere");
}

MethodFigures figures(const std::string& shading) {
  const FixedMesh mesh = to_fixed(generate(*parse_generated_mesh("sphere:16x8")));
  const RenderJob job = sphere_job(mesh);
  return measure_method(shading, job, mesh, draw_reference(job, ReferenceKind::kPhong));
}

double rate(const MethodFigures& f, Operation kind) { return f.per_pixel[static_cast<std::size_t>(kind)]; }

}  // namespace

static_assert(sizeof(Short) == 2 && sizeof(Counted<std::int64_t>) == 8);
static_assert(std::same_as<decltype(Short{} + Short{}), Int>);  // as the plain types are promoted
static_assert(std::same_as<decltype(Int{} + Word{}), Word>);
static_assert(std::convertible_to<Short, Int> && !std::convertible_to<Int, Short>);
static_assert(!std::convertible_to<Int, std::int32_t> && !std::convertible_to<Int, bool>);

TEST_CASE("counted integers compute what plain ones do") {
  arcspan::test::Random random(7);
  for (int i = 0; i < 10'000; ++i) {
    const auto a = static_cast<std::uint32_t>(random.integer(-1'000'000, 1'000'000));
    const auto b = static_cast<std::uint32_t>(random.integer(1, 1'000'000));
    const int s = static_cast<int>(random.integer(0, 31));
    const Word p = a;
    const Word q = b;
    REQUIRE((p + q).plain() == a + b);
    REQUIRE((p - q).plain() == a - b);
    REQUIRE((p * q).plain() == a * b);
    REQUIRE((p / q).plain() == a / b);
    REQUIRE((p % q).plain() == a % b);
    REQUIRE((p & q).plain() == (a & b));
    REQUIRE((p | q).plain() == (a | b));
    REQUIRE((p ^ q).plain() == (a ^ b));
    REQUIRE((~p).plain() == ~a);
    REQUIRE((p >> s).plain() == a >> s);
    REQUIRE((p << s).plain() == a << s);
    REQUIRE((p < q) == (a < b));
    const auto x = static_cast<std::int32_t>(a);
    REQUIRE((Int(x) >> s).plain() == x >> s);
    REQUIRE((-Int(x)).plain() == -x);
    REQUIRE(static_cast<Short>(Int(x)).plain() == static_cast<std::int16_t>(x));
    REQUIRE((Int(x) < 0) == (x < 0));
  }
}

TEST_CASE("every kind of operation is counted once, where it is asked for") {
  Int x = 5;
  const OperationCounts c = counted([&x] {
    x = (x + 3) * x - (x >> 2);
    x /= 3;
    x <<= 2;
    const Int half = Int{1} << 7;  // a constant
    if ((x & half) == 0) x = -x;
  });
  CHECK(c[Operation::kAdd] == 3);
  CHECK(c[Operation::kMultiply] == 1);
  CHECK(c[Operation::kShift] == 2);
  CHECK(c[Operation::kDivide] == 1);
  CHECK(c[Operation::kLogic] == 1);
  CHECK(c[Operation::kCompare] == 1);
  CHECK(c.sum() == 9);
  x = x + x;  // nobody listens
  CHECK(counted([&x] { (void)count_as_one(Operation::kRoot, [&x] { return x * x; }); }).sum() == 1);
}

TEST_CASE("the counting pipeline draws the pipeline's own pixels") {
  const FixedMesh mesh = to_fixed(generate(*parse_generated_mesh("torus:12x8")));
  Scene scene;
  scene.size = {160, 120};
  scene.depth = false;
  const RenderJob job = make_job(scene, mesh, "torus");
  for (const ShadingRenderer& renderer : shading_renderers()) {
    CAPTURE(std::string(renderer.shading));
    const RenderStats stats =
        find_renderer(renderer.shading, "rgb888", false).render(job, [](std::size_t) {}).stats;
    const CountedDraw draw = count_operations(std::string(renderer.shading), job, mesh);
    CHECK(draw.pixels == stats.pixels);
    CHECK(draw.spans == stats.spans);
  }
}

TEST_CASE("the counting pipeline draws in bands, and pixels that are hidden cost less") {
  const FixedMesh mesh = to_fixed(generate(*parse_generated_mesh("torus:24x16")));
  Scene scene;
  scene.size = {160, 120};
  scene.camera.view = {0, 0.1, 1};  // one side of the ring hides the other
  const CountedDraw whole = count_operations("arc", make_job(scene, mesh, "torus"), mesh);
  scene.band_rows = 16;
  const CountedDraw bands = count_operations("arc", make_job(scene, mesh, "torus"), mesh);
  CHECK(bands.pixels == whole.pixels);
  CHECK(bands.spans == whole.spans);
  CHECK(bands.in_spans.sum() == whole.in_spans.sum());
  CHECK(bands.triangles > whole.triangles);
  CHECK(bands.around.sum() > whole.around.sum());
  scene.band_rows = 0;
  scene.depth = false;
  const CountedDraw all = count_operations("arc", make_job(scene, mesh, "torus"), mesh);
  CHECK(all.pixels == whole.pixels);
  CHECK(all.in_spans[Operation::kLookUp] > whole.in_spans[Operation::kLookUp]);
}

TEST_CASE("counted operations are the methods' own") {
  const MethodFigures flat = figures("flat");
  for (const double r : flat.per_pixel) CHECK(r == 0);
  const MethodFigures gouraud = figures("gouraud");
  CHECK(rate(gouraud, Operation::kMultiply) == 0);
  CHECK(rate(gouraud, Operation::kAdd) == Approx(3).margin(1e-6));  // three channels step
  CHECK(rate(gouraud, Operation::kLookUp) == 0);
  // S0: a multiply a scalar and pixel, and no long operation; the rest of its multiplies is the highlight's.
  const MethodFigures recurrence = figures("recurrence");
  CHECK(rate(recurrence, Operation::kMultiply) >= 2);
  CHECK(rate(recurrence, Operation::kDivide) == 0);
  CHECK(rate(recurrence, Operation::kRoot) == 0);
  CHECK(rate(recurrence, Operation::kLookUp) >= 1);  // the ramp
}

TEST_CASE("with no highlight in reach recurrence steps two scalars and looks up a ramp, no more") {
  // Large triangles, because the start of a row is counted as its pixels'.
  const FixedMesh mesh = to_fixed(generate(*parse_generated_mesh("sphere:12x6")));
  Scene scene;
  scene.size = {1000, 750};
  scene.surface.shininess = 256;
  const RenderJob job = make_job(scene, mesh, "sphere");
  const CountedDraw sharp = count_operations("recurrence", job, mesh);
  const double multiplies =
      static_cast<double>(sharp.in_spans[Operation::kMultiply]) / static_cast<double>(sharp.pixels);
  CHECK(multiplies > 2);
  // The starts of rows and the highlight add few.
  CHECK(multiplies < 3.2);
}

TEST_CASE("arc takes no more operations the larger its tolerance is") {
  for (const char* name : {"sphere:16x8", "sphere:48x24", "torus:48x24"}) {
    const FixedMesh mesh = to_fixed(generate(*parse_generated_mesh(name)));
    const auto operations = [&](std::int32_t tolerance) {
      RenderJob job = sphere_job(mesh);
      job.tolerance = tolerance;
      const CountedDraw drawn = count_operations("arc", job, mesh);
      return drawn.in_spans.sum() + drawn.around.sum();
    };
    CAPTURE(name);
    CHECK(operations(1) < operations(0));
    CHECK(operations(64) <= operations(1));
  }
}
