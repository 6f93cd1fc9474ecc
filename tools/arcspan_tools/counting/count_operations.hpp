// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/counting/count_job.hpp>
#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/render/render.hpp>

#include <string_view>

namespace arcspan::tools {

/// Draws a job in the pipeline that counts, in the job's bands. `meshes` are those of the
/// job. Textures, opacity and fog are left out; several lights are white, and highlights do not fade.
[[nodiscard]] arcspan_counting::CountedDraw count_operations(arcspan_counting::CountFunction& count,
                                                             const RenderJob& job, const FixedMeshes& meshes);

/// Counts with the shading method that --shading calls `shading`; throws Failure if there is none.
[[nodiscard]] arcspan_counting::CountedDraw count_operations(std::string_view shading, const RenderJob& job,
                                                             const FixedMeshes& meshes);

/// The function that counts with this shading method; throws Failure if there is none.
[[nodiscard]] arcspan_counting::CountFunction* find_counter(std::string_view shading);

}  // namespace arcspan::tools
