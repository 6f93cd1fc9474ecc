// SPDX-License-Identifier: MIT
#include <arcspan/literature/arc_vector.hpp>
#include <arcspan/literature/dichotomy.hpp>
#include <arcspan/literature/duff.hpp>
#include <arcspan/literature/kuijk_blake.hpp>
#include <arcspan/literature/lyon.hpp>
#include <arcspan/literature/phong.hpp>
#include <arcspan/literature/recurrence_four.hpp>
#include <arcspan/literature/slerp.hpp>

#include <tests/support/probed_methods.hpp>
#include <tests/support/raster_stage.hpp>

#include <map>

namespace arcspan::test {

namespace {

/// `segment_bits` is that of a method with segments, or 0 for its usual one.
template <class Method, int segment_bits = 0>
void draw(const ProbedTriangle& triangle, const Probe& probe, RunList& runs) {
  const Rect bounds = runs.bounds();
  typename Method::Lighting lighting(probe);
  if constexpr (segment_bits != 0) (void)lighting.set_segment_bits(segment_bits);
  RasterStage<Method, RunList> stage(runs, bounds.right, bounds.bottom, lighting);
  const auto vertex = [&](std::size_t i) {
    return RasterVertex<Method>{triangle.points[i], Method::shade_vertex(probe, triangle.normals[i])};
  };
  stage.draw(vertex(0), vertex(1), vertex(2));
}

const std::map<std::string_view, DrawProbed> kMethods{
    {"arc-vector", &draw<ArcVector<Probe>>},
    {"dichotomy-cubic", &draw<DichotomyCubic<Probe>>},
    {"dichotomy-cubic-16", &draw<DichotomyCubic<Probe>, 4>},
    {"dichotomy-linear", &draw<DichotomyLinear<Probe>>},
    {"dichotomy-printed-linear", &draw<DichotomyPrintedLinear<Probe>>},
    {"dichotomy-printed-quadratic", &draw<DichotomyPrintedQuadratic<Probe>>},
    {"dichotomy-quadratic", &draw<DichotomyQuadratic<Probe>>},
    {"dichotomy-quadratic-2", &draw<DichotomyQuadratic<Probe>, 1>},
    {"dichotomy-quadratic-4", &draw<DichotomyQuadratic<Probe>, 2>},
    {"dichotomy-quadratic-16", &draw<DichotomyQuadratic<Probe>, 4>},
    {"dichotomy-root", &draw<DichotomyRoot<Probe>>},
    {"duff", &draw<Duff<Probe>>},
    {"kuijk-blake", &draw<KuijkBlake<Probe>>},
    {"lyon", &draw<Lyon<Probe>>},
    {"phong", &draw<Phong<Probe>>},
    {"phong-reciprocal", &draw<PhongReciprocal<Probe>>},
    {"recurrence", &draw<Recurrence<Probe>>},
    {"recurrence-four", &draw<RecurrenceFour<Probe>>},
    {"slerp", &draw<arcspan::Slerp<Probe>>},
};

}  // namespace

DrawProbed probed_method(std::string_view name) { return kMethods.at(name); }

}  // namespace arcspan::test
