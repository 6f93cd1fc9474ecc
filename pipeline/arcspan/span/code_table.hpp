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

/// The pixel codes of an object's diffuse colours by N·L, on the stack of a draw call, so that no pixel
/// encodes any. `Size` is 256, by the ramp's own index (512 bytes), or 1024, by the top 10 bits of N·L, so that
/// nothing has to be clamped either (2 KB).
template <class Format, std::size_t Size>
class CodeTable {
 public:
  using Code = typename Format::Code;
  static_assert(Size == 256 || Size == 1024);
  /// Whether runs with highlights take the codes of their other pixels from here too: one more address to hold.
  static constexpr bool kForHighlights = Size == 1024;

  template <class Object>
  constexpr explicit CodeTable(const Object& object) {
    const auto& ramp = object.ramp();
    for (std::size_t i = 0; i < 256; ++i) codes_[i] = Format::encode(ramp[i]);
    for (std::size_t i = 256; i < Size / 2; ++i) codes_[i] = codes_[255];
    for (std::size_t i = Size / 2; Size > 256 && i < Size; ++i) codes_[i] = codes_[0];
  }

  [[nodiscard]] constexpr Code operator[](Unit normal_light) const {
    if constexpr (Size == 256) return codes_[static_cast<std::size_t>(clamped_byte(normal_light.raw() >> 22))];
    return codes_[static_cast<std::uint32_t>(normal_light.raw()) >> 22];
  }

 private:
  std::array<Code, Size> codes_;
};

/// Illuminations by one light, into formats of 16 bits whose code does not depend on the place.
template <class Object, class Format>
concept HasCodes = !Format::kDithers && sizeof(typename Format::Code) == 2 &&
                   requires(const Object& object, PackedRgb colour) {
  object.ramp();
  Format::encode(colour);
};

/// The table that a method's runs take their codes from: none, unless they use one (kUsesCodes) and `Lanes`
/// says that the machine fills it many entries at a time.
template <class Method, class Format, bool Lanes>
struct CodesOf {
  using Type = NoCodes;
};
/// A table, for methods that take one.
template <class Method, class Format>
requires(bool{Method::kUsesCodes} &&
         HasCodes<typename Method::Object, Format>) struct CodesOf<Method, Format, true> {
  using Type = CodeTable<Format, 256>;
};

}  // namespace arcspan
