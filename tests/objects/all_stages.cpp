// SPDX-License-Identifier: MIT
// Every stage of the pipeline for every method: the object that must need nothing from outside.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/shading/arc.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>

namespace arcspan {

using Blinn1 = Illumination<1, Highlight::kBlinn>;
using Blinn4 = Illumination<4, Highlight::kBlinn>;
using Phong1 = Illumination<1, Highlight::kPhong>;
using Phong4 = Illumination<4, Highlight::kPhong>;

#define ARCSPAN_INSTANTIATE(METHOD, FORMAT, DEPTH)                                                           \
  template DrawResult draw_mesh<METHOD, hal::Framebuffer<FORMAT>, DEPTH>(                                    \
      const MeshView&, const ClipTransform&, const METHOD::Object&, hal::Framebuffer<FORMAT>&, const DEPTH&, \
      std::span<CachedVertex<METHOD>>, const DrawOptions&)

ARCSPAN_INSTANTIATE(Flat<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Gouraud<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Arc<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Arc<Phong1>, Rgb565, DepthBuffer);
ARCSPAN_INSTANTIATE(Arc<Blinn4>, Rgb888, DepthBuffer);
ARCSPAN_INSTANTIATE(Arc<Phong4>, Gray8, NoDepth);

}  // namespace arcspan
