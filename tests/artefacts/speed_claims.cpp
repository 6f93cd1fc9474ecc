// SPDX-License-Identifier: MIT
#include <arcspan_tools/compare/comparison.hpp>
#include <arcspan_tools/mesh/plain/generate.hpp>
#include <arcspan_tools/render/scene.hpp>
#include <arcspan_tools/support/child_process.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <tests/artefacts/normal_operations.hpp>
#include <tests/artefacts/speed_claims.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <utility>

using namespace arcspan::tools;

namespace {

constexpr const char* kMeshes[] = {"sphere:8x4", "sphere:16x8", "sphere:32x16"};
constexpr int kUsualSegment = 2;

/// The function that draws by a method of this name, those of this program included; null if there is none.
RenderFunction* find_any(const std::string& shading) {
  for (const MeasuredVariant& variant : measured_variants()) {
    if (variant.shading == shading) return variant.render;
  }
  const std::vector<std::string> names = shading_names();
  if (std::find(names.begin(), names.end(), shading) == names.end()) return nullptr;
  return find_method(shading).render;
}

/// Segments of 2^bits pixels, in a scene that has such a setting.
template <class AnyScene>
void set_segment(AnyScene& scene, int bits) {
  if constexpr (requires { scene.segment_bits; }) scene.segment_bits = bits;
}

FixedMesh make_mesh(const std::string& name) { return to_fixed(generate(*parse_generated_mesh(name))); }

RenderJob make_claim_job(const FixedMesh& mesh, const std::string& name, int segment_bits) {
  Scene scene;
  set_segment(scene, segment_bits);
  return make_job(scene, mesh, name);
}

/// A shading and the length of its segments.
using Drawn = std::pair<std::string, int>;

/// The number behind `summary: ` in a callgrind profile (its manual, section "File Format"); 0 if there is
/// none.
double summary(const std::string& path) {
  std::ifstream profile(path);
  for (std::string line; std::getline(profile, line);) {
    if (line.rfind("summary: ", 0) == 0) return std::atof(line.c_str() + 9);
  }
  return 0;
}

/// Instructions that the program `self` spends in functions named draw_into for each of `drawn`. One run of
/// valgrind, which takes longer to start than to count: it writes a profile after each call of
/// picture_drawn().
std::map<Drawn, double> drawing_instructions(const std::string& self, const std::string& mesh,
                                             const std::vector<Drawn>& drawn) {
  ScratchFolder folder;
  const std::string profile = folder.file("profile").path();
  std::vector<std::string> arguments = {"--tool=callgrind",
                                        "--vgdb=no",
                                        "--toggle-collect=*draw_into*",
                                        "--dump-after=*picture_drawn*",
                                        "--callgrind-out-file=" + profile,
                                        self,
                                        "--draw",
                                        mesh};
  std::vector<std::string> profiles;
  for (const auto& [shading, segment_bits] : drawn) {
    arguments.insert(arguments.end(), {shading, std::to_string(segment_bits)});
    profiles.push_back(folder.file("profile." + std::to_string(profiles.size() + 1)).path());
  }
  const std::optional<ChildEnd> end = run_child("valgrind", arguments);
  if (!end) throw Failure("valgrind", "not found; it counts the instructions");
  if (end->status != 0) throw Failure("valgrind", "failed with status " + std::to_string(end->status));
  std::map<Drawn, double> counts;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    counts[drawn[i]] = summary(profiles[i]);
    if (counts[drawn[i]] == 0) throw Failure(drawn[i].first, "valgrind counted nothing");
  }
  return counts;
}

/// Cost of a whole picture, per drawn pixel.
struct Cost {
  double nanoseconds = 0;
  double instructions = 0;
};

/// Measures methods on one mesh: those of `drawn`.
class Bench {
 public:
  Bench(const std::string& self, std::string mesh_name, Timing timing, const std::vector<Drawn>& drawn)
      : name_(std::move(mesh_name)),
        timing_(timing),
        mesh_(make_mesh(name_)),
        instructions_(drawing_instructions(self, name_, drawn)) {
    const auto stats = find_any("flat")(job(kUsualSegment), {"rgb565"}, [](std::size_t) {}).stats;
    pixels_ = static_cast<double>(stats.pixels);  // every method draws the same pixels
  }

  /// A figure of time with two digits behind the point, or that there is none.
  [[nodiscard]] std::string time_text(double figure) const {
    if (timing_ == Timing::kLeftOut) return "untimed";
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", figure);
    return text;
  }

  /// The error and the operations of a method that the command offers.
  MethodFigures figures(const std::string& shading) {
    const RenderJob drawn = job(kUsualSegment);
    if (!reference_) reference_ = draw_reference(drawn, ReferenceKind::kPhong);
    return measure_method(find_method(shading), drawn, mesh_, *reference_, Timing::kLeftOut);
  }

