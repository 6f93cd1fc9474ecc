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
  RenderFunction* directly = nullptr;
  if constexpr (draws_directly(kName)) directly = &ARCSPAN_METHOD_FUNCTION(render_directly, ARCSPAN_METHOD);
  return render_with<ARCSPAN_METHOD, kAsksForRamp, draws_effects(kName)>(job, pixels, rows_done, directly);
}

}  // namespace arcspan::tools
