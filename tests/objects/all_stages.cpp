// SPDX-License-Identifier: MIT
// Every stage of the pipeline for every method: the object that must need nothing from outside.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/shading/adaptive.hpp>
#include <arcspan/shading/arc.hpp>
#include <arcspan/shading/arc_vector.hpp>
#include <arcspan/shading/dichotomy.hpp>
#include <arcspan/shading/duff.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/kuijk_blake.hpp>
#include <arcspan/shading/lyon.hpp>
#include <arcspan/shading/phong.hpp>
#include <arcspan/shading/reflection_map.hpp>
#include <arcspan/shading/segment.hpp>
#include <arcspan/shading/slerp.hpp>

namespace arcspan {

using Blinn1 = Illumination<1, Highlight::kBlinn>;
using Blinn4 = Illumination<4, Highlight::kBlinn>;
using Phong1 = Illumination<1, Highlight::kPhong>;
using Phong4 = Illumination<4, Highlight::kPhong>;

#define ARCSPAN_INSTANTIATE(METHOD, FORMAT, DEPTH)                                                           \
  template DrawResult draw_mesh<METHOD, DrawFeatures{}, hal::Framebuffer<FORMAT>, DEPTH>(                    \
      const MeshView&, const ClipTransform&, const METHOD::Object&, hal::Framebuffer<FORMAT>&, const DEPTH&, \
      std::span<CachedVertex<METHOD>>, const DrawOptions&)

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
ARCSPAN_INSTANTIATE(KuijkBlake<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Lyon<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Phong<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(ReflectionMap<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Segment<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Slerp<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Arc<Phong1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Arc<Blinn4>, Rgb888, DepthBuffer);
ARCSPAN_INSTANTIATE(Arc<Phong4>, Gray8, NoDepth);

}  // namespace arcspan
