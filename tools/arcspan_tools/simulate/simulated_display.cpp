// SPDX-License-Identifier: MIT
#include <arcspan/hal/panel/ili9341.hpp>
#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/hal/panel/ssd0323.hpp>
#include <arcspan/hal/panel/ssd1306.hpp>
#include <arcspan/hal/panel/ssd1351.hpp>
#include <arcspan/hal/panel/st7789.hpp>
#include <arcspan/hal/sim/dcs_model.hpp>
#include <arcspan/hal/sim/ssd0323_model.hpp>
#include <arcspan/hal/sim/ssd1306_model.hpp>
#include <arcspan/hal/sim/ssd1351_model.hpp>

#include <arcspan_tools/render/pixel_format_name.hpp>
#include <arcspan_tools/simulate/simulated_display.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>

namespace arcspan::tools {
namespace {

using namespace hal;

/// Panels on SPI whose driver takes the bus itself.
template <class Driver, class Model>
struct PlainSpi {
  using Panel = Driver;
  PlainSpi(const PanelModule& module, std::uint64_t hertz)
      : device(module.glass),
        bus(device, clock, hertz),
        panel(bus, bus.dc, &bus.reset, clock, module.glass, module.settings) {}
  sim::SimulatedClock clock;
  Model device;
  sim::SimulatedSpi bus;
  Driver panel;
};

template <class Driver, class Model>
struct PortSpi {
  using Panel = Driver;
  template <class... Wiring>
  PortSpi(const PanelModule& module, std::uint64_t hertz, const Wiring&... wiring)
      : device(module.glass),
        bus(device, clock, hertz),
        port(bus, bus.dc),
        panel(port, &bus.reset, clock, module.glass, module.settings, wiring...) {}
  sim::SimulatedClock clock;
  Model device;
  sim::SimulatedSpi bus;
  SolomonSpi port;
  Driver panel;
};

struct SimulatedSsd1306OnSpi : PortSpi<Ssd1306, sim::Ssd1306Model> {
  SimulatedSsd1306OnSpi(const PanelModule& module, std::uint64_t hertz)
      : PortSpi(module, hertz, module.wiring) {}
};

struct SimulatedSsd1306OnI2c {
  using Panel = Ssd1306;
  SimulatedSsd1306OnI2c(const PanelModule& module, std::uint64_t hertz)
      : device(module.glass),
        bus(device, SolomonI2c::kUsualAddress, clock, hertz),
        port(bus, SolomonI2c::kUsualAddress),
        panel(port, nullptr, clock, module.glass, module.settings, module.wiring) {}
  sim::SimulatedClock clock;
  sim::Ssd1306Model device;
  sim::SimulatedI2c bus;
  SolomonI2c port;
  Ssd1306 panel;
};

void require_ok(const std::string& subject, Status status) {
  if (status == Status::kTimeout)
    throw Failure(subject,
                  "timeout: a band takes longer to send than the driver waits, 1 s; it needs fewer "
                  "rows or a faster bus");
  if (!ok(status)) throw Failure(subject, to_string(status));
}

template <class Wired>
class DisplayOf final : public SimulatedDisplay {
 public:
  using Driver = typename Wired::Panel;
  using Mode = PageMode<Driver>;
  using Frame = typename Mode::Frame;
  using Format = typename Frame::Format;

  explicit DisplayOf(const DisplayOptions& options)
      : options_(options),
        wired_(options.module, options.hertz),
        rows_(std::min(options.band_rows, wired_.panel.height())),
        band_(Frame::words(wired_.panel.width(), rows_)),
        wire_(wire_bytes<Driver>(wired_.panel.width(), rows_)),
        extents_(Damage::extents(wired_.panel.height())),
        damage_(extents_, wired_.panel.width(), wired_.panel.height()),
        mode_(wired_.panel, band_, wire_, rows_) {
    const std::int32_t step = Driver::Layout::row_step(options.module.settings.orientation);
    if (rows_ % step != 0) {
      throw Failure("--band", std::to_string(rows_) + " rows, but " + options.module.controller +
                                  " needs a multiple of " + std::to_string(step));
    }
  }

  void start() override {
    require_ok(options_.module.controller, wired_.panel.start());
    forbid_complaints();
  }

