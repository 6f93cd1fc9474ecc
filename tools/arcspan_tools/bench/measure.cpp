// SPDX-License-Identifier: MIT
#include <arcspan_tools/bench/float_phong.hpp>
#include <arcspan_tools/bench/measure.hpp>
#include <arcspan_tools/bench/parallel_bands.hpp>
#include <arcspan_tools/support/processor_time.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace arcspan::tools {
namespace {

constexpr const char* kYardstick = "arc";

/// A method with everything it needs to draw a scene `repeats` times; gives milliseconds a frame.
struct Contestant {
  std::string method;
  std::function<double(std::int32_t repeats)> draw;
  std::int32_t repeats = 1;
  std::vector<double> times;
};

std::int32_t repeats_for(double wanted, double once) {
  constexpr double kMost = 10'000;
  return static_cast<std::int32_t>(std::clamp(wanted / std::max(once, 1e-4), 1.0, kMost));
}

Contestant float_contestant(const BenchScene& bench) {
  const auto phong = std::make_shared<FloatPhong>(bench);
  const auto draw = [phong](std::int32_t repeats) {
    double time = 0;
    for (std::int32_t i = 0; i < repeats; ++i) {
      phong->clear();
      const double start = processor_milliseconds();
      phong->draw();
      time += processor_milliseconds() - start;
    }
    return time / repeats;
  };
  return {kFloatPhong, draw, 1, {}};
}

Contestant contestant(const std::string& method, const BenchScene& bench, const RenderJob& job) {
  if (method == kFloatPhong) return float_contestant(bench);
  const Renderer& renderer = find_renderer(method, "rgb565", false);
  const auto draw = [&renderer, &job](std::int32_t repeats) {
    RenderJob repeated = job;
    repeated.repeats = repeats;
    repeated.counts = false;
    return renderer.render(repeated, [](std::size_t) {}).stats.draw_milliseconds;
  };
  return {method, draw, 1, {}};
}

std::vector<std::string> with_yardstick(std::vector<std::string> methods) {
  if (std::find(methods.begin(), methods.end(), kYardstick) == methods.end())
    methods.emplace_back(kYardstick);
  return methods;
}

std::vector<double> ratios(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] / std::max(b[i], 1e-9));
  return result;
}

class SceneBench {
 public:
  SceneBench(const BenchPlan& plan, const BenchSphere& sphere)
      : plan_(plan),
        sphere_(sphere),
        bench_(make_bench_scene(sphere)),
        mesh_(with_planes(to_fixed(bench_.mesh), to_string(sphere))),
        job_(make_job(bench_.scene, mesh_, to_string(sphere))) {
    job_.tolerance = plan.tolerance;
  }

  [[nodiscard]] SceneTimes times(const std::function<void()>& round_done) {
    std::vector<Contestant> contestants;
    for (const std::string& name : with_yardstick(plan_.methods)) {
      contestants.push_back(contestant(name, bench_, job_));
      Contestant& added = contestants.back();
      added.repeats = repeats_for(plan_.milliseconds, added.draw(1));
    }
    for (std::int32_t round = 0; round < plan_.rounds; ++round, round_done()) {
      for (Contestant& c : contestants) c.times.push_back(c.draw(c.repeats));
    }
    return summary(contestants);
  }

  [[nodiscard]] std::vector<ThreadTimes> thread_times(const std::function<void()>& round_done) {
    const ThreadTimes none{sphere_, bench_.scene.size, 0, INFINITY, 0, INFINITY, 0};
    std::vector<ThreadTimes> result(plan_.threads, none);
    constexpr std::int32_t kBalancingRounds = 6;
    const double once = ParallelBands(job_, 1).draw(1).busiest;
    const std::int32_t repeats = repeats_for(2 * plan_.milliseconds, once);
    for (std::int32_t round = 0; round < plan_.rounds; ++round, round_done()) {
      for (std::uint32_t t = 0; t < plan_.threads; ++t) {
        ParallelBands bands(job_, t + 1);
        if (t > 0) bands.balance(kBalancingRounds);
        const ParallelBands::FrameTime time = bands.draw(repeats);
        result[t].threads = t + 1;
        result[t].milliseconds = std::min(result[t].milliseconds, time.wall);
        result[t].busiest = std::min(result[t].busiest, time.busiest);
      }
    }
    for (ThreadTimes& times : result) {
      times.speed_up = result[0].milliseconds / std::max(times.milliseconds, 1e-9);
      times.busiest_speed_up = result[0].busiest / std::max(times.busiest, 1e-9);
    }
    return result;
  }

 private:
  [[nodiscard]] SceneTimes summary(const std::vector<Contestant>& contestants) const {
    const RenderStats stats =
        find_renderer(kYardstick, "rgb565", false).render(job_, [](std::size_t) {}).stats;
    SceneTimes scene{sphere_, bench_.scene.size, stats.triangles, stats.spans, stats.pixels, {}};
    const auto yardstick = std::find_if(contestants.begin(), contestants.end(),
                                        [](const Contestant& c) { return c.method == kYardstick; });
    for (const Contestant& c : contestants) {
      const double pixels = static_cast<double>(std::max<std::uint64_t>(stats.pixels, 1));
      scene.methods.push_back(
          {c.method, median(c.times) * 1e6 / pixels, median(ratios(c.times, yardstick->times))});
    }
    return scene;
  }

  const BenchPlan& plan_;
  BenchSphere sphere_;
  BenchScene bench_;
  FixedMesh mesh_;
  RenderJob job_;
};

}  // namespace

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::size_t rounds_of(const BenchPlan& plan) {
  const std::size_t kinds = plan.threads > 1 ? 2 : 1;
  return plan.spheres.size() * static_cast<std::size_t>(plan.rounds) * kinds;
}

BenchReport measure(const BenchPlan& plan, const RoundsDone& done) {
  BenchReport report;
  report.rounds = plan.rounds;
  std::size_t rounds = 0;
  const auto round_done = [&] { done(++rounds); };
  for (const BenchSphere& sphere : plan.spheres) {
    SceneBench bench(plan, sphere);
    report.scenes.push_back(bench.times(round_done));
    if (plan.threads < 2) continue;
    for (const ThreadTimes& times : bench.thread_times(round_done)) report.threads.push_back(times);
  }
  return report;
}

}  // namespace arcspan::tools
