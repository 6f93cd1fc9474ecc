// SPDX-License-Identifier: MIT
// The renderer of one shading method without virtual calls, whose times are reported. The build compiles this
// file once for each entry of shading_method_list.hpp, with ARCSPAN_METHOD and ARCSPAN_METHOD_HEADER defined.
// No #pragma once: a source may hold several methods.

#include <arcspan_tools/render/render_directly.hpp>
#include <arcspan_tools/shading_method_list.hpp>
#include ARCSPAN_METHOD_HEADER

namespace arcspan::tools {

RenderFunction ARCSPAN_METHOD_FUNCTION(render_directly, ARCSPAN_METHOD);

RenderResult ARCSPAN_METHOD_FUNCTION(render_directly, ARCSPAN_METHOD)(const RenderJob& job,
                                                                      const PixelChoice& pixels,
                                                                      const RowsDone& rows_done) {
  if (job.highlight == Highlight::kPhong)
    return detail::render_directly<ARCSPAN_METHOD, Highlight::kPhong>(job, pixels, rows_done);
  return detail::render_directly<ARCSPAN_METHOD, Highlight::kBlinn>(job, pixels, rows_done);
}

}  // namespace arcspan::tools
