// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/sim/dcs_model.hpp>
#include <arcspan/hal/sim/simulated_bus.hpp>

#include <cstdio>
#include <cstdlib>

namespace arcspan::example {

/// A simulated panel of a controller with the command set DCS. report() also writes the picture on the glass
/// as a PPM to the file that the environment variable ARCSPAN_GLASS names.
struct SimulatedDevices {
  explicit SimulatedDevices(const hal::Glass& glass) : model(glass) {}

  hal::sim::SimulatedClock clock;
  hal::sim::DcsModel model;
  hal::sim::SimulatedSpi wires{model, clock, 20'000'000};
  hal::OutputPin& data_or_command = wires.dc;
  hal::OutputPin* reset = &wires.reset;
  hal::SpiBus* bus = &wires;

  void report(std::uint32_t bytes, std::uint32_t hash) const {
    std::printf("bytes: %u, hash: %u\n", static_cast<unsigned>(bytes), static_cast<unsigned>(hash));
    std::printf("complaints: %zu\n", model.complaints().size() + wires.complaints().size());
    const hal::sim::Picture picture = model.picture();
    std::size_t lit = 0;
    for (const Rgb8& pixel : picture.pixels) lit += pixel.g > 60 ? 1 : 0;
    std::printf("lit pixels: %zu\n", lit);
    if (const char* const path = std::getenv("ARCSPAN_GLASS")) write(picture, path);
  }

 private:
  static void write(const hal::sim::Picture& picture, const char* path) {
    std::FILE* const file = std::fopen(path, "wb");
    if (file == nullptr) return;
    std::fprintf(file, "P6\n%d %d\n255\n", static_cast<int>(picture.width), static_cast<int>(picture.height));
    for (const Rgb8& c : picture.pixels) std::fprintf(file, "%c%c%c", c.r, c.g, c.b);
    std::fclose(file);
  }
};

}  // namespace arcspan::example
