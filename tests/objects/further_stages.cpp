// SPDX-License-Identifier: MIT
// The methods of the literature: whole calls of draw_mesh() of those that divide in the span stage by
// definition, of the others the stages before it. Their span stages are in further_span.cpp.
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/literature/arc_vector.hpp>
#include <arcspan/shading/literature/dichotomy.hpp>
#include <arcspan/shading/literature/duff.hpp>
#include <arcspan/shading/literature/kuijk_blake.hpp>
#include <arcspan/shading/literature/lyon.hpp>
#include <arcspan/shading/literature/phong.hpp>
#include <arcspan/shading/literature/phong_segment.hpp>
#include <arcspan/shading/literature/recurrence_four.hpp>
#include <arcspan/shading/literature/recurrence_method.hpp>
#include <arcspan/shading/literature/reflection_map.hpp>
#include <arcspan/shading/literature/slerp.hpp>
#include <arcspan/span/depth_mode.hpp>

#include <tests/objects/instances.hpp>
#include <tests/objects/surface_list.hpp>

namespace arcspan {

ARCSPAN_MESH_INSTANTIATE(Duff<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_MESH_INSTANTIATE(Phong<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_MESH_INSTANTIATE(PhongSegment<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_PREPARE_INSTANTIATE(ArcVector<Blinn1>);
ARCSPAN_PREPARE_INSTANTIATE(DichotomyLinear<Blinn1>);
ARCSPAN_PREPARE_INSTANTIATE(DichotomyQuadratic<Phong4>);
ARCSPAN_PREPARE_INSTANTIATE(DichotomyCubic<Blinn1>);
ARCSPAN_PREPARE_INSTANTIATE(DichotomyPrintedLinear<Blinn1>);
ARCSPAN_PREPARE_INSTANTIATE(DichotomyPrintedQuadratic<Blinn1>);
ARCSPAN_PREPARE_INSTANTIATE(KuijkBlake<Blinn1>);
ARCSPAN_PREPARE_INSTANTIATE(Lyon<Blinn1>);
ARCSPAN_PREPARE_INSTANTIATE(PhongReciprocal<Blinn1>);
ARCSPAN_PREPARE_INSTANTIATE(Recurrence<Phong1>);
ARCSPAN_PREPARE_INSTANTIATE(RecurrenceFour<Phong1>);
ARCSPAN_PREPARE_INSTANTIATE(ReflectionMap<Blinn1>);
ARCSPAN_PREPARE_INSTANTIATE(Slerp<Blinn1>);

}  // namespace arcspan
