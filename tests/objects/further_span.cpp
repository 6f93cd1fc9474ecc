// SPDX-License-Identifier: MIT
// The span stages of the methods of the literature, but for those that divide by definition (phong,
// phong-segment, duff), of a method for products with four lights, and of operations in another format.
#include <arcspan/literature/arc_vector.hpp>
#include <arcspan/literature/dichotomy.hpp>
#include <arcspan/literature/kuijk_blake.hpp>
#include <arcspan/literature/lyon.hpp>
#include <arcspan/literature/phong.hpp>
#include <arcspan/literature/recurrence_four.hpp>
#include <arcspan/literature/recurrence_method.hpp>
#include <arcspan/literature/reflection_map.hpp>
#include <arcspan/literature/segment.hpp>
#include <arcspan/literature/slerp.hpp>
#include <arcspan/pixel/argb8888.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/span/depth_mode.hpp>

#include <tests/objects/instances.hpp>
#include <tests/objects/surface_list.hpp>

namespace arcspan {

ARCSPAN_SPAN_INSTANTIATE(Arc<Blinn4>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(Window, Argb8888, ReadOnlyDepth);
ARCSPAN_SPAN_INSTANTIATE(ArcVector<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(DichotomyLinear<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(DichotomyQuadratic<Phong4>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(DichotomyCubic<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(DichotomyRoot<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(DichotomyPrintedLinear<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(DichotomyPrintedQuadratic<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(KuijkBlake<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(Lyon<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(PhongReciprocal<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(Recurrence<Phong1>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(RecurrenceFour<Phong1>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(ReflectionMap<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(Segment<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(Slerp<Blinn1>, Rgb565, DepthBuffer);

}  // namespace arcspan
