// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// The entries for a sink: its own choice (kEncodedColours) if it has one.
template <class Sink>
[[nodiscard]] consteval std::size_t encoded_colours_size() {
  if constexpr (requires { Sink::kEncodedColours; }) {
    return Sink::kEncodedColours;
  } else {
    return ARCSPAN_ENCODED_COLOURS;
  }
}

/// Where nothing is encoded beforehand.
struct NoEncodedColours {
  template <class Lighting>
  constexpr explicit NoEncodedColours(const Lighting&) {}
};

/// The pixel codes of an object's diffuse colours by N·L, on the stack of a draw call, so that no pixel
/// encodes any. `Size` is 256, by the ramp's own index (512 bytes), or 1024, by the top 10 bits of N·L, so
/// that nothing has to be clamped either (2 KB).
template <class Format, std::size_t Size>
class EncodedColourTable {
 public:
  using Encoded = typename Format::Encoded;
  static_assert(Size == 256 || Size == 1024);
  /// Whether runs with highlights take the codes of their other pixels from here too: one more address to
  /// hold.
  static constexpr bool kForHighlights = Size == 1024;

  template <class Lighting>
  constexpr explicit EncodedColourTable(const Lighting& lighting) {
    const auto& ramp = lighting.ramp();
    for (std::size_t i = 0; i < 256; ++i) encoded_colours_[i] = Format::encode(ramp[i]);
    for (std::size_t i = 256; i < Size / 2; ++i) encoded_colours_[i] = encoded_colours_[255];
    for (std::size_t i = Size / 2; Size > 256 && i < Size; ++i) encoded_colours_[i] = encoded_colours_[0];
  }

  [[nodiscard]] constexpr Encoded operator[](Cosine normal_light) const {
    if constexpr (Size == 256)
      return encoded_colours_[static_cast<std::size_t>(clamped_byte(normal_light.raw() >> 22))];
    return encoded_colours_[static_cast<std::uint32_t>(normal_light.raw()) >> 22];
  }

 private:
  std::array<Encoded, Size> encoded_colours_;
};

/// Illuminations by one light, into formats of 16 bits whose code does not depend on the place.
template <class Lighting, class Format>
concept HasEncodedColours = !Format::kDithers && sizeof(typename Format::Encoded) == 2 &&
                            requires(const Lighting& lighting, PackedRgb colour) {
  lighting.ramp();
  Format::encode(colour);
};

/// The table that a method's runs take their codes from: none, unless they use one (kUsesEncodedColours) and
/// it has a size.
template <class Method, class Format, std::size_t Size>
struct EncodedColoursOf {
  using Type = NoEncodedColours;
};
/// A table, for methods that take one.
template <class Method, class Format, std::size_t Size>
requires(Size != 0 && bool{Method::kUsesEncodedColours} &&
         HasEncodedColours<typename Method::Lighting, Format>) struct EncodedColoursOf<Method, Format, Size> {
  using Type = EncodedColourTable<Format, Size>;
};

}  // namespace arcspan
