// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// Which pixels a DepthMode draws. Two passes over the same triangles give equal depths with one method, or
/// with two if both lack DrawFeatures::small_triangles: that rounds depths differently, for triangles that
/// depend on the method.
enum class DepthCompare : std::uint8_t {
  kNearer,         ///< those nearer than what is there, as a DepthBuffer itself
  kNearerOrEqual,  ///< also those as near: a second layer on the same surface
  kEqual,          ///< those as near, no others: a second pass over triangles that were drawn before
  kFarther,        ///< those behind what is there: outlines of hidden parts
  kAlways,         ///< all
};

/// A depth buffer with another test, or without writing: transparent surfaces test, but do not write. It
/// refers to a buffer, which must outlive it.
template <DepthCompare Compare, bool Writes>
class DepthMode {
 public:
  static constexpr bool kIsDepthMode = true;
  static constexpr bool kTests = true;
  static constexpr bool kWrites = Writes;
  [[nodiscard]] ARCSPAN_INLINE static constexpr bool passes(std::uint16_t depth, std::uint16_t stored) {
    if constexpr (Compare == DepthCompare::kNearer) return is_nearer(depth, stored);
    if constexpr (Compare == DepthCompare::kNearerOrEqual) return depth <= stored;
    if constexpr (Compare == DepthCompare::kEqual) return depth == stored;
    if constexpr (Compare == DepthCompare::kFarther) return depth > stored;
    return true;
  }

  constexpr explicit DepthMode(const DepthBuffer& buffer) : buffer_(&buffer) {}
  [[nodiscard]] constexpr Status status() const { return buffer_->status(); }
  [[nodiscard]] constexpr Rect bounds() const { return buffer_->bounds(); }
  [[nodiscard]] constexpr std::uint16_t* row(std::int32_t y) const { return buffer_->row(y); }
  [[nodiscard]] constexpr std::int32_t stride() const { return buffer_->stride(); }
  constexpr void check_cleared() const { buffer_->check_cleared(); }
  /// The same test without writing.
  [[nodiscard]] constexpr DepthMode<Compare, false> read_only() const {
    return DepthMode<Compare, false>(*buffer_);
  }

 private:
  const DepthBuffer* buffer_;
};

/// Tests against a depth buffer without writing to it: for transparent surfaces.
using ReadOnlyDepth = DepthMode<DepthCompare::kNearer, false>;

static_assert(DepthTarget<ReadOnlyDepth>);

namespace detail {

/// The same test without writing.
[[nodiscard]] constexpr ReadOnlyDepth read_only(const DepthBuffer& depth) { return ReadOnlyDepth(depth); }
template <DepthCompare Compare, bool Writes>
[[nodiscard]] constexpr DepthMode<Compare, false> read_only(const DepthMode<Compare, Writes>& depth) {
  return depth.read_only();
}

}  // namespace detail

}  // namespace arcspan
