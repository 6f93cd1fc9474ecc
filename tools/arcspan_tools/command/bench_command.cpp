// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <arcspan_tools/bench/report.hpp>
#include <arcspan_tools/command/command.hpp>
#include <arcspan_tools/command/render_options.hpp>
#include <arcspan_tools/command/typed_options.hpp>
#include <arcspan_tools/render/render.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <arcspan_tools/support/progress.hpp>
#include <arcspan_tools/support/result_files.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <sstream>
#include <thread>

namespace arcspan::tools {
namespace {

struct BenchArguments {
  BenchPlan plan;
  std::vector<std::string> tables;
  bool threads_given = false;
};

constexpr std::uint32_t kMostThreads = 64;

std::vector<std::string> method_names() {
  std::vector<std::string> names = shading_names();
  names.emplace_back(kFloatPhong);
  return names;
}

std::vector<std::string> parse_methods(const std::string& text) {
  const std::vector<std::string> all = method_names();
  std::vector<std::string> wanted;
  std::istringstream in(text);
  for (std::string name; std::getline(in, name, ',');) {
    if (name == kAdaptive) throw CLI::ValidationError("--method", "adaptive is now arc with --tolerance");
    if (std::find(all.begin(), all.end(), name) == all.end()) {
      std::string message = "expected names out of " + joined(all, "|");
      throw CLI::ValidationError("--method", message.append(" with commas, not '").append(name).append("'"));
    }
    if (std::find(wanted.begin(), wanted.end(), name) == wanted.end()) wanted.push_back(name);
  }
  if (wanted.empty()) throw CLI::ValidationError("--method", "names no method");
  return wanted;
}

void add_sphere(BenchPlan& plan, const std::string& text) {
  const std::optional<BenchSphere> sphere = parse_bench_sphere(text);
  if (!sphere) {
    throw CLI::ValidationError("--sphere", "expected AROUNDxALONG:RADIUS (3-256, 2-128, 1-" +
                                               std::to_string(kLargestBenchRadius) + "), not '" + text + "'");
  }
  plan.spheres.push_back(*sphere);
}

enum class ReportKind : std::uint8_t { kMarkdown, kJson };

ReportKind report_kind(const std::string& name) {
  const std::string kind = output_kind(name, "md");
  if (kind == "md") return ReportKind::kMarkdown;
  if (kind == "json") return ReportKind::kJson;
  throw Failure(name, "a report's name must end in .md or .json");
}

void run_bench(BenchArguments arguments) {
  BenchPlan& plan = arguments.plan;
  for (const std::string& table : arguments.tables) (void)report_kind(table);
  const std::vector<std::filesystem::path> written(arguments.tables.begin(), arguments.tables.end());
  check_results(written, {});
  if (plan.spheres.empty()) plan.spheres = default_bench_spheres();
  if (!arguments.threads_given)
    plan.threads = std::clamp(std::thread::hardware_concurrency(), 1u, kMostThreads);
  BenchReport report;
  {
    Progress progress("measuring", rounds_of(plan));
    progress.show(0);
    report = measure(plan, [&progress](std::size_t done) { progress.show(done); });
  }
  const std::string markdown = bench_markdown(report);
  std::vector<ResultFile> results;
  for (const std::string& table : arguments.tables) {
    results.push_back({table, report_kind(table) == ReportKind::kJson ? bench_json(report) : markdown});
  }
  write_results(results, markdown);
}

}  // namespace

void add_bench_command(CLI::App& app) {
  auto arguments = std::make_shared<BenchArguments>();
  arguments->plan.methods = {"flat", "gouraud", "arc", "phong", kFloatPhong};
  CLI::App* bench = app.add_subcommand("bench", "Measure the time of the shading methods on this machine");
  bench
      ->add_option_function<std::vector<std::string>>(
          "--sphere",
          [arguments](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) add_sphere(arguments->plan, text);
          },
          "a sphere of so many segments and so many pixels of radius; may be repeated (default: eight, from "
          "small "
          "to large triangles)")
      ->type_name("AROUNDxALONG:RADIUS")
      ->allow_extra_args(false);
  bench
      ->add_option_function<std::string>(
          "--method", [arguments](const std::string& text) { arguments->plan.methods = parse_methods(text); },
          "shadings and float-phong, with commas between them (default: "
          "flat,gouraud,arc,phong,float-phong)")
      ->type_name("A,B,C");
  add_integer(*bench, "--tolerance", "0...64", "what arc may be off by, in 8-bit steps (default 1)", 0, 64,
              arguments->plan.tolerance);
  bench->add_option("--rounds", arguments->plan.rounds, "in each of which every method draws (default: 15)")
      ->check(CLI::Range(1, 1000));
  bench
      ->add_option_function<std::uint32_t>(
          "--threads",
          [arguments](std::uint32_t threads) {
            arguments->plan.threads = threads;
            arguments->threads_given = true;
          },
          "draw bands with up to so many threads, too (default: as many as there are cores)")
      ->check(CLI::Range(1u, kMostThreads));
  bench->add_option("--table", arguments->tables, "write the report as .md or .json; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
  bench->footer(
      "Examples:\n"
      "  arcspan bench\n"
      "  arcspan bench --sphere 32x16:72 --method arc,phong --threads 1 --table bench.json");
  bench->callback([arguments] { run_bench(*arguments); });
}

}  // namespace arcspan::tools
