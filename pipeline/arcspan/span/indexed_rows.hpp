// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>
#include <arcspan/target.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>

/// One index for the pixels and the depths of a row.
namespace arcspan::detail {

/// True if the pixels and the depths of a row are arrays that one index can serve. Where it would have to be
/// added to each address, two pointers take an instruction less per pixel.
template <class Target>
concept IndexedRows = kHasManyRegisters && kScalesIndices && bool{Target::Depth::kTests} &&
                      requires(typename Target::Format::Cursor cursor) {
  cursor.pixels();
};

/// True if the pixels of `Run` have several scalars.
template <class Run>
concept HasSeveralScalars = requires {
  requires(Run::kUsed > 1);
};

/// True if the pixels of `Run` have scalars, so that their colours differ.
template <class Run>
concept HasScalars = requires {
  requires(Run::kUsed > 0);
};

/// True if the pixels of `Run` are encoded by Format::encode_varying().
template <class Format, class Run, class Lighting>
inline constexpr bool kEncodesVarying = HasScalars<Run> && !Format::kDithers &&
                                        requires(const Run& run, const Lighting& lighting, PackedRgb colour) {
  { run.colour(lighting) } -> std::same_as<PackedRgb>;
  Format::encode_varying(colour);
};

/// The bits that the index of indexed rows has below the number of a pixel: 1 if it counts bytes, which
/// pixels as large as depths allow. It costs a shift per row. That pays in runs of several scalars: gcc keeps
/// the scaled index in a register, which these lack.
template <class Format, class Run>
inline constexpr int kIndexShift = sizeof(typename Format::Encoded) == sizeof(std::uint16_t) &&
                                           !kHasWideRegisters && HasSeveralScalars<Run>
                                       ? 1
                                       : 0;

/// Returns the address of base[index >> Shift].
template <int Shift, class T>
[[nodiscard]] ARCSPAN_INLINE constexpr T* at_index(T* base, std::ptrdiff_t index) {
  if constexpr (Shift == 0) {
    return base + index;
  } else {
    static_assert(sizeof(T) == 1 << Shift);
    return static_cast<T*>(static_cast<void*>(static_cast<char*>(static_cast<void*>(base)) + index));
  }
}

}  // namespace arcspan::detail
