// SPDX-License-Identifier: MIT
#include <arcspan/hal/panel/ili9341.hpp>
#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/hal/panel/ssd0323.hpp>
#include <arcspan/hal/panel/ssd1306.hpp>
#include <arcspan/hal/panel/ssd1351.hpp>
#include <arcspan/hal/panel/st7789.hpp>

#include <arcspan_tools/render/pixel_format_name.hpp>
#include <arcspan_tools/show/panel_display.hpp>
#include <arcspan_tools/show/panel_wires.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <vector>

namespace arcspan::tools {
namespace {

using namespace hal;

/// A driver on its bus, in one struct for each way to wire one.
template <class DriverType>
struct OnSpi {
  using Driver = DriverType;
  OnSpi(PanelWires& wires, const PanelOptions&, const Glass& glass, const PanelSettings& settings)
      : driver(wires.spi(), wires.data_or_command(), wires.reset(), wires.clock(), glass, settings) {}
  Driver driver;
};

template <class DriverType>
struct OnSolomonSpi {
  using Driver = DriverType;
  OnSolomonSpi(PanelWires& wires, const PanelOptions&, const Glass& glass, const PanelSettings& settings)
      : port(wires.spi(), wires.data_or_command()),
        driver(port, wires.reset(), wires.clock(), glass, settings) {}
  SolomonSpi port;
  Driver driver;
};

struct Ssd1306OnI2c {
  using Driver = Ssd1306;
  Ssd1306OnI2c(PanelWires& wires, const PanelOptions& options, const Glass& glass,
               const PanelSettings& settings)
      : port(wires.i2c(), static_cast<std::uint8_t>(options.i2c_address)),
        driver(port, wires.reset(), wires.clock(), glass, settings) {}
  SolomonI2c port;
  Ssd1306 driver;
};

PanelSettings settings_of(const PanelOptions& options) {
  return {.orientation = static_cast<Orientation>(options.rotation / 90), .inverted = options.inverted};
}

template <class Wired>
class PanelDisplay final : public Display {
 public:
  using Driver = typename Wired::Driver;
  using Format = typename Driver::Layout::Format;
  using Frame = Framebuffer<Format>;

  PanelDisplay(const char* name, const PanelOptions& options, const Glass& glass)
      : wires_(options),
        wired_(wires_, options, glass, settings_of(options)),
        memory_(Frame::words(panel().width(), panel().height())),
        frame_(memory_, panel().width(), panel().height()),
        // Twice, so that a frame is one window.
        wire_(2 * wire_bytes<Driver>(panel().width(), panel().height())),
        description_(std::string("panel ") + name + " at " + options.bus()) {}
  // Not in the constructor: what fails here must put the panel to sleep, too.
  void start() {
    started_ = true;
    wires_.check(panel().start());
    // The controller's memory holds noise after power-on.
    frame_.clear({0, 0, 0});
    wires_.check(send_area(panel(), frame_, frame_.bounds(), wire_));
  }
  ~PanelDisplay() override {
    if (!started_) return;
    // One that could not be started may be on; only a start that is whole makes sure that it understands.
    if (!panel().awake()) (void)panel().start();
    (void)panel().sleep();
  }
  PanelDisplay(const PanelDisplay&) = delete;
  PanelDisplay& operator=(const PanelDisplay&) = delete;

  [[nodiscard]] Size size() const override { return {frame_.bounds().width(), frame_.bounds().height()}; }
  [[nodiscard]] std::string format() const override { return std::string(pixel_format_name<Format>()); }
  [[nodiscard]] std::string description() const override { return description_; }

  void show(const Image& image) override {
    const std::int32_t left = (size().width - image.width) / 2;
    const std::int32_t top = (size().height - image.height) / 2;
    for (std::int32_t y = 0; y < image.height; ++y) {
      typename Format::Cursor cursor(frame_.row(top + y), left);
      for (std::int32_t x = 0; x < image.width; ++x, cursor.next()) {
        cursor.write(Format::encode(image.at(x, y)));
      }
    }
    wires_.check(send_area(panel(), frame_, {left, top, left + image.width, top + image.height}, wire_));
    wires_.light(true);  // not before there is something to see
  }

  void finish() override {
    started_ = false;
    wires_.check(panel().sleep());
    wires_.light(false);
  }

 private:
  [[nodiscard]] Driver& panel() { return wired_.driver; }

  PanelWires wires_;
  Wired wired_;
  std::vector<typename Format::Word> memory_;
  Frame frame_;
  std::vector<std::uint8_t> wire_;
  std::string description_;
  bool started_ = false;
};

struct KnownPanel {
  const char* name;
  Glass glass;
  std::unique_ptr<Display> (*on_spi)(const KnownPanel&, const PanelOptions&);
  std::unique_ptr<Display> (*on_i2c)(const KnownPanel&, const PanelOptions&);
};

template <class Wired>
std::unique_ptr<Display> open(const KnownPanel& panel, const PanelOptions& options) {
  auto display = std::make_unique<PanelDisplay<Wired>>(panel.name, options, panel.glass);
  display->start();
  return display;
}

constexpr KnownPanel kPanels[] = {
    {"ili9341", kIli9341Module, &open<OnSpi<Ili9341>>, nullptr},
    {"st7789", kSt7789Module, &open<OnSpi<St7789>>, nullptr},
    {"ssd1351", kSsd1351Module, &open<OnSpi<Ssd1351>>, nullptr},
    {"ssd1306", kSsd1306Module, &open<OnSolomonSpi<Ssd1306>>, &open<Ssd1306OnI2c>},
    {"ssd0323", kSsd0323Module, &open<OnSolomonSpi<Ssd0323>>, nullptr}};

}  // namespace

std::vector<std::string> panel_names() {
  std::vector<std::string> names;
  for (const KnownPanel& panel : kPanels) names.emplace_back(panel.name);
  return names;
}

std::unique_ptr<Display> open_panel_display(const std::string& name, const PanelOptions& options) {
  std::string names;
  for (const KnownPanel& panel : kPanels) {
    names += std::string(", ") + panel.name;
    if (panel.name != name) continue;
    const auto open_on = options.i2c.empty() ? panel.on_spi : panel.on_i2c;
    if (open_on == nullptr) throw Failure("--i2c", name + " is on SPI only");
    return open_on(panel, options);
  }
  throw Failure("--device", "expected /dev/..." + names + ", not '" + name + "'");
}

}  // namespace arcspan::tools
