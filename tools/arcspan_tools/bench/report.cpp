// SPDX-License-Identifier: MIT
#include <arcspan_tools/bench/report.hpp>
#include <arcspan_tools/support/text.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace arcspan::tools {
namespace {

std::string fixed(double value, int decimals) { return formatted("%.*f", decimals, value); }

double quotient(std::uint64_t a, std::uint64_t b) {
  return b == 0 ? 0 : static_cast<double>(a) / static_cast<double>(b);
}

double pixels_per_triangle(const SceneTimes& s) { return quotient(s.pixels, s.triangles); }
double pixels_per_span(const SceneTimes& s) { return quotient(s.pixels, s.spans); }
double megapixels(const MethodTime& m) { return m.nanoseconds > 0 ? 1e3 / m.nanoseconds : 0; }

/// A table's row: a cell each.
std::string row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) text += " " + cell + " |";
  return text + "\n";
}

std::string head(const std::vector<std::string>& cells) {
  std::string text = row(cells) + "|---|";
  for (std::size_t i = 1; i < cells.size(); ++i) text += "---:|";
  return text + "\n";
}

std::string name_of(const BenchSphere& sphere, Size size) {
  return to_string(sphere) + " in " + std::to_string(size.width) + "x" + std::to_string(size.height);
}

std::vector<const SceneTimes*> by_triangle_size(const BenchReport& report) {
  std::vector<const SceneTimes*> scenes;
  for (const SceneTimes& scene : report.scenes) scenes.push_back(&scene);
  std::stable_sort(scenes.begin(), scenes.end(), [](const SceneTimes* a, const SceneTimes* b) {
    return pixels_per_triangle(*a) < pixels_per_triangle(*b);
  });
  return scenes;
}

/// One table with a column for each method; `cell` is what stands there.
template <class Cell>
std::string method_table(const BenchReport& report, const Cell& cell) {
  std::vector<std::string> titles = {"sphere", "triangles", "px a triangle", "px a span"};
  for (const MethodTime& m : report.scenes.front().methods) titles.push_back(m.method);
  std::string text = head(titles);
  for (const SceneTimes* scene : by_triangle_size(report)) {
    std::vector<std::string> cells = {name_of(scene->sphere, scene->size), std::to_string(scene->triangles),
                                      fixed(pixels_per_triangle(*scene), 1),
                                      fixed(pixels_per_span(*scene), 1)};
    for (const MethodTime& m : scene->methods) cells.push_back(cell(m));
    text += row(cells);
  }
  return text;
}

std::string thread_table(const BenchReport& report) {
  std::string text = head({"sphere", "threads", "ms a frame", "frames a second", "speed-up",
                           "ms of the busiest thread", "speed-up of that"});
  for (const ThreadTimes& t : report.threads) {
    text += row({name_of(t.sphere, t.size), std::to_string(t.threads), fixed(t.milliseconds, 3),
                 fixed(t.milliseconds > 0 ? 1e3 / t.milliseconds : 0, 0), fixed(t.speed_up, 2),
                 fixed(t.busiest, 3), fixed(t.busiest_speed_up, 2)});
  }
  return text;
}

}  // namespace

std::string bench_markdown(const BenchReport& report) {
  if (report.scenes.empty()) return "";
  std::string text = "Medians of " + std::to_string(report.rounds) +
                     " rounds, in each of which every method has its turn.\n\n";
  text += "Nanoseconds of one core per pixel:\n\n";
  text += method_table(report, [](const MethodTime& m) { return fixed(m.nanoseconds, 2); });
  text += "\nMillion pixels a second:\n\n";
  text += method_table(report, [](const MethodTime& m) { return fixed(megapixels(m), 1); });
  text += "\nHow many times the time of arc:\n\n";
  text += method_table(report, [](const MethodTime& m) { return fixed(m.against_arc, 2); });
  if (!report.threads.empty())
    text +=
        "\nArc in bands, a band a thread; the quickest frames by the wall clock, and by processor time:\n\n" +
        thread_table(report);
  return text;
}

std::string bench_json(const BenchReport& report) {
  using nlohmann::ordered_json;
  ordered_json scenes = ordered_json::array();
  for (const SceneTimes& s : report.scenes) {
    ordered_json methods = ordered_json::array();
    for (const MethodTime& m : s.methods) {
      methods.push_back({{"method", m.method},
                         {"nanoseconds_per_pixel", m.nanoseconds},
                         {"megapixels_per_second", megapixels(m)},
                         {"time_per_arc", m.against_arc}});
    }
    scenes.push_back({{"sphere", to_string(s.sphere)},
                      {"width", s.size.width},
                      {"height", s.size.height},
                      {"triangles", s.triangles},
                      {"spans", s.spans},
                      {"pixels", s.pixels},
                      {"methods", methods}});
  }
  ordered_json threads = ordered_json::array();
  for (const ThreadTimes& t : report.threads) {
    threads.push_back({{"sphere", to_string(t.sphere)},
                       {"threads", t.threads},
                       {"milliseconds_per_frame", t.milliseconds},
                       {"speed_up", t.speed_up},
                       {"busiest_milliseconds", t.busiest},
                       {"busiest_speed_up", t.busiest_speed_up}});
  }
  const ordered_json all = {
      {"compiler", __VERSION__}, {"rounds", report.rounds}, {"scenes", scenes}, {"threads", threads}};
  return all.dump(2) + "\n";
}

}  // namespace arcspan::tools
