// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/panel/custom_dcs_panel.hpp>
#include <arcspan/hal/panel/ili9341.hpp>
#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/hal/panel/ssd0323.hpp>
#include <arcspan/hal/panel/ssd1306.hpp>
#include <arcspan/hal/panel/ssd1351.hpp>
#include <arcspan/hal/panel/st7789.hpp>
#include <arcspan/hal/sim/dcs_model.hpp>
#include <arcspan/hal/sim/simulated_bus.hpp>
#include <arcspan/hal/sim/ssd0323_model.hpp>
#include <arcspan/hal/sim/ssd1306_model.hpp>
#include <arcspan/hal/sim/ssd1351_model.hpp>

#include <string>
#include <vector>

/// Panels with their simulated device, one struct each, for the tests that every panel has to pass.
namespace arcspan::hal::bench {

inline constexpr std::uint64_t kHertz = 20'000'000;

template <class PanelType, class Model>
struct SpiBench {
  explicit SpiBench(const Glass& glass, const PanelSettings& settings = {})
      : device(glass), panel(bus, bus.dc, &bus.reset, clock, glass, settings) {}
  using Driver = PanelType;
  static constexpr bool kPins = true;
  sim::SimulatedClock clock;
  Model device;
  sim::SimulatedSpi bus{device, clock, kHertz};
  PanelType panel;
  void lose_reset() { device.lose_reset_line(); }
};

template <class PanelType, class Model>
struct SolomonSpiBench {
  explicit SolomonSpiBench(const Glass& glass, const PanelSettings& settings = {})
      : device(glass), panel(port, &bus.reset, clock, glass, settings) {}
  using Driver = PanelType;
  static constexpr bool kPins = true;
  sim::SimulatedClock clock;
  Model device;
  sim::SimulatedSpi bus{device, clock, kHertz};
  SolomonSpi port{bus, bus.dc};
  PanelType panel;
  void lose_reset() { device.lose_reset_line(); }
};

struct Ili9341Bench : SpiBench<Ili9341, sim::DcsModel> {
  explicit Ili9341Bench(const PanelSettings& s = {}, const Glass& g = kIli9341Module) : SpiBench(g, s) {}
};
/// A glass that lies in the middle of the memory, so that offsets count on both sides of every axis.
struct St7789Bench : SpiBench<St7789, sim::DcsModel> {
  explicit St7789Bench(const PanelSettings& s = {},
                       const Glass& g = {135, 240, 52, 30, false, false, false, true})
      : SpiBench(g, s) {}
};
/// A controller of another size with commands of its own, and a glass at odd offsets, as of small modules.
struct CustomDcsBench {
  static constexpr std::uint8_t kCommands[] = {0xB4, 1, 0x07, 0xE3, 0, 0xE0, 4, 0x02, 0x1C, 0x07, 0x12};
  static constexpr DcsController kController{132, 162, kCommands};
  explicit CustomDcsBench(const PanelSettings& s = {},
                          const Glass& g = {128, 160, 2, 1, true, true, true, false})
      : device(g, kController), panel(bus, bus.dc, &bus.reset, clock, kController, g, s) {}
  using Driver = CustomDcsPanel;
  static constexpr bool kPins = true;
  sim::SimulatedClock clock;
  sim::DcsModel device;
  sim::SimulatedSpi bus{device, clock, kHertz};
  CustomDcsPanel panel;
  void lose_reset() { device.lose_reset_line(); }
};
struct Ssd1351Bench : SpiBench<Ssd1351, sim::Ssd1351Model> {
  explicit Ssd1351Bench(const PanelSettings& s = {}, const Glass& g = kSsd1351Module) : SpiBench(g, s) {}
};
/// A narrower one.
struct Ssd1351SmallBench : SpiBench<Ssd1351, sim::Ssd1351Model> {
  explicit Ssd1351SmallBench(const PanelSettings& s = {},
                             const Glass& g = {96, 64, 10, 0, true, false, false, false})
      : SpiBench(g, s) {}
};
struct Ssd0323Bench : SolomonSpiBench<Ssd0323, sim::Ssd0323Model> {
  explicit Ssd0323Bench(const PanelSettings& s = {}, const Glass& g = kSsd0323Module)
      : SolomonSpiBench(g, s) {}
};
/// A glass in the middle of the controller's rows and columns.
struct Ssd0323MiddleBench : SolomonSpiBench<Ssd0323, sim::Ssd0323Model> {
  explicit Ssd0323MiddleBench(const PanelSettings& s = {},
                              const Glass& g = {96, 48, 16, 12, true, false, false, false})
      : SolomonSpiBench(g, s) {}
};
struct Ssd1306Bench : SolomonSpiBench<Ssd1306, sim::Ssd1306Model> {
  explicit Ssd1306Bench(const PanelSettings& s = {}, const Glass& g = kSsd1306Module)
      : SolomonSpiBench(g, s) {}
};
/// The same controller on I2C, with a glass of 72 x 40 pixels in the middle.
struct Ssd1306I2cBench {
  explicit Ssd1306I2cBench(const PanelSettings& s = {},
                           const Glass& g = {72, 40, 28, 0, true, true, false, false})
      : device(g), panel(port, nullptr, clock, g, s) {}
  using Driver = Ssd1306;
  static constexpr bool kPins = false;
  sim::SimulatedClock clock;
  sim::Ssd1306Model device;
  sim::SimulatedI2c bus{device, SolomonI2c::kUsualAddress, clock, 400'000};
  SolomonI2c port{bus, SolomonI2c::kUsualAddress};
  Ssd1306 panel;
  void lose_reset() {}
};

/// What was complained about anywhere, joined.
template <class Bench>
std::string complaints(const Bench& bench) {
  std::string all;
  for (const auto* list : {&bench.device.complaints(), &bench.bus.complaints()}) {
    for (const std::string& line : *list) all += line + "; ";
  }
  return all;
}

template <class Bench>
using FrameOf = Framebuffer<typename Bench::Driver::Layout::Format>;

/// A picture of the panel's size, different in every pixel's neighbourhood and without symmetry.
template <class Bench>
struct Scene {
  using Format = typename Bench::Driver::Layout::Format;
  explicit Scene(const Panel& panel, unsigned seed = 1)
      : memory(FrameOf<Bench>::words(panel.width(), panel.height())),
        frame(memory, panel.width(), panel.height()) {
    paint(frame, seed);
  }
  static void paint(FrameOf<Bench>& band, unsigned seed) {
    for (std::int32_t y = band.bounds().top; y < band.bounds().bottom; ++y) {
      for (std::int32_t x = 0; x < band.bounds().right; ++x) {
        std::uint32_t h = (static_cast<unsigned>(x) * 73856093u) ^ (static_cast<unsigned>(y) * 19349663u) ^
                          (seed * 83492791u);
        h = (h ^ (h >> 13)) * 1274126177u;
        typename Format::Cursor(band.row(y), x)
            .write(Format::encode(Rgb8{static_cast<std::uint8_t>(h >> 8), static_cast<std::uint8_t>(h >> 16),
                                       static_cast<std::uint8_t>(h >> 24)}));
      }
    }
  }
  std::vector<typename Format::Word> memory;
  FrameOf<Bench> frame;
};

/// `frame` as it must look on the glass: turned clockwise by hand, from the definition of an orientation.
template <class Frame>
sim::Picture expected(const Frame& frame, Orientation o) {
  const std::int32_t w = frame.bounds().width();
  const std::int32_t h = frame.bounds().height();
  const bool side = o == Orientation::k90 || o == Orientation::k270;
  sim::Picture p{side ? h : w, side ? w : h, {}};
  for (std::int32_t v = 0; v < p.height; ++v) {
    for (std::int32_t u = 0; u < p.width; ++u) {
      switch (o) {
        case Orientation::k0:
          p.pixels.push_back(frame.pixel(u, v));
          break;
        case Orientation::k90:
          p.pixels.push_back(frame.pixel(v, h - 1 - u));
          break;
        case Orientation::k180:
          p.pixels.push_back(frame.pixel(w - 1 - u, h - 1 - v));
          break;
        case Orientation::k270:
          p.pixels.push_back(frame.pixel(w - 1 - v, u));
          break;
      }
    }
  }
  return p;
}

template <class Bench>
Status send_whole(Bench& bench, const FrameOf<Bench>& frame) {
  std::vector<std::uint8_t> wire(4096);
  return send_area(bench.panel, frame, bench.panel.bounds(), wire);
}

}  // namespace arcspan::hal::bench
