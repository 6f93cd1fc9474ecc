// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/status.hpp>

#include <cstdint>
#include <span>

/// Mesh binaries as chunks of a model binary: without a checksum, because the file has one.
namespace arcspan::detail {

/// Checks a chunk at an even address as view_mesh_binary() checks a binary, without the checksum. The chunk's
/// header states its size. Returns kOk, kUnsupported, kCorrupted (also if the chunk is shorter or longer than
/// it states) or kIndexOutOfRange.
[[nodiscard]] Status check_mesh_chunk(std::span<const std::uint8_t> bytes);

/// The mesh of a chunk that check_mesh_chunk() has accepted, in constant time.
[[nodiscard]] MeshView mesh_of_chunk(const std::uint8_t* bytes);

}  // namespace arcspan::detail
