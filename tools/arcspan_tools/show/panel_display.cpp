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
#include <arcspan_tools/support/text.hpp>

#include <algorithm>
#include <vector>

namespace arcspan::tools {
namespace {

using namespace hal;

/// A driver on its bus, in one struct for each way to wire one.
template <class DriverType>
struct OnSpi {
  using Driver = DriverType;
  OnSpi(PanelWires& wires, const PanelOptions&, const PanelModule& module)
      : driver(wires.spi(), wires.data_or_command(), wires.reset(), wires.clock(), module.glass,
               module.settings) {}
  Driver driver;
};

template <class DriverType>
struct OnSolomonSpi {
  using Driver = DriverType;
  template <class... Wiring>
  OnSolomonSpi(PanelWires& wires, const PanelModule& module, const Wiring&... wiring)
      : port(wires.spi(), wires.data_or_command()),
        driver(port, wires.reset(), wires.clock(), module.glass, module.settings, wiring...) {}
  SolomonSpi port;
  Driver driver;
};

struct Ssd0323OnSpi : OnSolomonSpi<Ssd0323> {
  Ssd0323OnSpi(PanelWires& wires, const PanelOptions&, const PanelModule& module)
      : OnSolomonSpi(wires, module) {}
};

struct Ssd1306OnSpi : OnSolomonSpi<Ssd1306> {
  Ssd1306OnSpi(PanelWires& wires, const PanelOptions&, const PanelModule& module)
      : OnSolomonSpi(wires, module, module.wiring) {}
};

struct Ssd1306OnI2c {
  using Driver = Ssd1306;
  Ssd1306OnI2c(PanelWires& wires, const PanelOptions& options, const PanelModule& module)
      : port(wires.i2c(), static_cast<std::uint8_t>(options.i2c_address)),
        driver(port, wires.reset(), wires.clock(), module.glass, module.settings, module.wiring) {}
  SolomonI2c port;
  Ssd1306 driver;
};

template <class Wired>
class PanelDisplay final : public Display {
 public:
  using Driver = typename Wired::Driver;
  using Format = typename Driver::Layout::Format;
  using Frame = Framebuffer<Format>;

  PanelDisplay(const std::string& name, const PanelOptions& options, const PanelModule& module)
      : wires_(options),
        wired_(wires_, options, module),
        memory_(Frame::words(panel().width(), panel().height())),
        frame_(memory_, panel().width(), panel().height()),
        // Twice, so that a frame is one window.
        wire_(2 * wire_bytes<Driver>(panel().width(), panel().height())),
        description_("panel " + name + " at " + options.bus()) {}
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
    wires_.check(panel().sleep());  // if it fails, the destructor tries once more
    started_ = false;
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

using Open = std::unique_ptr<Display>(const std::string&, const PanelOptions&, const PanelModule&);

template <class Wired>
std::unique_ptr<Display> open(const std::string& name, const PanelOptions& options,
                              const PanelModule& module) {
  auto display = std::make_unique<PanelDisplay<Wired>>(name, options, module);
  display->start();
  return display;
}

struct KnownController {
  const char* name;
  Open* on_spi;
  Open* on_i2c;
};

constexpr KnownController kControllers[] = {{"ili9341", &open<OnSpi<Ili9341>>, nullptr},
                                            {"st7789", &open<OnSpi<St7789>>, nullptr},
                                            {"ssd1351", &open<OnSpi<Ssd1351>>, nullptr},
                                            {"ssd1306", &open<Ssd1306OnSpi>, &open<Ssd1306OnI2c>},
                                            {"ssd0323", &open<Ssd0323OnSpi>, nullptr}};

}  // namespace

std::unique_ptr<Display> open_panel_display(const std::string& name, const PanelOptions& options) {
  const std::vector<std::string> names = module_names();
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw Failure("--device", "expected /dev/..., " + joined(names, ", ") + ", not '" + name + "'");
  const PanelModule module = find_module("--device", name, options.glass);
  for (const KnownController& known : kControllers) {
    if (module.controller != known.name) continue;
    Open* const open_on = options.i2c.empty() ? known.on_spi : known.on_i2c;
    if (open_on == nullptr) throw Failure("--i2c", name + " is on SPI only");
    return open_on(name, options, module);
  }
  throw Failure("--device", "no driver of " + module.controller);
}

}  // namespace arcspan::tools