  void show(const Image& picture, Rgb8 background, std::uint64_t draw_ns) override {
    const auto height = static_cast<std::uint64_t>(picture.height);
    const auto draw = [&](auto& sink, Frame& band) {
      band.clear(background);
      copy(picture, background, sink);
      wired_.clock.advance_ns(draw_ns * static_cast<std::uint64_t>(band.bounds().height()) / height);
      return Status::kOk;
    };
    const Status status = options_.changes_only
                              ? mode_.show_changes(damage_, draw)
                              : mode_.show([&draw](Frame& band) { return draw(band, band); });
    require_ok(options_.module.controller, status);
    forbid_complaints();
  }

  [[nodiscard]] Size size() const override { return {wired_.panel.width(), wired_.panel.height()}; }
  [[nodiscard]] std::string format() const override { return std::string(pixel_format_name<Format>()); }
  [[nodiscard]] Image picture() const override {
    const sim::Picture shown = wired_.device.picture();
    Image image(shown.width, shown.height);
    image.pixels = shown.pixels;
    return image;
  }
  [[nodiscard]] sim::BusCount count() const override { return wired_.bus.count(); }
  [[nodiscard]] std::uint64_t now_ns() const override { return wired_.clock.now_ns(); }
  [[nodiscard]] std::size_t buffer_bytes() const override {
    return band_.size() * sizeof(band_[0]) + wire_.size() +
           (options_.changes_only ? extents_.size() * sizeof(RowExtent) : 0);
  }
  [[nodiscard]] std::size_t frame_bytes() const override {
    return Frame::words(wired_.panel.width(), wired_.panel.height()) * sizeof(typename Frame::Word);
  }

 private:
  /// The drawn pixels of the sink's rows, as one run each from the first to the last of them.
  template <class Sink>
  static void copy(const Image& picture, Rgb8 background, Sink& sink) {
    const Rgb8 ground = Format::decode(Format::encode(background));
    const Rect rows = sink.bounds();
    for (std::int32_t y = rows.top; y < rows.bottom; ++y) {
      std::int32_t left = 0;
      std::int32_t right = picture.width;
      while (left < right && picture.at(left, y) == ground) ++left;
      while (right > left && picture.at(right - 1, y) == ground) --right;
      if (left == right) continue;
      const Span run{y, left, right - left};
      typename Format::Cursor cursor = sink.open(run);
      for (std::int32_t x = left; x < right; ++x, cursor.next())
        cursor.write(Format::encode(picture.at(x, y)));
      (void)sink.close(run);
    }
  }

  void forbid_complaints() const {
    for (const auto* list : {&wired_.device.complaints(), &wired_.bus.complaints()}) {
      if (!list->empty())
        throw Failure(options_.module.controller, "the controller's model complains: " + list->front());
    }
  }

  DisplayOptions options_;
  Wired wired_;
  std::int32_t rows_;
  std::vector<typename Frame::Word> band_;
  std::vector<std::uint8_t> wire_;
  std::vector<RowExtent> extents_;
  Damage damage_;
  Mode mode_;
};

template <class Wired>
std::unique_ptr<SimulatedDisplay> make(const DisplayOptions& options) {
  return std::make_unique<DisplayOf<Wired>>(options);
}

struct SimulatedController {
  const char* name;
  std::unique_ptr<SimulatedDisplay> (*spi)(const DisplayOptions&);
  std::unique_ptr<SimulatedDisplay> (*i2c)(const DisplayOptions&);
};

constexpr SimulatedController kSimulated[] = {
    {"ili9341", &make<PlainSpi<Ili9341, sim::DcsModel>>, nullptr},
    {"st7789", &make<PlainSpi<St7789, sim::DcsModel>>, nullptr},
    {"ssd1351", &make<PlainSpi<Ssd1351, sim::Ssd1351Model>>, nullptr},
    {"ssd1306", &make<SimulatedSsd1306OnSpi>, &make<SimulatedSsd1306OnI2c>},
    {"ssd0323", &make<PortSpi<Ssd0323, sim::Ssd0323Model>>, nullptr}};

}  // namespace

std::unique_ptr<SimulatedDisplay> make_display(const DisplayOptions& options) {
  for (const SimulatedController& known : kSimulated) {
    if (options.module.controller != known.name) continue;
    const auto maker = options.i2c ? known.i2c : known.spi;
    if (maker == nullptr) throw Failure("--bus", options.module.controller + " is not simulated on I2C");
    return maker(options);
  }
  throw Failure("--panel", "no simulation of " + options.module.controller);
}

}  // namespace arcspan::tools
