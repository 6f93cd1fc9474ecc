// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/counting/operation_counts.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan_counting {

/// A RenderJob as bytes. The counting pipeline is a second one, compiled under another name, whose types have
/// the same layout as the first one's but are others.
struct CountJob {
  std::span<const std::byte> positions;    ///< ObjectPosition...
  std::span<const std::byte> normals;      ///< PackedNormal...
  std::span<const std::byte> indices;      ///< uint16...
  std::span<const std::byte> planes;       ///< FacePlane..., or nothing
  std::span<const std::byte> plane_scale;  ///< PlaneScale of the planes
  std::span<const std::byte> transform;    ///< ClipTransform
  std::span<const std::byte> material;     ///< Material
  std::span<const std::byte> lights;       ///< DirectionalLight...
  std::span<const std::byte> to_eye;       ///< Direction
  bool phong_highlight = false;            ///< R·V instead of N·H
  bool two_sided = false;
  bool depth = true;     ///< with a depth test; otherwise every pixel passes it
  int segment_bits = 0;  ///< 2^bits pixels; 0: the usual length; negative: adaptive
  int tolerance = 1;     ///< of `arc`
  int band_rows = 0;     ///< rows of the bands that the picture is drawn in, 1 or more
};

/// The operations of drawing a picture.
struct CountedDraw {
  OperationCounts in_spans;  ///< between a run's start and its end: the pixels
  OperationCounts around;    ///< everything else: vertices, preparation, row starts
  std::uint64_t pixels = 0;
  std::uint64_t spans = 0;
  std::uint64_t triangles = 0;  ///< the sum of those that each band shows
};

using CountFunction = CountedDraw(const CountJob& job);

}  // namespace arcspan_counting
