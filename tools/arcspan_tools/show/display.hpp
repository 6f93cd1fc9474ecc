// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/image/image.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <string>

namespace arcspan::tools {

/// A display of this machine. The destructor leaves it as `finish` does, without telling what went wrong.
class Display {
 public:
  virtual ~Display() = default;
  /// Its pixels.
  [[nodiscard]] virtual Size size() const = 0;
  /// The pipeline's pixel format that it shows without loss, e.g. "rgb565".
  [[nodiscard]] virtual std::string format() const = 0;
  /// A description in a few words.
  [[nodiscard]] virtual std::string description() const = 0;
  /// Shows `image` in the display's middle, which must hold it. Throws Failure.
  virtual void show(const Image& image) = 0;
  /// Leaves the display as it was found, or dark and asleep, and gives back what was taken for it. Throws
  /// Failure.
  virtual void finish() = 0;
};

}  // namespace arcspan::tools
