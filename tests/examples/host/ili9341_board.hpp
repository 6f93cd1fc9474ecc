// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/panel/ili9341.hpp>
#include <arcspan/hal/sim/dcs_model.hpp>
#include <arcspan/hal/sim/simulated_bus.hpp>

#include <tests/examples/checked_spi.hpp>

#include <cstdio>
#include <cstdlib>

namespace arcspan {

/// A simulated panel. At the end it prints a summary, and writes the picture on the glass as a PPM to the
/// file that the environment variable ARCSPAN_GLASS names.
class Ili9341Board {
 public:
  Ili9341Board() = default;
  Ili9341Board(const Ili9341Board&) = delete;
  Ili9341Board& operator=(const Ili9341Board&) = delete;
  ~Ili9341Board() {
    std::printf("bytes: %u, hash: %u\n", static_cast<unsigned>(bus_.bytes()),
                static_cast<unsigned>(bus_.hash()));
    std::printf("complaints: %zu\n", model_.complaints().size() + wires_.complaints().size());
    const hal::sim::Picture picture = model_.picture();
    std::size_t lit = 0;
    for (const Rgb8& pixel : picture.pixels) lit += pixel.g > 60 ? 1 : 0;
    std::printf("lit pixels: %zu\n", lit);
    if (const char* const path = std::getenv("ARCSPAN_GLASS")) write(picture, path);
  }

  Status start() { return panel_.start(); }
  [[nodiscard]] hal::Ili9341& panel() { return panel_; }

 private:
  static void write(const hal::sim::Picture& picture, const char* path) {
    std::FILE* const file = std::fopen(path, "wb");
    if (file == nullptr) return;
    std::fprintf(file, "P6\n%d %d\n255\n", static_cast<int>(picture.width), static_cast<int>(picture.height));
    for (const Rgb8& c : picture.pixels) std::fprintf(file, "%c%c%c", c.r, c.g, c.b);
    std::fclose(file);
  }

  hal::sim::SimulatedClock clock_;
  hal::sim::DcsModel model_{hal::kIli9341Module};
  hal::sim::SimulatedSpi wires_{model_, clock_, 20'000'000};
  example::CheckedSpi bus_{&wires_};
  hal::Ili9341 panel_{bus_, wires_.dc, &wires_.reset, clock_};
};

}  // namespace arcspan
