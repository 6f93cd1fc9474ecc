// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/formats.hpp>
#include <arcspan/pixel/format.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// Where nothing is encoded beforehand.
struct NoCodes {
  template <class Object>
  constexpr explicit NoCodes(const Object&) {}
};

/// The pixel codes of an object's diffuse colours by the top 10 bits of N·L, so that nothing has to be
/// clamped or encoded: 2 KB on the stack of a draw call, for machines that have them.
template <class Format>
class CodeTable {
 public:
  using Code = typename Format::Code;

  template <class Object>
  constexpr explicit CodeTable(const Object& object) {
    constexpr int kDown = Unit::kFraction - 8;
    const Code unlit = Format::encode(object.diffuse_colour(Unit{}));
    const Code full = Format::encode(object.diffuse_colour(Unit::of(1.0)));
    for (std::int32_t i = 0; i < 256; ++i) {
      const auto at = static_cast<std::size_t>(i);
      codes_[at] = Format::encode(object.diffuse_colour(Unit::from_raw(i << kDown)));
      codes_[at + 256] = full;
      codes_[at + 512] = codes_[at + 768] = unlit;
    }
  }

  [[nodiscard]] constexpr Code operator[](Unit normal_light) const {
    return codes_[static_cast<std::uint32_t>(normal_light.raw()) >> 22];
  }

 private:
  std::array<Code, 1024> codes_;
};

/// Illuminations by one light, into formats of 16 bits whose code does not depend on the place.
template <class Object, class Format>
concept HasCodes = !Format::kDithers && sizeof(typename Format::Code) == 2 &&
                   requires(const Object& object, PackedRgb colour) {
  object.diffuse_colour(Unit{});
  Format::encode(colour);
};

template <class Object, class Format, bool Wanted>
struct CodesOf {
  using Type = NoCodes;
};
template <class Object, class Format>
requires HasCodes<Object, Format>
struct CodesOf<Object, Format, true> {
  using Type = CodeTable<Format>;
};

}  // namespace arcspan
