// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>

namespace arcspan {

/// Used where pixels are encoded one by one.
struct NoEncodedColours {
  template <class Lighting>
  constexpr void set(const Lighting&) {}
};

/// The diffuse colours of an object by N·L, encoded in `Format` once per draw call, so that no pixel encodes
/// any. Lies on the stack of the draw call. With `Size` 256 it has the entries of the illumination's ramp
/// (512 bytes); with 1024 it is indexed by the upper 10 bits of N·L, so that N·L needs no clamping (2 KB).
template <class Format, std::size_t Size>
class EncodedColourTable {
 public:
  using Encoded = typename Format::Encoded;
  static_assert(Size == 256 || Size == 1024);
  /// True if runs with a highlight use the table too, for their pixels outside the highlight. On small cores
  /// the address would take a register that they need for other things.
  static constexpr bool kForHighlights = Size == 1024;

  template <class Lighting>
  ARCSPAN_OUTLINE constexpr void set(const Lighting& lighting) {
    const auto& ramp = lighting.ramp();
    for (std::size_t i = 0; i < 256; ++i) colours_[i] = Format::encode(ramp[i]);
    for (std::size_t i = 256; i < Size / 2; ++i) colours_[i] = colours_[255];
    for (std::size_t i = Size / 2; Size > 256 && i < Size; ++i) colours_[i] = colours_[0];
  }

  [[nodiscard]] ARCSPAN_INLINE constexpr Encoded operator[](Cosine normal_light) const {
    if constexpr (Size == 256)
      return colours_[static_cast<std::size_t>(clamped_unsigned<8, 22>(normal_light.raw()))];
    return colours_[static_cast<std::uint32_t>(normal_light.raw()) >> 22];
  }

 private:
  std::array<Encoded, Size> colours_;
};

namespace detail {

/// True if the diffuse colours can be encoded in advance: one light, whose ramp has 256 entries, and a 16-bit
/// format without dithering.
template <class Lighting, class Format>
concept EncodableInAdvance = !Format::kDithers && sizeof(typename Format::Encoded) == 2 &&
                             requires(const Lighting& lighting, PackedRgb colour) {
  requires std::tuple_size_v<std::remove_cvref_t<decltype(lighting.ramp())>>
  == 256;
  Format::encode(colour);
};

/// The number of entries that a sink's table has, 0 for none.
template <class Sink>
[[nodiscard]] consteval std::size_t encoded_colours_size() {
  if constexpr (ChoosesEncodedColours<Sink>) {
    return Sink::kEncodedColours;
  } else {
    return ARCSPAN_ENCODED_COLOURS;
  }
}

template <class Method, class Sink, std::size_t Size = encoded_colours_size<Sink>()>
struct EncodedColoursType {
  using Type = NoEncodedColours;
};
template <class Method, class Sink, std::size_t Size>
requires(Size != 0 && UsesEncodedColours<Method> &&
         EncodableInAdvance<typename Method::Lighting,
                            typename Sink::Format>) struct EncodedColoursType<Method, Sink, Size> {
  using Type = EncodedColourTable<typename Sink::Format, Size>;
};

}  // namespace detail

/// The table of encoded colours that `Method` uses for `Sink`: an EncodedColourTable or NoEncodedColours.
template <class Method, class Sink>
using EncodedColoursFor = typename detail::EncodedColoursType<Method, Sink>::Type;

}  // namespace arcspan
