// SPDX-License-Identifier: MIT
// The span stage and nothing else, for every format and every method for products: the object that must hold
// no division.
#include <arcspan/draw/wireframe.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/mono.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/span/depth_mode.hpp>
#include <arcspan/span/draw_small.hpp>
#include <arcspan/span/line_rows.hpp>

#include <tests/objects/instances.hpp>
#include <tests/objects/surface_list.hpp>

namespace arcspan {

ARCSPAN_SPAN_INSTANTIATE(Window, Rgb565, ReadOnlyDepth);
ARCSPAN_SPAN_INSTANTIATE(Sign, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(Poster, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(Wall, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(Stage, Rgb888, NoDepth);
ARCSPAN_SPAN_INSTANTIATE(Chrome, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(Glass, Rgb565, ReadOnlyDepth);
ARCSPAN_SPAN_INSTANTIATE(Ghost, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(Flat<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(Gouraud<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(Arc<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(Arc<Phong4>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(Arc<Phong1>, Rgb565, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(Arc<Blinn4>, Rgb888, DepthBuffer);
ARCSPAN_SPAN_INSTANTIATE(Arc<Coloured4>, Gray8, NoDepth);
ARCSPAN_SPAN_INSTANTIATE(Arc<Phong1>, Gray4, NoDepth);
ARCSPAN_SPAN_INSTANTIATE(Arc<Phong1>, Dithered<Mono>, NoDepth);
ARCSPAN_SPAN_INSTANTIATE(Arc<Phong1>, Dithered<Rgb565>, DepthBuffer);

// The runs of small triangles, by the shading method's surfaces.
template <class Surface, class Lighting, class Format, class Depth>
Status draw_small(const SmallTriangle& triangle, const Surface& surface, const RasterOrigin& origin,
                  const detail::RowTarget<Lighting, hal::Framebuffer<Format>, Depth>& target) {
  return detail::draw_small_pixels(triangle, surface, origin, target);
}
#define ARCSPAN_INSTANTIATE_SMALL(LIGHTING, FORMAT, DEPTH, ...)                             \
  template Status draw_small(const SmallTriangle&, const __VA_ARGS__&, const RasterOrigin&, \
                             const detail::RowTarget<LIGHTING, hal::Framebuffer<FORMAT>, DEPTH>&)

ARCSPAN_INSTANTIATE_SMALL(Phong1, Rgb565, DepthBuffer, SmallRows<LinearRun<Phong1, 1>, 2>);
ARCSPAN_INSTANTIATE_SMALL(Phong1, Rgb565, DepthBuffer, SmallRows<LinearRun<Phong1, 2>, 2>);
ARCSPAN_INSTANTIATE_SMALL(Phong1, Rgb565, DepthBuffer, SmallRows<NormalisedRun<Phong1, 1>, 2>);
ARCSPAN_INSTANTIATE_SMALL(Phong1, Gray4, NoDepth, SmallRows<NormalisedRun<Phong1, 2>, 2>);
ARCSPAN_INSTANTIATE_SMALL(Blinn4, Rgb888, DepthBuffer, SmallRows<NormalisedRun<Blinn4, 8>, 8>);

// Lines and points.
template <class Method, class Format, class Depth>
Status draw_strokes(
    const LineCommand& line, const RasterOrigin& origin, const Rect& rect,
    const detail::RowTarget<typename Method::Lighting, hal::Framebuffer<Format>, Depth>& target) {
  const Status status = detail::draw_line_command<Method>(line, origin, target);
  return ok(status) ? detail::draw_rectangle<Method>(rect, 500, 0, target) : status;
}
#define ARCSPAN_INSTANTIATE_STROKES(METHOD, FORMAT, DEPTH)  \
  template Status draw_strokes<METHOD>(                     \
      const LineCommand&, const RasterOrigin&, const Rect&, \
      const detail::RowTarget<METHOD::Lighting, hal::Framebuffer<FORMAT>, DEPTH>&)

using Haze = WithOperation<WithOperation<Unlit, Fogged>, Opacity<>>;
ARCSPAN_INSTANTIATE_STROKES(Unlit, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE_STROKES(Unlit, Dithered<Mono>, NoDepth);
ARCSPAN_INSTANTIATE_STROKES(Haze, Rgb888, ReadOnlyDepth);
ARCSPAN_INSTANTIATE_STROKES(Wireframe<>, Gray4, DepthBuffer);

}  // namespace arcspan
