// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/blended_alpha.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/dither.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/spread_rgb565.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

/// Operations change the colour of a pixel before it is stored: fog, then transparency. An operation is a
/// function object that takes a colour and returns a colour of another type, which has one of the optional
/// members of colour.hpp. If the operation depends on the position, it has in_row(x, y) instead,
/// which returns a function object for the run of pixels that begins there; its next() moves to the next
/// pixel. If it depends on the depth, it has a type Layer, whose enter() sets that function object for the
/// pixels of a layer of depths (Fogged). shading/with_operation.hpp adds an operation to a shading method.
namespace arcspan {

namespace detail {

/// The colour as PackedRgb, whatever its type.
template <class C>
[[nodiscard]] constexpr PackedRgb packed_colour(const C& c) {
  if constexpr (std::same_as<C, PackedRgb>)
    return c;
  else
    return c.packed();
}
/// The same as a pixel of 5-6-5 bits.
template <class C>
[[nodiscard]] constexpr std::uint16_t colour565(const C& c) {
  return encode_at<Rgb565>(c, 0, 0);
}

/// The colour whose channels are function(channel of a, channel of b), all 0...1023.
template <class Function>
[[nodiscard]] constexpr PackedRgb by_channel(PackedRgb a, PackedRgb b, const Function& function) {
  return PackedRgb::of(function((a.lanes >> 11) & 1023u, (b.lanes >> 11) & 1023u),
                       function(a.lanes >> 22, b.lanes >> 22), function(a.lanes & 1023u, b.lanes & 1023u));
}

}  // namespace detail

/// The base of an operation's result: the colour that the operation took, and its covers() if it has one.
template <class C>
struct WrappedColour {
  C colour;

  [[nodiscard]] constexpr bool covers(std::int32_t x, std::int32_t y) const requires MaskedColour<C> {
    return colour.covers(x, y);
  }
};

/// How a transparent surface is blended with the pixel that is there.
enum class Blend : std::uint8_t {
  kAlpha,    ///< mixed by the surface's opacity
  kAdd,      ///< the surface's colour times its opacity is added
  kMultiply  ///< the pixel is multiplied by the surface's colour, as seen through coloured glass
};

/// Blends a surface with what was drawn before it, by a constant opacity and by the alpha of its texels. It
/// is to be drawn after everything behind it, the farthest first, as draw_scene() does. kAdd and kMultiply
/// make pixels of Argb8888 opaque.
template <Blend Mode = Blend::kAlpha>
struct Opacity {
  std::uint32_t opacity = 32;  ///< 0...32

  /// A colour that is blended (BlendedColour).
  template <class C>
  struct Result : WrappedColour<C> {
    std::uint32_t opacity;  ///< 0...32

    [[nodiscard]] constexpr bool covers(std::int32_t x, std::int32_t y) const
        requires(MaskedColour<C> || AlphaColour<C>) {
      if constexpr (AlphaColour<C>) {
        return opacity != 0;
      } else {
        return this->colour.covers(x, y);
      }
    }
    /// The surface alone.
    [[nodiscard]] constexpr PackedRgb packed() const { return detail::packed_colour(this->colour); }
    [[nodiscard]] constexpr PackedRgb over(PackedRgb below) const {
      const PackedRgb above = detail::packed_colour(this->colour);
      return detail::by_channel(above, below, [this](std::uint32_t a, std::uint32_t b) {
        if constexpr (Mode == Blend::kAlpha) {
          return (a * opacity + b * (32 - opacity) + 16) >> 5;
        } else if constexpr (Mode == Blend::kAdd) {
          const std::uint32_t light = a < 2 ? 0 : a - 2;  // b has the half step already
          const std::uint32_t sum = ((light * opacity + 16) >> 5) + b;
          return sum > 1023 ? 1023u : sum;
        } else {
          // With opacity 0 the pixel stays as it is.
          const std::uint32_t product = (a * b + 511) / 1024;
          return (product * opacity + b * (32 - opacity) + 16) >> 5;
        }
      });
    }
    [[nodiscard]] ARCSPAN_INLINE constexpr std::uint16_t over565(std::uint16_t pixel) const {
      const std::uint32_t above = detail::spread(detail::colour565(this->colour));
      const std::uint32_t below = detail::spread(pixel);
      if constexpr (Mode == Blend::kAlpha) {
        // 32 - opacity is a constant of the loop, unless texels have alpha.
        if constexpr (AlphaColour<C>) return detail::joined(detail::mixed_spread(below, above, opacity));
        return detail::joined(detail::mixed_spread(below, 32 - opacity, above, opacity));
      } else if constexpr (Mode == Blend::kAdd) {
        return detail::joined(detail::saturated_sum(below, detail::scaled_spread(above, opacity)));
      } else {
        // 33 / 1024 is 1 / 31, 65 / 4096 is 1 / 63, both a little more.
        const std::uint32_t red = ((above >> 11 & 31u) * (below >> 11 & 31u) * 33u + 512u) >> 10;
        const std::uint32_t green = ((above >> 21) * (below >> 21) * 65u + 2048u) >> 12;
        const std::uint32_t blue = ((above & 31u) * (below & 31u) * 33u + 512u) >> 10;
        return detail::joined(detail::mixed_spread(below, (green << 21) | (red << 11) | blue, opacity));
      }
    }
    /// The surface `above` over a pixel that is not opaque, both 0xAARRGGBB.
    [[nodiscard]] constexpr std::uint32_t over_alpha(std::uint32_t above, std::uint32_t below) const
        requires(Mode == Blend::kAlpha) {
      return detail::blended_with_alpha(below, above, opacity);
    }
  };

