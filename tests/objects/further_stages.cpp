// SPDX-License-Identifier: MIT
// The methods of the literature: whole calls of draw_mesh() of those that divide in the span stage by
// definition, of the others the stages before it. Their span stages are in further_span.cpp.
#include <arcspan/literature/arc_vector.hpp>
#include <arcspan/literature/dichotomy.hpp>
#include <arcspan/literature/duff.hpp>
#include <arcspan/literature/kuijk_blake.hpp>
#include <arcspan/literature/lyon.hpp>
#include <arcspan/literature/phong.hpp>
#include <arcspan/literature/phong_segment.hpp>
#include <arcspan/literature/recurrence_four.hpp>
#include <arcspan/literature/recurrence_method.hpp>
#include <arcspan/literature/reflection_map.hpp>
#include <arcspan/literature/segment.hpp>
#include <arcspan/literature/slerp.hpp>
#include <arcspan/pixel/rgb565.hpp>
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
ARCSPAN_PREPARE_INSTANTIATE(DichotomyRoot<Blinn1>);
ARCSPAN_PREPARE_INSTANTIATE(DichotomyPrintedLinear<Blinn1>);
ARCSPAN_PREPARE_INSTANTIATE(DichotomyPrintedQuadratic<Blinn1>);
ARCSPAN_PREPARE_INSTANTIATE(KuijkBlake<Blinn1>);
ARCSPAN_PREPARE_INSTANTIATE(Lyon<Blinn1>);
ARCSPAN_PREPARE_INSTANTIATE(PhongReciprocal<Blinn1>);
ARCSPAN_PREPARE_INSTANTIATE(Recurrence<Phong1>);
ARCSPAN_PREPARE_INSTANTIATE(RecurrenceFour<Phong1>);
ARCSPAN_PREPARE_INSTANTIATE(ReflectionMap<Blinn1>);
ARCSPAN_PREPARE_INSTANTIATE(Segment<Blinn1>);
ARCSPAN_PREPARE_INSTANTIATE(Slerp<Blinn1>);

}  // namespace arcspan
