// SPDX-License-Identifier: MIT
// The choice of a display, of its mode and of the rows of its buffers, from what a DRM driver reports.
#pragma once

#include <arcspan/linux_host/result.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan::linux_host::drm {

/// A mode of a connector, in the order in which the driver lists them.
struct Mode {
  std::int32_t width = 0;
  std::int32_t height = 0;
  bool preferred = false;  ///< by the display, e.g. because it is its number of pixels
};

/// Index of the mode to use: the first that is preferred, else the first of those with most pixels. `modes`
/// must not be empty.
[[nodiscard]] std::size_t choose_mode(std::span<const Mode> modes);

/// A connector of a graphics card.
struct Connector {
  bool connected = false;            ///< to a display with at least one mode
  std::uint32_t crtc = 0;            ///< identifier of the CRTC whose picture it shows; 0: none
  std::uint32_t possible_crtcs = 0;  ///< bit i: CRTC i of the card can drive it
};

/// Indices of a connector and of the CRTC that drives it.
struct Output {
  std::size_t connector = 0;
  std::size_t crtc = 0;
};

/// Chooses the first connected connector that shows a picture already, with its CRTC, else the first
/// connected one with a CRTC that drives no other connector. `crtcs` are the identifiers of the card's CRTCs.
/// kNotReady if no display is connected; kBusy if no CRTC is left for one.
Result choose_output(std::span<const Connector> connectors, std::span<const std::uint32_t> crtcs,
                     Output& output);

/// Checks the memory that a driver made for `width` x `height` pixels of `bits` (16 or 32) bits, and sets
/// `stride` to the pixels from one row to the next. kUnsupported if `pitch`, the bytes from one row to the
/// next, is not a number of pixels or is too small, or if `size` bytes do not hold the rows.
Result find_stride(std::uint32_t width, std::uint32_t height, std::uint32_t bits, std::uint32_t pitch,
                   std::uint64_t size, std::int32_t& stride);

}  // namespace arcspan::linux_host::drm
