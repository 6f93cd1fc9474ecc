// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/texture/texture.hpp>

#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/image/rgba_image.hpp>

namespace arcspan::tools {

/// The islands of a texture, an atlas, are the parts that belong together: what connected triangles show, or
/// what is opaque without a gap. Where an island has less than two texels, mip levels mix it with its
/// neighbours. This is the least width and the least height of all, as parts of the texture; 1 for islands
/// that extend over all of it.
struct IslandSize {
  double width = 1;
  double height = 1;

  /// Includes further islands.
  void include(const IslandSize& other);
};

/// The islands of all triangles of a model that show this texture.
[[nodiscard]] IslandSize islands_of(const FixedModel& model, const FileTexture& texture);

/// The islands that are at least half opaque, as far as they have two texels at all: specks do not count.
[[nodiscard]] IslandSize islands_of(const RgbaImage& picture);

/// The number of levels, 1 to size.levels, in which islands have two texels in each direction. Points of a
/// texture usually lie in the middle of an island's outer texels, so that a texel is added.
[[nodiscard]] std::uint8_t levels_with_islands(const TextureSize& size, const IslandSize& least);

}  // namespace arcspan::tools
