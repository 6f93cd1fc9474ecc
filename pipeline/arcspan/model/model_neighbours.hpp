// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_neighbours.hpp>
#include <arcspan/model/model_binary.hpp>
#include <arcspan/status.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

namespace model_binary {
/// The neighbours of a part's triangles (MeshNeighbours); number: the part's. Only models that were made with
/// `arcspan mesh --outlines` have them.
inline constexpr std::uint32_t kNeighboursTag = chunk_tag('N', 'B', 'R', 'S');
}  // namespace model_binary

/// Makes a view of the neighbours of part `i`, which must be below model.part_count(). They are checked by
/// this function, in time linear in the size of the part, and not by view_model_binary(), so that programs
/// without outlines do not contain the check. Returns:
///
///   kOk            `neighbours` is set; otherwise it is not changed
///   kUnsupported   the model was written without neighbours
///   others         those of MeshNeighbours::make()
[[nodiscard]] Status view_neighbours(const StoredModel& model, std::size_t i, MeshNeighbours& neighbours);

}  // namespace arcspan
