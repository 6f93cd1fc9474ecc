// SPDX-License-Identifier: MIT
// The bytes that tests/artefacts/drawing_jobs.cpp writes for cost_jobs.hpp: jobs one after the other, the
// last of them without vertices. A job is a head and the arrays of the pipeline's own types that have the
// same layout on all machines, which a ClipTransform has not.
#pragma once

#include <cstddef>
#include <cstdint>

namespace arcspan {

struct JobHead {
  std::uint32_t vertices = 0;
  std::uint32_t indices = 0;
  std::uint32_t planes = 0;
  std::uint32_t is_phong = 0;  ///< R·V instead of N·H
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t band_rows = 0;
  /// Log2 of its side | levels << 8 | fraction bits of points << 16 | opaque ones of 8 texels, or 0 for all,
  /// << 24; or 0.
  std::uint32_t texture = 0;
  std::uint32_t neighbours = 0;  ///< bytes of MeshNeighbours, or 0
  std::uint32_t outlines = 0;    ///< width of their ink | creases are inked << 8 | they are curved << 16
  std::uint32_t two_sided = 0;   ///< backs are drawn
};

/// True for `opaque` (1...8) of every 8 texels. `i` is the number of the texel among those of all levels.
constexpr bool is_opaque_texel(std::size_t i, std::uint32_t opaque) { return ((i ^ i >> 3) & 7) < opaque; }

/// The bytes of an array, so that the next one is aligned.
constexpr std::size_t padded(std::size_t bytes) { return (bytes + 7) / 8 * 8; }

}  // namespace arcspan
