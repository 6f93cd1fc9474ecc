// SPDX-License-Identifier: MIT
// Whole calls of draw_mesh() of arc, of which all_stages.cpp and span_stage.cpp have the stages.
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <tests/objects/instances.hpp>
#include <tests/objects/surface_list.hpp>

namespace arcspan {

ARCSPAN_MESH_INSTANTIATE(Arc<Blinn1>, Rgb565, DepthBuffer);
ARCSPAN_MESH_INSTANTIATE(Arc<Phong1>, Rgb565, DepthBuffer);
ARCSPAN_MESH_INSTANTIATE(Arc<Phong4>, Gray8, NoDepth);

}  // namespace arcspan
