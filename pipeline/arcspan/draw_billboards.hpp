// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/check_call.hpp>
#include <arcspan/draw/scissor.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/textured/textured.hpp>
#include <arcspan/span/draw_command.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <concepts>
#include <cstdint>
#include <span>
#include <type_traits>

namespace arcspan {

/// The size of a billboard, in space or on the screen. Both are cut off at 65535 units and 2047 pixels.
struct BillboardSize {
  enum class Unit : std::uint8_t {
    kObject,  ///< units of the object space, so that farther ones are smaller
    kPixel
  };
  std::uint16_t width = 0;
  std::uint16_t height = 0;
  Unit unit = Unit::kObject;
};

/// A method that shows a texture without light: Textured<Unlit, ...>, with operations or without.
template <class M>
concept BillboardMethod = ShadingMethod<M> && sizeof(typename M::Vertex) == sizeof(MappedPoint) &&
                          std::is_empty_v<typename M::Face>&& requires(typename M::Vertex& vertex) {
  { vertex.point } -> std::same_as<MappedPoint&>;
};

namespace detail {

/// A billboard along one axis of the screen: its sides in clip space, and where the texture is there, 16
/// fraction bits.
struct BillboardSides {
  // Errors of interpolation must not lead beyond the texture, where it repeats.
  static constexpr std::int32_t kInset = 8;

  std::int32_t begin;
  std::int32_t end;
  std::int32_t texture_begin = kInset;
  std::int32_t texture_end = (std::int32_t{1} << 16) - kInset;

  /// Cuts off what is beyond the guard band, -w ... w. Returns false if nothing is left.
  [[nodiscard]] constexpr bool clip(std::int32_t w) {
    if (begin >= w || end <= -w) return false;
    const std::int32_t before = begin < -w ? texture_at(-w - begin) : texture_begin;
    const std::int32_t behind = end > w ? texture_at(w - begin) : texture_end;
    texture_begin = before;
    texture_end = behind;
    if (begin < -w) begin = -w;
    if (end > w) end = w;
    return true;
  }

 private:
  /// The place in the texture at a distance behind `begin`.
  [[nodiscard]] ARCSPAN_COLD constexpr std::int32_t texture_at(std::int32_t distance) const {
    const WideReciprocal inverse = wide_reciprocal(static_cast<std::uint32_t>(end - begin));
    const auto part = static_cast<std::int64_t>(
        (std::uint64_t{static_cast<std::uint32_t>(distance)} * inverse.mantissa) >> (inverse.exponent - 16));
    return texture_begin + static_cast<std::int32_t>((part * (texture_end - texture_begin)) >> 16);
  }
};

/// Draws billboards of one size.
template <BillboardMethod Method, PixelSink Sink, DepthTarget Depth>
class BillboardStage {
 public:
  BillboardStage(const ClipTransform& transform, const BillboardSize& size,
                 const typename Method::Lighting& lighting, Sink& sink, const Depth& depth)
      : transform_(transform),
        size_(size),
        scissor_(transform.viewport(), sink.bounds()),
        lighting_(lighting),
        sink_(sink),
        depth_(depth),
        status_(check_target(scissor_, sink, depth)) {
    check_call(lighting, depth);
  }

  [[nodiscard]] bool ready() const { return !scissor_.rect().empty() && ok(status_); }
  [[nodiscard]] Status status() const { return status_; }

  void draw(const ClipPosition& middle) {
    if (middle.w < transform_.w_range().nearest || middle.w > transform_.w_range().farthest) return;
    const std::int32_t across = half(size_.width, middle.w);
    const std::int32_t down = half(size_.height, middle.w);
    BillboardSides columns{middle.x - across, middle.x + across};
    BillboardSides rows{middle.y - down, middle.y + down};
    if (!columns.clip(middle.w) || !rows.clip(middle.w)) return;
    const auto corner = [&](std::int32_t x, std::int32_t u, std::int32_t y, std::int32_t v) {
      RasterVertex<Method> vertex;
      place_on_screen({x, y, middle.w}, transform_, vertex);
      vertex.shade.point = {u, v};
      return vertex;
    };
    draw(corner(columns.begin, columns.texture_begin, rows.begin, rows.texture_begin),
         corner(columns.end, columns.texture_end, rows.begin, rows.texture_begin),
         corner(columns.begin, columns.texture_begin, rows.end, rows.texture_end));
  }

 private:
  /// Half of a side in clip space.
  [[nodiscard]] std::int32_t half(std::uint16_t side, std::int32_t w) const {
    if (size_.unit == BillboardSize::Unit::kObject) return transform_.scaled_across(side) >> 1;
    constexpr std::uint16_t kMost = 2 * kGuardBand - 1;
    return static_cast<std::int32_t>((std::int64_t{w} * (side < kMost ? side : kMost)) >> (kGuardBits + 1));
  }

  /// Draws a rectangle: as the triangle of its upper left half, whose right edge, which begins at the middle
  /// vertex, is moved to its right side.
  void draw(const RasterVertex<Method>& upper_left, const RasterVertex<Method>& upper_right,
            const RasterVertex<Method>& lower_left) {
    TriangleCommand<Method> command;
    if (!prepare_triangle<Method, Depth::kTests>(lighting_, upper_left, upper_right, lower_left, {},
                                                 scissor_.viewport_rows(), command)) {
      return;
    }
    const RasterPosition lower_right{upper_right.position.x, lower_left.position.y, 0};
    EdgeSetup side;
    make_edge_setup(upper_right.position, lower_right, command.first_row, side);
    make_edge_walk(side, upper_right.position, lower_right, command.lower);
    status_ = draw_command<Method>(command, scissor_.origin(), scissor_.rect(), lighting_, sink_, depth_);
  }

  const ClipTransform& transform_;
  const BillboardSize size_;
  const Scissor scissor_;
  const typename Method::Lighting& lighting_;
  Sink& sink_;
  const Depth& depth_;
  Status status_;
};

}  // namespace detail

/// Draws the same picture at several places: rectangles that face the camera, upright on the screen, each
/// with the depth of its middle. They are tested against `depth` and clipped at the borders of the picture;
/// texels with an alpha below one half are not drawn, unless an operation blends them. Trees, sparks, signs,
/// smoke:
///
///     using Tree = Textured<Unlit, Palette8Texels<Alpha1Colour>>;
///     draw_billboards<Tree>(places, {900, 1400}, transform, Tree::Lighting(PackedRgb{}, texture), frame,
///     depth);
///
/// With TextureFilter::kBilinear take TextureBorders::kOfTexture and a texture that is clamped, or opposite
/// borders of it are mixed.
///
/// `middles` are in object space; a whole billboard disappears when its middle passes one of the
/// planes. Returns a status as draw_lines() does.
template <BillboardMethod Method, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] ARCSPAN_OUTLINE Status draw_billboards(std::span<const ObjectPosition> middles,
                                                     const BillboardSize& size,
                                                     const ClipTransform& transform,
                                                     const typename Method::Lighting& lighting, Sink& sink,
                                                     const Depth& depth) {
  detail::BillboardStage<Method, Sink, Depth> stage(transform, size, lighting, sink, depth);
  for (std::size_t i = 0; i < middles.size() && stage.ready(); ++i) stage.draw(transform(middles[i]));
  return stage.status();
}

}  // namespace arcspan
