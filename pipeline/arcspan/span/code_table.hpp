// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/pixel/format.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

// The entries of the table that a draw call makes of an object's diffuse pixel codes (CodeTable): 1024 on
// hosts with 128-bit vectors, which fill it many at a time, 256 elsewhere (512 bytes of stack), none on the
// AVR. Define ARCSPAN_CODE_TABLE to choose (0, 256 or 1024), the same for the whole program. The pixels are
// the same.
#ifndef ARCSPAN_CODE_TABLE
#if defined(__SSE2__) || (defined(__aarch64__) && defined(__ARM_NEON))
#define ARCSPAN_CODE_TABLE 1024
#elif defined(__AVR__)
#define ARCSPAN_CODE_TABLE 0
#else
#define ARCSPAN_CODE_TABLE 256
#endif
#endif

namespace arcspan {

/// The entries for a sink: its own choice (kCodeTable) if it has one.
template <class Sink>
[[nodiscard]] consteval std::size_t code_table_size() {
  if constexpr (requires { Sink::kCodeTable; }) {
    return Sink::kCodeTable;
  } else {
    return ARCSPAN_CODE_TABLE;
  }
}

/// Where nothing is encoded beforehand.
struct NoCodes {
  template <class Object>
  constexpr explicit NoCodes(const Object&) {}
};

/// The pixel codes of an object's diffuse colours by N·L, on the stack of a draw call, so that no pixel
/// encodes any. `Size` is 256, by the ramp's own index (512 bytes), or 1024, by the top 10 bits of N·L, so
/// that nothing has to be clamped either (2 KB).
template <class Format, std::size_t Size>
class CodeTable {
 public:
  using Code = typename Format::Code;
  static_assert(Size == 256 || Size == 1024);
  /// Whether runs with highlights take the codes of their other pixels from here too: one more address to
  /// hold.
  static constexpr bool kForHighlights = Size == 1024;

  template <class Object>
  constexpr explicit CodeTable(const Object& object) {
    const auto& ramp = object.ramp();
    for (std::size_t i = 0; i < 256; ++i) codes_[i] = Format::encode(ramp[i]);
    for (std::size_t i = 256; i < Size / 2; ++i) codes_[i] = codes_[255];
    for (std::size_t i = Size / 2; Size > 256 && i < Size; ++i) codes_[i] = codes_[0];
  }

  [[nodiscard]] constexpr Code operator[](Unit normal_light) const {
    if constexpr (Size == 256)
      return codes_[static_cast<std::size_t>(clamped_byte(normal_light.raw() >> 22))];
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

/// The table that a method's runs take their codes from: none, unless they use one (kUsesCodes) and it has a
/// size.
template <class Method, class Format, std::size_t Size>
struct CodesOf {
  using Type = NoCodes;
};
/// A table, for methods that take one.
template <class Method, class Format, std::size_t Size>
requires(Size != 0 && bool{Method::kUsesCodes} &&
         HasCodes<typename Method::Object, Format>) struct CodesOf<Method, Format, Size> {
  using Type = CodeTable<Format, Size>;
};

}  // namespace arcspan
