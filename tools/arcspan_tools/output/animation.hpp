// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/image/image.hpp>

#include <cstdint>
#include <span>
#include <string>

namespace arcspan::tools {

/// The bytes of an animated GIF that repeats for ever. All frames have the size of the first, each side up to
/// 65,535; there is at least one. The frames share one palette: exact up to 256 colours, else the nearest of
/// 256 chosen by median cut. A frame stays for `milliseconds`, which GIF rounds to hundredths of a second;
/// what is rounded off is made up for later, so that the whole lasts as long as it should.
[[nodiscard]] std::string encode_gif(std::span<const Image> frames, std::int32_t milliseconds);

/// The same as an animated PNG (the APNG chunks of PNG's third edition, W3C 2025): every colour exact.
/// Programs that know no animation show the first frame. `milliseconds` up to 65,535.
[[nodiscard]] std::string encode_apng(std::span<const Image> frames, std::int32_t milliseconds);

}  // namespace arcspan::tools
