// SPDX-License-Identifier: MIT
// Every stage of the pipeline: the object that must need nothing from outside. Flat, Gouraud and Wireframe
// are whole calls of draw_mesh(). Of other methods, illuminations, texels and operations there are only the
// functions of the protocol of shading/method.hpp that come before the span stage, which span_stage.cpp has:
// the stages around them are the same. Whole calls of arc are in the images that
// tests/firmware/image_test.py looks at, and in whole_calls.cpp.
#include <arcspan/draw/wireframe.hpp>
#include <arcspan/draw_billboards.hpp>
#include <arcspan/draw_lines.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/span/depth_mode.hpp>

#include <tests/objects/instances.hpp>
#include <tests/objects/surface_list.hpp>

namespace arcspan {

ARCSPAN_MESH_INSTANTIATE(Flat<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_MESH_INSTANTIATE(Gouraud<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_MESH_INSTANTIATE(Wireframe<>, Rgb565, DepthBuffer);

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

ARCSPAN_PREPARE_INSTANTIATE(Window);
ARCSPAN_PREPARE_INSTANTIATE(Chrome);
ARCSPAN_PREPARE_INSTANTIATE(Glass);
ARCSPAN_PREPARE_INSTANTIATE(Sign);
ARCSPAN_PREPARE_INSTANTIATE(Wall);
ARCSPAN_PREPARE_INSTANTIATE(Stage);
ARCSPAN_PREPARE_INSTANTIATE(Ghost);
ARCSPAN_PREPARE_INSTANTIATE(Arc<Blinn1>);
ARCSPAN_PREPARE_INSTANTIATE(Arc<Phong1>);
ARCSPAN_PREPARE_INSTANTIATE(Arc<Blinn4>);
ARCSPAN_PREPARE_INSTANTIATE(Arc<Phong4>);

}  // namespace arcspan
