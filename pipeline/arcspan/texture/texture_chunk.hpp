// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/status.hpp>
#include <arcspan/texture/texture_binary.hpp>

#include <cstdint>
#include <span>

/// Texture binaries as chunks of a model binary: without a checksum, because the file has one.
namespace arcspan::detail {

/// Checks a chunk at an even address as view_texture_binary() checks a binary, without the checksum. The
/// chunk's header states its size. Returns kOk, kUnsupported or kCorrupted (also if the chunk is shorter or
/// longer than it states).
[[nodiscard]] Status check_texture_chunk(std::span<const std::uint8_t> bytes);

/// The texture of a chunk that check_texture_chunk() has accepted, in constant time.
[[nodiscard]] StoredTexture texture_of_chunk(const std::uint8_t* bytes);

}  // namespace arcspan::detail
