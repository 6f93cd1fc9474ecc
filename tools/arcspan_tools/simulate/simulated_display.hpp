// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/sim/simulated_bus.hpp>

#include <arcspan_tools/command/glass_options.hpp>
#include <arcspan_tools/image/image.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace arcspan::tools {

struct DisplayOptions {
  PanelModule module;
  bool i2c = false;         ///< an SSD1306 on I2C
  std::uint64_t hertz = 1;  ///< of the bus, 1 or more
  std::int32_t band_rows = 8;
  bool changes_only = false;  ///< send what changed since the last frame, not all of it
};

/// A panel driver with its bus and a model of its controller: `arcspan simulate` sends pictures through it.
/// Everything on the way is the code that runs on a board, except the bus and the glass.
class SimulatedDisplay {
 public:
  SimulatedDisplay() = default;
  SimulatedDisplay(const SimulatedDisplay&) = delete;
  SimulatedDisplay& operator=(const SimulatedDisplay&) = delete;
  virtual ~SimulatedDisplay() = default;

  /// Starts the panel. Throws Failure.
  virtual void start() = 0;
  /// Sends a picture of size() in page mode, on a processor that takes `draw_ns` to draw it. `background` is
  /// the colour of what was not drawn. Throws Failure, also for anything that the model complains about.
  virtual void show(const Image& picture, Rgb8 background, std::uint64_t draw_ns) = 0;

  /// Of the picture, in the orientation asked for.
  [[nodiscard]] virtual Size size() const = 0;
  /// The pixel format that it is drawn in.
  [[nodiscard]] virtual std::string format() const = 0;
  /// The picture on the glass.
  [[nodiscard]] virtual Image picture() const = 0;
  [[nodiscard]] virtual hal::sim::BusCount count() const = 0;
  [[nodiscard]] virtual std::uint64_t now_ns() const = 0;
  /// Of the band that is drawn and of the one that is sent.
  [[nodiscard]] virtual std::size_t buffer_bytes() const = 0;
  /// Size of a framebuffer that holds a whole picture, in bytes.
  [[nodiscard]] virtual std::size_t frame_bytes() const = 0;
};

/// Throws Failure if the panel has no such bus.
[[nodiscard]] std::unique_ptr<SimulatedDisplay> make_display(const DisplayOptions& options);

}  // namespace arcspan::tools
