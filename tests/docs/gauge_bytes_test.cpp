// SPDX-License-Identifier: MIT
// The bytes that the gauge of docs/interaction.md sends over a whole turn of its needle, as the page states
// them.
#define main page_main
#include "main.cpp"
#undef main

#include <algorithm>
#include <cstdio>

namespace {

constexpr int kStep = 650;
constexpr int kSteps = 65536 / kStep;

/// Shares of a frame, in percent.
struct Share {
  double mean = 0;
  double most = 0;
};

struct Simulated {
  hal::sim::SimulatedClock clock;
  hal::sim::DcsModel device{hal::kIli9341Module};
  hal::sim::SimulatedSpi bus{device, clock, 20'000'000};
  hal::Ili9341 panel{bus, bus.dc, &bus.reset, clock, hal::kIli9341Module, {}};
  Pages pages{panel, band_memory, wire_memory, kRows};
};

/// Calls `show` for each step of the needle, and returns what it sends. The first call does not count.
template <class Show>
Share sent_by(Simulated& gauge, const Show& show) {
  constexpr double kFrame = 2.0 * kWidth * kHeight;
  Share share;
  for (int step = 0; step <= kSteps; ++step) {
    const auto before = gauge.bus.count().bytes;
    if (!ok(set_needle({static_cast<std::uint16_t>(-kStep * step)})) || !ok(show())) return {};
    const double percent = 100 * static_cast<double>(gauge.bus.count().bytes - before) / kFrame;
    if (step == 0) continue;
    share.mean += percent / kSteps;
    share.most = std::max(share.most, percent);
  }
  return share;
}

Share sent_by_areas() {
  Simulated gauge;
  if (!ok(gauge.panel.start()) || !ok(set_needle({}))) return {};
  if (!ok(gauge.pages.show_area(gauge.panel.bounds(), draw))) return {};
  Rect shown = moving_rect();
  return sent_by(gauge, [&] {
    const Rect now = moving_rect();
    const Status status = gauge.pages.show_areas(shown, now, draw);
    shown = now;
    return status;
  });
}

Share sent_by_changes() {
  static hal::RowExtent rows[hal::Damage::extents(kHeight)];
  hal::Damage damage(rows, kWidth, kHeight);
  Simulated gauge;
  const auto show = [&] {
    return gauge.pages.show_changes(damage, [](auto& sink, Pages::Frame& band) {
      band.clear(kGround);
      DepthBuffer depth(depth_memory, kWidth, band.bounds().height(), band.bounds().top);
      depth.clear();
      const Status status = draw_prepared_scene(scene_memory, sink, depth).status;
      return ok(status) ? draw_label(sink) : status;
    });
  };
  if (!ok(gauge.panel.start()) || !ok(set_needle({})) || !ok(show())) return {};
  return sent_by(gauge, show);
}

bool rounds_to(double percent, int stated) { return percent > stated - 0.5 && percent < stated + 0.5; }

}  // namespace

int main() {
  const Share areas = sent_by_areas();
  const Share changes = sent_by_changes();
  std::printf("show_areas: %.1f %% on average, %.1f %% at most; show_changes: %.1f %%\n", areas.mean,
              areas.most, changes.mean);
  const bool is_most = areas.most > 10 && areas.most <= 11;
  return rounds_to(areas.mean, 7) && is_most && rounds_to(changes.mean, 32) ? 0 : 1;
}