  Cost cost(const std::string& shading, int segment_bits = kUsualSegment) {
    RenderFunction* const render = find_any(shading);
    if (render == nullptr) throw Failure(shading, "no such shading");
    const Drawn key{shading, segment_bits};
    const auto known = known_.find(key);
    if (known != known_.end()) return known->second;
    const double milliseconds =
        timing_ == Timing::kLeftOut ? 0 : best_draw_milliseconds(job(segment_bits), *render);
    return known_[key] = {milliseconds * 1e6 / pixels_, instructions_.at(key) / pixels_};
  }

 private:
  [[nodiscard]] RenderJob job(int segment_bits) const { return make_claim_job(mesh_, name_, segment_bits); }

  std::string name_;
  Timing timing_;
  FixedMesh mesh_;
  std::map<Drawn, double> instructions_;
  double pixels_ = 0;
  std::map<Drawn, Cost> known_;
  std::optional<ReferencePicture> reference_;
};

/// A method, and the length of its segments if it has any.
struct Contender {
  const char* shading = nullptr;
  int segment_bits = kUsualSegment;
};

/// `slower` costs how many times `faster`: three columns of the table.
std::string cost_ratio(Bench& bench, const Contender& slower, const Contender& faster) {
  if (slower.shading == nullptr) return "- | - | -";
  const Cost p = bench.cost(slower.shading, slower.segment_bits);
  const Cost q = bench.cost(faster.shading, faster.segment_bits);
  const double flat = bench.cost("flat").instructions;
  char text[96];
  std::snprintf(text, sizeof text, "%.2f | %s | %.2f", p.instructions / q.instructions,
                bench.time_text(p.nanoseconds / q.nanoseconds).c_str(),
                (p.instructions - flat) / (q.instructions - flat));
  return text;
}

/// A ratio that a paper states. Where Phong is one side, the ratio is measured twice: with classic Phong as
/// the paper has it, and with `modern...`, which normalise by a reciprocal root.
struct Claim {
  const char* what;
  const char* paper;
  Contender slower;
  Contender faster;
  const char* remark = "";
  Contender modern_slower = {};
  Contender modern_faster = {};
};

constexpr Contender kModernPhong{"phong-reciprocal"};

