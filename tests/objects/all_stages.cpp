// SPDX-License-Identifier: MIT
// Every stage of the pipeline: the object that must need nothing from outside. The methods for products, and
// those that span_stage.cpp does not hold because they divide there, as whole calls of draw_mesh(). Of the
// others, and of Arc and Adaptive with other illuminations, only the functions of the protocol of
// shading/method.hpp that come before the span stage: the stages around them are the same.
#include <arcspan/draw.hpp>
#include <arcspan/draw_billboards.hpp>
#include <arcspan/draw_lines.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/prepare/prepare_triangle.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
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
#include <arcspan/shading/segment/segment.hpp>
#include <arcspan/shading/wireframe.hpp>
#include <arcspan/span/depth_mode.hpp>

#include <tests/objects/surface_list.hpp>

namespace arcspan {

#define ARCSPAN_INSTANTIATE(METHOD, FORMAT, DEPTH)                                               \
  template DrawResult draw_mesh<METHOD, DrawFeatures{}, hal::Framebuffer<FORMAT>, DEPTH>(        \
      const MeshView&, const ClipTransform&, const METHOD::Lighting&, hal::Framebuffer<FORMAT>&, \
      const DEPTH&, std::span<CachedVertex<METHOD>>, const DrawOptions&)

ARCSPAN_INSTANTIATE(Window, Rgb565, ReadOnlyDepth);
ARCSPAN_INSTANTIATE(Chrome, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Glass, Rgb565, ReadOnlyDepth);
ARCSPAN_INSTANTIATE(Flat<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Gouraud<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Arc<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Adaptive<Phong1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Duff<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Phong<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(PhongSegment<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Segment<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Arc<Phong4>, Gray8, NoDepth);
ARCSPAN_INSTANTIATE(Wireframe<>, Rgb565, DepthBuffer);

using Frame565 = hal::Framebuffer<Rgb565>;
template Status draw_lines<Unlit, Frame565, DepthBuffer>(std::span<const ObjectLine>, const ClipTransform&,
                                                         const PackedRgb&, Frame565&, const DepthBuffer&,
                                                         DepthBias);
template Status draw_points<Unlit, Frame565, DepthBuffer>(std::span<const ObjectPosition>, std::uint8_t,
                                                          const ClipTransform&, const PackedRgb&, Frame565&,
                                                          const DepthBuffer&, DepthBias);
template Status draw_screen_line<Unlit, Frame565, NoDepth>(const RasterPosition&, const RasterPosition&,
                                                           const Viewport&, const PackedRgb&, Frame565&,
                                                           const NoDepth&, DepthBias);
template Status draw_billboards<Sign, Frame565, DepthBuffer>(std::span<const ObjectPosition>,
                                                             const BillboardSize&, const ClipTransform&,
                                                             const Sign::Lighting&, Frame565&,
                                                             const DepthBuffer&);

/// Vertices are made, an edge is cut, and the triangle is prepared as a large one and as a small one.
template <class Method>
bool prepare(const MeshView& mesh, const typename Method::Lighting& lighting, const Direction& face,
             const RowRange& rows, SmallTriangle& small, TriangleCommand<Method>& command) {
  RasterVertex<Method> v[3];
  for (std::size_t i = 0; i < 3; ++i) {
    v[i].position = {mesh.position(i).x, mesh.position(i).y, 0};
    v[i].shade = Method::shade_vertex(lighting, unpack_normal(mesh.normal(i)));
    if constexpr (TakesVertexData<Method>) Method::set_vertex_data(mesh, i, v[i].shade);
  }
  v[2].shade = Method::between(v[1].shade, v[2].shade, Factor::from_raw(face.x.raw()));
  if constexpr (DrawsSmallTriangles<Method>) {
    typename Method::Small part;
    if (Method::prepare_small(lighting, v[0], v[1], v[2], small, part)) return true;
  }
  return prepare_triangle(lighting, v[0], v[1], v[2], Method::shade_face(lighting, face), rows, command);
}

#define ARCSPAN_PREPARE_INSTANTIATE(METHOD)                                                          \
  template bool prepare(const MeshView&, const METHOD::Lighting&, const Direction&, const RowRange&, \
                        SmallTriangle&, TriangleCommand<METHOD>&)

ARCSPAN_PREPARE_INSTANTIATE(Sign);
ARCSPAN_PREPARE_INSTANTIATE(Wall);
ARCSPAN_PREPARE_INSTANTIATE(Stage);
ARCSPAN_PREPARE_INSTANTIATE(Ghost);
ARCSPAN_PREPARE_INSTANTIATE(Arc<Phong1>);
ARCSPAN_PREPARE_INSTANTIATE(Arc<Blinn4>);
ARCSPAN_PREPARE_INSTANTIATE(Adaptive<Blinn4>);
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
