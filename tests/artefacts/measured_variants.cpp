// SPDX-License-Identifier: MIT
#include <arcspan_tools/render/render_directly.hpp>
#include <tests/artefacts/measured_variants.hpp>
#include <tests/artefacts/speed_claims.hpp>

namespace arcspan::tools {
namespace {

/// Draws into rgb565 with a depth test, with the first light and Blinn's highlight, whatever the job asks
/// for.
template <template <class> class Method>
RenderResult render_variant(const RenderJob& job, const PixelChoice& pixels, const RowsDone& rows_done) {
  return detail::render_directly<Method, Highlight::kBlinn>(job, pixels, rows_done);
}

}  // namespace
}  // namespace arcspan::tools

std::vector<MeasuredVariant> measured_variants() {
  using namespace arcspan;
#define ARCSPAN_ENTRY(name, Class) {name, &tools::render_variant<arcspan::Class>},
  return {ARCSPAN_FOR_EACH_MEASURED_VARIANT(ARCSPAN_ENTRY)};
#undef ARCSPAN_ENTRY
}