constexpr Claim kClaims[] = {
    {"Phong costs how many times Gouraud",
     "S3: more than 50",
     {"phong"},
     {"gouraud"},
     "S3 quotes it from elsewhere, without a machine; here all is integers: no power by a library, a "
     "division is one instruction, a root 16 steps",
     kModernPhong,
     {"gouraud"}},
    {"Phong costs how many times the recurrence with scalars (eq. 14)",
     "S0: more than 2",
     {"phong"},
     {"recurrence"},
     "S0 counts vectors; here two scalars in place of three components",
     kModernPhong,
     {"recurrence"}},
    {"Phong costs how many times the recurrence with vectors (eq. 7)",
     "S0: more than 2",
     {"phong"},
     {"arc-vector"},
     "the products with L and H are paid in both",
     kModernPhong,
     {"arc-vector"}},
    {"Phong costs how many times `arc`",
     "-",
     {"phong"},
     {"arc"},
     "this library's method",
     kModernPhong,
     {"arc"}},
    {"direct SLERP (eq. 2) costs how many times the recurrence with vectors",
     "-",
     {"slerp"},
     {"arc-vector"},
     "the weights of eq. 2 serve all three components here, and divide by a reciprocal that a row makes "
     "once"},
    {"four pixels at a time (eq. 9 to 11) cost how many times the single step",
     "-",
     {"recurrence-four"},
     {"recurrence"},
     "on one multiplier; S0 has four in mind"},
    {"`arc` costs how many times Gouraud",
     "-",
     {"arc"},
     {"gouraud"},
     "the price of a highlight in every pixel"},
    {"segments of 4 pixels, linear inside, diffuse: gain over Phong",
     "S3: 1.3",
     {"phong-diffuse"},
     {"phong-segment-diffuse", 2},
     "as S3 prints it; its figures are for the diffuse part",
     {"phong-reciprocal-diffuse"},
     {"phong-reciprocal-segment-diffuse", 2}},
    {"segments of 8 pixels, linear inside, diffuse: gain over Phong",
     "S3: 1.48",
     {"phong-diffuse"},
     {"phong-segment-diffuse", 3},
     "",
     {"phong-reciprocal-diffuse"},
     {"phong-reciprocal-segment-diffuse", 3}},
    {"segments of 4 pixels, linear inside, with highlight: gain over Phong",
     "-",
     {"phong"},
     {"phong-segment", 2},
     "",
     kModernPhong,
     {"phong-reciprocal-segment", 2}},
    {"segments of 8 pixels, linear inside, with highlight: gain over Phong",
     "-",
     {"phong"},
     {"phong-segment", 3},
     "",
     kModernPhong,
     {"phong-reciprocal-segment", 3}},
    {"segments of 4 pixels, halved by the root, diffuse: gain over Phong",
     "S3: 1.3",
     {"phong-diffuse"},
     {"dichotomy-root4-diffuse"},
     "S3's text can be read either way; this reading comes nearer to its figures. Every dichotomy "
     "here divides the normals at the ends of a segment by a reciprocal root",
     {"phong-reciprocal-diffuse"},
     {"dichotomy-root4-diffuse"}},
    {"segments of 8 pixels, halved by the root, diffuse: gain over Phong",
     "S3: 1.48",
     {"phong-diffuse"},
     {"dichotomy-root8-diffuse"},
     "",
     {"phong-reciprocal-diffuse"},
     {"dichotomy-root8-diffuse"}},
    {"segments of 4 pixels, halved by the printed linear polynomial, diffuse: gain over Phong",
     "S3: 1.8",
     {"phong-diffuse"},
     {"dichotomy-printed-linear4-diffuse"},
     "",
     {"phong-reciprocal-diffuse"},
     {"dichotomy-printed-linear4-diffuse"}},
    {"segments of 8 pixels, halved by the printed linear polynomial, diffuse: gain over Phong",
     "S3: 2.09",
     {"phong-diffuse"},
     {"dichotomy-printed-linear-diffuse"},
     "",
     {"phong-reciprocal-diffuse"},
     {"dichotomy-printed-linear-diffuse"}},
    {"segments of 4 pixels, halved by the printed linear polynomial, with highlight: gain over Phong",
     "-",
     {"phong"},
     {"dichotomy-printed-linear4"},
     "",
     kModernPhong,
     {"dichotomy-printed-linear4"}},
    {"segments of 8 pixels, halved by the printed linear polynomial, with highlight: gain over Phong",
     "-",
     {"phong"},
     {"dichotomy-printed-linear"},
     "",
     kModernPhong,
     {"dichotomy-printed-linear"}},
    {"gain of the polynomial over the root, 4 pixels, diffuse",
     "S3: 1.8 / 1.3 = 1.38",
     {"dichotomy-root4-diffuse"},
     {"dichotomy-printed-linear4-diffuse"},
     "one root for each halving of a segment, not for each pixel"},
    {"gain of the polynomial over the root, 8 pixels, diffuse",
     "S3: 2.09 / 1.48 = 1.41",
     {"dichotomy-root8-diffuse"},
     {"dichotomy-printed-linear-diffuse"},
     "as above"},
    {"gain of the polynomial over the root, 8 pixels, with highlight",
     "-",
     {"dichotomy-root8"},
     {"dichotomy-printed-linear"},
     "as above"},
    {"`segment` of 4 pixels, whose ends are those of arcs: gain over `arc`", "-", {"arc"}, {"segment", 2}},
    {"`segment` of 8 pixels, whose ends are those of arcs: gain over `arc`", "-", {"arc"}, {"segment", 3}},
};

/// The pictures that a table of operations needs, and if `has_claims` those of the claims too.
std::vector<Drawn> all_drawn(bool has_claims) {
  std::vector<Drawn> drawn;
  const auto add = [&drawn](const std::string& shading, int segment_bits) {
    const Drawn one{shading, segment_bits};
    if (std::find(drawn.begin(), drawn.end(), one) == drawn.end()) drawn.push_back(one);
  };
  for (const std::string& shading : shading_names()) add(shading, kUsualSegment);
  if (!has_claims) return drawn;
  for (const Claim& claim : kClaims) {
    for (const Contender& c : {claim.slower, claim.faster, claim.modern_slower, claim.modern_faster}) {
      if (c.shading != nullptr) add(c.shading, c.segment_bits);
    }
  }
  return drawn;
}

void print_claims(Bench& coarse) {
  std::puts(
      "## Speed\n\n"
      "On `sphere:8x4`, 320x240 pixels, one light, Blinn's highlight: large triangles, so that the pixels\n"
      "count and not the set-up. The columns *shading* subtract the cost of flat shading, that is, edges, "
      "rows,\n"
      "depth test and store. *Classic* is Phong as the papers have it, with a root bit by bit and three "
      "divisions\n"
      "per normal; *reciprocal* is `phong-reciprocal`, with a reciprocal root and three multiplies, and "
      "segments\n"
      "with such ends.\n\n"
      "| claim | paper | classic: instructions | time | shading | reciprocal: instructions | time | shading "
      "| "
      "remarks |\n"
      "|---|---|---:|---:|---:|---:|---:|---:|---|");
  for (const Claim& claim : kClaims) {
    std::printf("| %s | %s | %s | %s | %s |\n", claim.what, claim.paper,
                cost_ratio(coarse, claim.slower, claim.faster).c_str(),
                cost_ratio(coarse, claim.modern_slower, claim.modern_faster).c_str(), claim.remark);
  }
  std::puts("");
}

