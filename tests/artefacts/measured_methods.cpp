// SPDX-License-Identifier: MIT
#include <arcspan_tools/render/render_with.hpp>
#include <tests/artefacts/dichotomy_variants.hpp>
#include <tests/artefacts/speed_claims.hpp>

namespace arcspan_counting {

// Defined by count_measured_methods.cpp.
#define ARCSPAN_DECLARE(name, Class) CountFunction count_##Class;
ARCSPAN_FOR_EACH_DICHOTOMY_VARIANT(ARCSPAN_DECLARE)
#undef ARCSPAN_DECLARE

}  // namespace arcspan_counting

namespace arcspan::tools {
namespace {

/// As render_with(), for one light and Blinn's highlight only.
template <template <class> class Method>
RenderResult render_variant(const RenderJob& job, const PixelChoice& pixels, const RowsDone& rows_done) {
  if (job.lights.size() != 1 || job.highlight != Highlight::kBlinn) {
    throw Failure("a measured method", "has one light and Blinn's highlight");
  }
  return detail::render_lit<Method, AnyIllumination>(
      job, pixels, detail::illumination_of<1, Highlight::kBlinn>(job), rows_done);
}

}  // namespace
}  // namespace arcspan::tools

std::vector<arcspan::tools::MeasuredMethod> measured_methods() {
  using namespace arcspan;
#define ARCSPAN_ENTRY(name, Class) \
  {name, &tools::render_variant<arcspan::Class>, &arcspan_counting::count_##Class},
  return {ARCSPAN_FOR_EACH_DICHOTOMY_VARIANT(ARCSPAN_ENTRY)};
#undef ARCSPAN_ENTRY
}