  template <class C>
  [[nodiscard]] ARCSPAN_INLINE constexpr auto operator()(const C& colour) const {
    static_assert(!BlendedColour<C>, "a pixel is blended once: Opacity is the last operation");
    std::uint32_t share = opacity;
    if constexpr (AlphaColour<C>) share = (share * colour.alpha() + 8) >> 4;
    return Result<C>{{colour}, share};
  }
};

namespace detail {

/// Entry [n][y] has a bit for each of eight columns, the highest for column 0. It is set if the pixel of row
/// y is drawn when n / 8 of each block of 8x8 pixels are.
consteval std::array<std::array<std::uint8_t, 8>, 9> make_door_rows() {
  std::array<std::array<std::uint8_t, 8>, 9> rows{};
  for (std::size_t n = 0; n <= 8; ++n) {
    for (std::size_t at = 0; at < 64; ++at) {
      if (kDitherMatrix[at >> 3][at & 7] < 8 * n)
        rows[n][at >> 3] |= static_cast<std::uint8_t>(128u >> (at & 7));
    }
  }
  return rows;
}
inline constexpr auto kDoorRows = make_door_rows();

}  // namespace detail

/// Draws a share of a surface's pixels, in the pattern of kDitherMatrix: transparency that needs no order.
struct ScreenDoor {
  std::uint32_t opacity = 8;  ///< of 8 pixels; more is all

  /// A colour that is drawn in a share of the pixels (MaskedColour).
  template <class C>
  struct Result : WrappedColour<C> {
    bool drawn;

    [[nodiscard]] ARCSPAN_INLINE constexpr bool covers(std::int32_t x, std::int32_t y) const {
      if constexpr (MaskedColour<C>) {
        if (!this->colour.covers(x, y)) return false;
      }
      return drawn;
    }
    /// For an operation that blends: it looks at this instead of covers().
    [[nodiscard]] constexpr std::uint32_t alpha() const requires AlphaColour<C> {
      return drawn ? this->colour.alpha() : 0;
    }
    [[nodiscard]] constexpr PackedRgb packed() const { return detail::packed_colour(this->colour); }
    [[nodiscard]] constexpr std::uint16_t rgb565() const { return detail::colour565(this->colour); }
  };

  /// The pixels of a row.
  struct Row {
    std::uint32_t drawn;  ///< the highest bit is that of the current pixel, the next one that of the next

    template <class C>
    [[nodiscard]] ARCSPAN_INLINE constexpr auto operator()(const C& colour) const {
      static_assert(!BlendedColour<C>, "Opacity is the last operation");
      return Result<C>{{colour}, static_cast<std::int32_t>(drawn) < 0};
    }
    ARCSPAN_INLINE constexpr void next() { drawn = (drawn << 1) | (drawn >> 31); }
  };
  [[nodiscard]] ARCSPAN_INLINE constexpr Row in_row(std::int32_t x, std::int32_t y) const {
    const std::size_t row = static_cast<std::size_t>(y) & 7u;
    const std::uint32_t bits = detail::kDoorRows[opacity < 8 ? static_cast<std::size_t>(opacity) : 8u][row];
    const std::uint32_t four = bits * 0x01010101u;
    const auto column = static_cast<std::uint32_t>(x);
    return {(four << (column & 31u)) | (four >> ((0u - column) & 31u))};
  }
};

}  // namespace arcspan