void print_operations(Bench& bench, const char* mesh) {
  std::printf(
      "`%s`, operations per pixel, counted by compiling the pipeline with integers that count:\n\n| shading "
      "|",
      mesh);
  for (const std::string_view kind : arcspan_counting::kOperationNames) {
    std::printf(" %s |", std::string(kind).c_str());
  }
  std::puts(" set-up | instructions | ns | RMS error | max error |");
  std::printf("|---|");
  for (std::size_t i = 0; i < arcspan_counting::kOperationKinds + 5; ++i) std::printf("---:|");
  std::puts("");
  for (const std::string& shading : shading_names()) {
    const MethodFigures m = bench.figures(shading);
    const Cost cost = bench.cost(shading);
    std::printf("| %s |", shading.c_str());
    for (const double rate : m.per_pixel) std::printf(" %.2f |", rate);
    std::printf(" %.1f | %.1f | %s | %.2f | %.1f |\n", m.around, cost.instructions,
                bench.time_text(cost.nanoseconds).c_str(), m.error.rms, m.error.max);
  }
  std::puts("");
}

void print_normal(const char* what, const char* paper, const arcspan_counting::OperationCounts& counts,
                  const char* remark) {
  using arcspan_counting::Operation;
  std::printf("| %s | %s |", what, paper);
  for (const Operation kind : {Operation::kMultiply, Operation::kDivide, Operation::kRoot, Operation::kAdd,
                               Operation::kShift, Operation::kLookUp}) {
    std::printf(" %llu |", static_cast<unsigned long long>(counts[kind]));
  }
  std::printf(" %s |\n", remark);
}

void print_operation_claims() {
  std::puts(
      "`set-up` is all kinds together for vertices, triangles and row starts, divided by the pixels. Errors "
      "are\n"
      "in 8-bit steps from classic Phong in double precision. The counts hold the whole pixel, illumination\n"
      "and clamping as well. S0 counts the normal alone; so does this table, by drawing with an "
      "illumination\n"
      "that does nothing:\n\n"
      "| a pixel's normal | S0 | multiply | divide | root | add | shift | look-up | why it differs |\n"
      "|---|---|---:|---:|---:|---:|---:|---:|---|");
  print_normal("classic Phong", "3 multiplies, 3 divisions, 5 additions, a root",
               arcspan_counting::classic_normal_operations(),
               "a multiply more to round the root; the other additions and shifts round to 15 bits before "
               "and after dividing");
  print_normal("Phong by a reciprocal root", "-", arcspan_counting::reciprocal_normal_operations(),
               "the root is a polynomial and two Newton steps");
  print_normal("Lyon, one scalar", "no division, no root", arcspan_counting::lyon_operations(), "");
  print_normal("Duff, one scalar", "3 multiplies and additions less than Phong",
               arcspan_counting::duff_operations(), "one division a scalar, as no vector is made");
  print_normal("SLERP by eq. 2, three components",
               "three times 2 divisions, 2 multiplies, 3 additions, 2 look-ups",
               arcspan_counting::slerp_normal_operations(),
               "weights are made once for all components, divided by way of a row's reciprocal; sines are "
               "interpolated "
               "between two entries");
  print_normal("eq. 7 or 14, one component or scalar", "1 multiply, 1 shift, 1 subtraction",
               arcspan_counting::recurrence_operations(),
               "the difference form has two sums; two more round, of which one is the same all along a row; "
               "a shift brings "
               "the multiplicand to 16 bits");
  print_normal("eq. 7 and 9 to 11, four pixels of a scalar", "-", arcspan_counting::four_steps_operations(),
               "seven products, each rounded; no new value depends on another one");
  std::puts("");
}

/// Marks the end of a picture for valgrind.
[[gnu::noinline]] void picture_drawn() {
  asm volatile("");  // not left out
}

}  // namespace

void draw_once(const std::string& shading, const std::string& mesh_name, int segment_bits) {
  RenderFunction* const render = find_any(shading);
  if (render == nullptr) throw Failure(shading, "no such shading");
  const FixedMesh mesh = make_mesh(mesh_name);
  (void)render(make_claim_job(mesh, mesh_name, segment_bits), {"rgb565"}, [](std::size_t) {});
  picture_drawn();
}

void print_speed(const std::string& self, Timing timing) {
  for (const char* mesh : kMeshes) {
    const bool is_first = mesh == kMeshes[0];
    Bench bench(self, mesh, timing, all_drawn(is_first));
    if (is_first) print_claims(bench);
    print_operations(bench, mesh);
  }
  print_operation_claims();
}
