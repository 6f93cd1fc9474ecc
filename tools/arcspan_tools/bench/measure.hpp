// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/bench/bench_scene.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// The name of the float loop of float_phong.hpp, beside the names of shading methods.
inline constexpr const char* kFloatPhong = "float-phong";

/// One way of drawing a scene.
struct MethodTime {
  std::string method;
  double nanoseconds = 0;  ///< per pixel, median of the rounds
  double against_arc = 0;  ///< its time / that of arc in the same round, median of the rounds
};

struct SceneTimes {
  BenchSphere sphere;
  Size size;
  std::uint32_t triangles = 0;  ///< visible ones
  std::uint64_t spans = 0;
  std::uint64_t pixels = 0;
  std::vector<MethodTime> methods;
};

/// A frame drawn by several threads, each a band of its own; the quickest frame of all rounds.
struct ThreadTimes {
  BenchSphere sphere;
  Size size;
  std::uint32_t threads = 0;
  double milliseconds = 0;      ///< by the wall clock
  double speed_up = 0;          ///< of that, against one thread
  double busiest = 0;           ///< milliseconds of processor time of the busiest thread
  double busiest_speed_up = 0;  ///< of that: what there is to gain where every thread has a core
};

struct BenchPlan {
  std::vector<BenchSphere> spheres;
  std::vector<std::string> methods;  ///< shadings and kFloatPhong; arc is measured anyway
  std::int32_t tolerance = 1;        ///< of arc, in 8-bit steps
  std::int32_t rounds = 15;
  double milliseconds = 4;    ///< that each method draws in each round
  std::uint32_t threads = 1;  ///< scaling is measured from 2 to this
};

struct BenchReport {
  std::int32_t rounds = 0;
  std::vector<SceneTimes> scenes;
  std::vector<ThreadTimes> threads;
};

/// Called with the number of rounds that are done, of rounds_of(plan).
using RoundsDone = std::function<void(std::size_t done)>;

[[nodiscard]] std::size_t rounds_of(const BenchPlan& plan);

/// Every round draws with every method in turn, so that what disturbs the machine disturbs all of them; times
/// of one thread are processor time.
[[nodiscard]] BenchReport measure(const BenchPlan& plan, const RoundsDone& done);

/// The middle one, or the mean of the two in the middle; 0 of nothing.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace arcspan::tools
