// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/drm/drm_device.hpp>
#include <arcspan/linux_host/signal_watch.hpp>

#include <CLI/CLI.hpp>
#include <arcspan_tools/command/command.hpp>
#include <arcspan_tools/command/load_model.hpp>
#include <arcspan_tools/command/number_range.hpp>
#include <arcspan_tools/command/played_model.hpp>
#include <arcspan_tools/command/render_options.hpp>
#include <arcspan_tools/render/turntable.hpp>
#include <arcspan_tools/show/display.hpp>
#include <arcspan_tools/show/drm_display.hpp>
#include <arcspan_tools/show/framebuffer_display.hpp>
#include <arcspan_tools/show/panel_display.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace arcspan::tools {
namespace {

using Clock = std::chrono::steady_clock;  // CLOCK_MONOTONIC

constexpr int kSignalStatus = 128;  // what shells add to a signal's number

struct ShowArguments {
  RenderOptions options;
  bool own_size = false;    // --size was given
  bool own_format = false;  // --format was given
  std::string device;
  PanelOptions panel;
  std::vector<std::string> panel_options;  // their names
  int turntable = 0;                       // pictures a turn; 0: one picture that stands still
  double fps = 30;
  double seconds = 0;  // 0: until a signal comes
};

struct ShowStatistics {
  std::uint64_t frames = 0;
  double draw_milliseconds = 0;
  double send_milliseconds = 0;
};

// Size and format are those of the display unless options say otherwise.
void fit(ShowArguments& arguments, const Display& display) {
  const Size whole = display.size();
  Size& size = arguments.options.scene.size;
  if (!arguments.own_size)
    size = {std::min(whole.width, kMostRenderedSide), std::min(whole.height, kMostRenderedSide)};
  if (size.width > whole.width || size.height > whole.height) {
    throw Failure("--size", size_text(size) + " does not fit on the display's " + size_text(whole));
  }
  if (!arguments.own_format) arguments.options.format = display.format();
}

timespec to_timespec(Clock::time_point time) {
  const auto since = time.time_since_epoch();
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(since);
  const auto rest = std::chrono::duration_cast<std::chrono::nanoseconds>(since - seconds);
  return {static_cast<time_t>(seconds.count()), static_cast<long>(rest.count())};
}

double milliseconds(Clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

Clock::duration to_duration(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

// Draws and shows frames until the time is over or a signal comes, which is returned (0 for none).
class Show {
 public:
  Show(const ShowArguments& arguments, PlayedModel& model, Display& display, linux_host::SignalWatch& signals)
      : arguments_(arguments),
        model_(model),
        display_(display),
        signals_(signals),
        renderer_(
            find_renderer(arguments.options.shading, arguments.options.format, arguments.options.dither)),
        still_(arguments.turntable == 0),
        pictures_(still_ ? model.frames() : static_cast<std::size_t>(arguments.turntable)),
        turntable_(arguments.options.scene, model.extent(), still_ ? 1 : pictures_) {}

  [[nodiscard]] int run() {
    const Clock::time_point begin = Clock::now();
    const Clock::time_point end =
        arguments_.seconds > 0 ? begin + to_duration(arguments_.seconds) : Clock::time_point::max();
    show_frame();
    announce();
    if (!moves()) return hold(end);
    Clock::time_point next = Clock::now();
    while (true) {
      // A frame that took too long moves those after it.
      next = std::max(next + to_duration(1 / arguments_.fps), Clock::now());
      if (const int signal = hold(std::min(next, end)); signal != 0 || next >= end) return signal;
      show_frame();
    }
  }

  [[nodiscard]] const ShowStatistics& statistics() const { return statistics_; }

 private:
  [[nodiscard]] bool moves() const { return !still_ || pictures_ > 1; }

  void show_frame() {
    const std::size_t picture = static_cast<std::size_t>(statistics_.frames % pictures_);
    const Scene scene = moves() ? turntable_.scene(still_ ? 0 : picture) : arguments_.options.scene;
    const Clock::time_point begin = Clock::now();
    RenderJob job = make_job(scene, model_.frame(picture), arguments_.options.mesh);
    job.counts = false;
    const RenderResult drawn = renderer_.render(job, [](std::size_t) {});
    const Clock::time_point ready = Clock::now();
    display_.show(drawn.image);
    statistics_.draw_milliseconds += milliseconds(ready - begin);
    statistics_.send_milliseconds += milliseconds(Clock::now() - ready);
    ++statistics_.frames;
  }

  // After the first frame, so that whoever reads it knows that there is something to see.
  void announce() const {
    std::printf("showing %s, %s, on %s\n", size_text(arguments_.options.scene.size).c_str(),
                arguments_.options.format.c_str(), display_.description().c_str());
    std::fflush(stdout);
  }

  int hold(Clock::time_point until) {
    return until == Clock::time_point::max() ? signals_.wait() : signals_.wait_until(to_timespec(until));
  }

  const ShowArguments& arguments_;
  PlayedModel& model_;
  Display& display_;
  linux_host::SignalWatch& signals_;
  const Renderer& renderer_;
  bool still_;            ///< the camera does not turn
  std::size_t pictures_;  ///< of a turn, or of a clip
  Turntable turntable_;
  ShowStatistics statistics_;
};

// A path is a graphics card or a framebuffer, anything else the name of a panel.
std::unique_ptr<Display> open_display(const ShowArguments& arguments) {
  const std::string& device = arguments.device;
  if (device.find('/') == std::string::npos) return open_panel_display(device, arguments.panel);
  if (linux_host::is_drm_device(device.c_str())) return open_drm_display(device);
  return open_framebuffer_display(device);
}

// Returns the signal that ended it, when everything is given back.
int show_until_stopped(ShowArguments& arguments, PlayedModel& model) {
  // Before the display is opened: from here on a signal waits until the display can be left clean.
  linux_host::SignalWatch signals;
  const std::unique_ptr<Display> display = open_display(arguments);
  fit(arguments, *display);
  Show show(arguments, model, *display, signals);
  const int signal = show.run();
  display->finish();
  const ShowStatistics& statistics = show.statistics();
  const auto frames = static_cast<double>(statistics.frames);
  std::printf("%.0f frames; drawing %.1f ms, sending %.1f ms a frame\n", frames,
              statistics.draw_milliseconds / frames, statistics.send_milliseconds / frames);
  std::fflush(stdout);
  return signal;
}

void run_show(ShowArguments arguments) {
  // If the mesh cannot be loaded, the display is not opened.
  PlayedModel model(arguments.options, static_cast<std::size_t>(arguments.turntable), arguments.fps);
  const int signal = show_until_stopped(arguments, model);
  if (signal == 0) return;
  (void)std::raise(signal);  // ends as others do, so that a shell or a service manager sees why
  throw ExitStatus{kSignalStatus + signal};
}

// Refuses what the display or a picture that stands still does not have.
void check_used(const CLI::App& show, const ShowArguments& arguments) {
  if (arguments.device.find('/') != std::string::npos) {
    for (const std::string& option : arguments.panel_options) {
      if (show.count(option) != 0)
        throw CLI::ValidationError(option, "is of panels, not of " + arguments.device);
    }
  }
  check_clip(show);
  if (show.count("--fps") != 0 && show.count("--clip") == 0 && arguments.turntable == 0)
    throw CLI::ValidationError("--fps", "needs --turntable or --clip");
}

}  // namespace

void add_show_command(CLI::App& app) {
  auto arguments = std::make_shared<ShowArguments>();
  CLI::App* show =
      app.add_subcommand("show", "Show a mesh on a display of this machine until a signal comes (Ctrl-C)");
  add_outline_options(*show, arguments->options);
  add_render_options(*show, arguments->options);
  show->get_option("--size")->description("picture size, each 1...2048 (default: the display's)");
  show->get_option("--format")->description("pixel format (default: the display's own)");
  std::string devices = "a graphics card, e.g. /dev/dri/card0, a framebuffer, e.g. /dev/fb0, or a panel:";
  for (const std::string& name : module_names()) devices += " " + name;
  show->add_option("--device,--panel", arguments->device, devices)->required();
  const std::size_t first = show->get_options().size();
  add_panel_options(*show, arguments->panel);
  const std::vector<CLI::Option*> options = show->get_options();
  for (std::size_t i = first; i < options.size(); ++i)
    arguments->panel_options.push_back(options[i]->get_name());
  show->add_option("--turntable", arguments->turntable,
                   "turn the mesh, N pictures a turn (default 0: it stands still)")
      ->type_name("N")
      ->check(CLI::Range(0, 3600));
  add_clip(*show, arguments->options.clip);
  show->add_option("--fps", arguments->fps, "most pictures a second of a turn or a clip (default 30)")
      ->type_name("0.1...1000")
      ->check(number_range(0.1, 1000, "0.1...1000"));
  show->add_option("--seconds", arguments->seconds, "stop after this time (default 0: never)")
      ->type_name("0...86400")
      ->check(number_range(0, 86400, "0...86400"));
  show->footer(
      "Examples:\n"
      "  arcspan show bunny.obj --device /dev/dri/card0 --turntable 120\n"
      "  arcspan show torus:48x24 --device /dev/fb0 --seconds 10\n"
      "  arcspan show bunny.obj --device st7789 --dc GPIO25 --reset GPIO27 --backlight GPIO18\n"
      "  arcspan show bunny.obj --device ssd1306 --i2c /dev/i2c-1\n"
      "  arcspan show bunny.obj --device ssd1306-72x40 --i2c /dev/i2c-1 --rotate 180");
  show->callback([show, arguments] {
    check_used(*show, *arguments);
    arguments->own_size = show->count("--size") > 0;
    arguments->own_format = show->count("--format") > 0;
    run_show(*arguments);
  });
}

}  // namespace arcspan::tools
