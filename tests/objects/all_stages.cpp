// SPDX-License-Identifier: MIT
// Every stage of the pipeline for every method: the object that must need nothing from outside.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/fog.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/shading/adaptive/adaptive.hpp>
#include <arcspan/shading/arc/arc.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/grey_gouraud.hpp>
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
#include <arcspan/shading/textured/environment_map.hpp>
#include <arcspan/shading/textured/textured.hpp>
#include <arcspan/shading/vertex_coloured.hpp>
#include <arcspan/shading/with_operation.hpp>
#include <arcspan/span/depth_mode.hpp>

namespace arcspan {

using Blinn1 = Illumination<1, Highlight::kBlinn>;
using Blinn4 = Illumination<4, Highlight::kBlinn>;
using Phong1 = Illumination<1, Highlight::kPhong>;
using Phong4 = Illumination<4, Highlight::kPhong>;

using Window =
    WithOperation<WithOperation<Textured<Adaptive<Phong1>, Palette8Texels<Alpha4Colour>>, Fogged>, Opacity<>>;
using Sign = Textured<Unlit, Palette4Texels<Alpha1Colour>>;
using Wall = Textured<GreyGouraud<Blinn4>, DirectTexels<>>;
using Stage = Textured<Gouraud<Blinn1>, GrayTexels, TexelLight::kColoured>;
using Chrome = Arc<EnvironmentMap<DirectTexels<>>>;
using Glass = WithOperation<VertexColoured<Blinn1>, Opacity<Blend::kMultiply>>;
using Ghost = WithOperation<UnlitVertexColoured, ScreenDoor>;

#define ARCSPAN_INSTANTIATE(METHOD, FORMAT, DEPTH)                                               \
  template DrawResult draw_mesh<METHOD, DrawFeatures{}, hal::Framebuffer<FORMAT>, DEPTH>(        \
      const MeshView&, const ClipTransform&, const METHOD::Lighting&, hal::Framebuffer<FORMAT>&, \
      const DEPTH&, std::span<CachedVertex<METHOD>>, const DrawOptions&)

ARCSPAN_INSTANTIATE(Window, Rgb565, ReadOnlyDepth);
ARCSPAN_INSTANTIATE(Window, Rgb888, ReadOnlyDepth);
ARCSPAN_INSTANTIATE(Sign, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Wall, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Stage, Rgb888, NoDepth);
ARCSPAN_INSTANTIATE(Chrome, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Glass, Rgb565, ReadOnlyDepth);
ARCSPAN_INSTANTIATE(Ghost, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Flat<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Gouraud<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Arc<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Adaptive<Phong1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Adaptive<Blinn4>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(ArcVector<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Duff<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(DichotomyLinear<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(DichotomyQuadratic<Phong4>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(DichotomyCubic<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(DichotomyPrintedLinear<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(DichotomyPrintedQuadratic<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(KuijkBlake<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Lyon<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Phong<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(PhongReciprocal<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(PhongSegment<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Recurrence<Phong1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(RecurrenceFour<Phong1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(ReflectionMap<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Segment<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Slerp<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Arc<Phong1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Arc<Blinn4>, Rgb888, DepthBuffer);
ARCSPAN_INSTANTIATE(Arc<Phong4>, Gray8, NoDepth);

}  // namespace arcspan
