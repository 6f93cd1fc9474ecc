// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/image/image.hpp>

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace arcspan::tools {

/// At most 256 colours for a number of pictures.
class Palette {
 public:
  /// Every colour of the pictures if there are no more than 256, else a choice of them by median cut.
  explicit Palette(std::span<const Image> images);

  [[nodiscard]] const std::vector<Rgb8>& colours() const { return colours_; }
  /// The colour's index, or that of one of the nearest.
  [[nodiscard]] std::uint8_t index(Rgb8 colour);

 private:
  bool take_all(std::span<const Image> images);
  void choose(std::span<const Image> images);

  std::vector<Rgb8> colours_;
  std::unordered_map<std::uint32_t, std::uint8_t> known_;
};

}  // namespace arcspan::tools
