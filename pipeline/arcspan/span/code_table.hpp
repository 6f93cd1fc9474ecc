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
    const auto& ramp = object.ramp();
    for (std::size_t i = 0; i < 256; ++i) codes_[i] = Format::encode(ramp[i]);
    for (std::size_t i = 256; i < 512; ++i) codes_[i] = codes_[255];
    for (std::size_t i = 512; i < 1024; ++i) codes_[i] = codes_[0];
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
  using Type = CodeTable<Format>;
};

}  // namespace arcspan
