// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/compare/reference.hpp>

namespace arcspan::tools {

/// How far a picture is from the reference, over the pixels that the reference covers.
struct PictureError {
  /// Error of one channel against the unrounded reference, in 8-bit steps: half a step is what 8 bits must
  /// lose.
  double max = 0;
  double rms = 0;
  /// 20 log10(255 / rms) in dB.
  double psnr = 0;
  /// Structural similarity of the lumas, 1 at best (Wang, Bovik, Sheikh, Simoncelli 2004: Gaussian window of
  /// 11 x 11 with sigma 1.5, K1 = 0.01, K2 = 0.03), averaged over the covered pixels' windows.
  double ssim = 0;
  std::size_t pixels = 0;
};

/// `picture` has the reference's size and was drawn over `background`.
[[nodiscard]] PictureError picture_error(const Image& picture, const ReferencePicture& reference,
                                         Rgb8 background);

/// The largest error of the three channels at every pixel, in 8-bit steps; 0 where nothing was drawn.
[[nodiscard]] std::vector<double> error_map(const Image& picture, const ReferencePicture& reference);

}  // namespace arcspan::tools
