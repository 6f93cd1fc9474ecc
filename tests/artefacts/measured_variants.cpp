// SPDX-License-Identifier: MIT
#include <arcspan_tools/render/render_with.hpp>
#include <tests/artefacts/measured_variants.hpp>
#include <tests/artefacts/speed_claims.hpp>

namespace arcspan::tools {
namespace {

/// Draws into rgb565 with a depth test, with one light and Blinn's highlight, whatever the job asks for.
template <template <class> class Method>
RenderResult render_variant(const RenderJob& job, const PixelChoice& pixels, const RowsDone& rows_done) {
  using Lit = Illumination<1, Highlight::kBlinn>;
  using Shading = Method<Lit>;
  const auto lightings = detail::lightings_of<Shading>(job, detail::illuminations_of<Lit>(job));
  return detail::render_bands<Shading, detail::DirectBand>(job, pixels, lightings, rows_done);
}

}  // namespace
}  // namespace arcspan::tools

std::vector<MeasuredVariant> measured_variants() {
  using namespace arcspan;
#define ARCSPAN_ENTRY(name, Class) {name, &tools::render_variant<arcspan::Class>},
  return {ARCSPAN_FOR_EACH_MEASURED_VARIANT(ARCSPAN_ENTRY)};
#undef ARCSPAN_ENTRY
}
