// SPDX-License-Identifier: MIT
// Whole calls of draw_mesh() of arc, of which all_stages.cpp and span_stage.cpp have the stages; one of a
// mesh that joints move, with its vertices in slots, and the smoothing and the ink of its outlines.
#include <arcspan/animate/skinned_mesh.hpp>
#include <arcspan/draw/triangle_sides.hpp>
#include <arcspan/draw/vertex_slots.hpp>
#include <arcspan/ink_outlines.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/smooth_outlines.hpp>

#include <tests/objects/instances.hpp>
#include <tests/objects/surface_list.hpp>

namespace arcspan {

ARCSPAN_MESH_INSTANTIATE(Arc<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_MESH_INSTANTIATE(Arc<Phong1>, Rgb565, DepthBuffer);
ARCSPAN_MESH_INSTANTIATE(Arc<Phong4>, Gray8, NoDepth);

using Slots = VertexSlots<Arc<Blinn1>>;
using Frame = hal::Framebuffer<Rgb565>;
template DrawResult draw_mesh<Arc<Blinn1>>(const MorphedSkinnedMesh&, const ClipTransform&, const Blinn1&,
                                           Frame&, const DepthBuffer&, Slots&, const DrawOptions&);
template Status find_sides<Arc<Blinn1>>(const SkinnedMesh&, const ClipTransform&, const Blinn1&, Slots&,
                                        std::span<TriangleSide>, const DrawOptions&);
template Status ink_outlines(const OutlineList&, const OutlineInk&, Frame&, const DepthBuffer&,
                             std::span<OutlineGap<Rgb565>>);
template Status smooth_outlines(const OutlineList&, Frame&, const DepthBuffer&,
                                std::span<OutlineGap<Rgb565>>);
template Status smooth_outlines(const OutlineList&, Frame&, const DepthBuffer&);

}  // namespace arcspan
