// SPDX-License-Identifier: MIT
// The renderer of one shading method. The build compiles this file once for each entry of
// shading_method_list.hpp, with ARCSPAN_METHOD and ARCSPAN_METHOD_HEADER defined.
// No #pragma once: a source may hold several methods.

#include <arcspan_tools/render/render_with.hpp>
#include ARCSPAN_METHOD_HEADER

namespace arcspan::tools {

RenderFunction ARCSPAN_METHOD_FUNCTION(render, ARCSPAN_METHOD);
RenderFunction ARCSPAN_METHOD_FUNCTION(render_directly, ARCSPAN_METHOD);

RenderResult ARCSPAN_METHOD_FUNCTION(render, ARCSPAN_METHOD)(const RenderJob& job, const PixelChoice& pixels,
                                                             const RowsDone& rows_done) {
  constexpr std::string_view kName = ARCSPAN_NAME_OF(ARCSPAN_METHOD);
  constexpr bool kAsksForRamp =
      kName != "Flat" && kName != "Gouraud" && (!is_literature_method(kName) || kName == "Segment");
#ifdef ARCSPAN_ALWAYS_VIRTUAL  // the same pictures, drawn slower and compiled faster
  constexpr RenderFunction* kDirectly = nullptr;
#else
  constexpr RenderFunction* kDirectly = &ARCSPAN_METHOD_FUNCTION(render_directly, ARCSPAN_METHOD);
#endif
  const bool has_highlight = draws_phong_directly(kName) || job.highlight == Highlight::kBlinn;
  return render_with<ARCSPAN_METHOD, kAsksForRamp, draws_effects(kName)>(job, pixels, rows_done,
                                                                         has_highlight ? kDirectly : nullptr);
}

}  // namespace arcspan::tools
