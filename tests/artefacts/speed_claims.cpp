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

constexpr const char* kMesh = "sphere:8x4";
constexpr int kUsualSegment = 0;  // that of each method

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

/// The instructions of `slower` are how many times those of `faster`: a column of the table.
std::string instruction_ratio(Bench& bench, const Contender& slower, const Contender& faster) {
  if (slower.shading == nullptr) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.2f",
                bench.cost(slower.shading, slower.segment_bits).instructions /
                    bench.cost(faster.shading, faster.segment_bits).instructions);
  return text;
}

/// `slower` costs how many times `faster`: three columns of the table.
std::string cost_ratio(Bench& bench, const Contender& slower, const Contender& faster) {
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
  Contender modern_slower = {};
  Contender modern_faster = {};
};

constexpr Contender kModernPhong{"phong-reciprocal"};

constexpr Claim kClaims[] = {
    {"Phong / Gouraud", "S3: more than 50", {"phong"}, {"gouraud"}, kModernPhong, {"gouraud"}},
    {"Phong / recurrence of scalars (eq. 14)",
     "S0: more than 2",
     {"phong"},
     {"recurrence"},
     kModernPhong,
     {"recurrence"}},
    {"Phong / recurrence of vectors (eq. 7)",
     "S0: more than 2",
     {"phong"},
     {"arc-vector"},
     kModernPhong,
     {"arc-vector"}},
    {"Phong / `arc`", "-", {"phong"}, {"arc"}, kModernPhong, {"arc"}},
    {"`arc` / Gouraud", "-", {"arc"}, {"gouraud"}},
    {"SLERP (eq. 2) / recurrence of vectors", "-", {"slerp"}, {"arc-vector"}},
    {"four pixels at a time (eq. 9 to 11) / single step", "-", {"recurrence-four"}, {"recurrence"}},
    {"Phong / linear segments of 4",
     "S3: 1.3",
     {"phong-diffuse"},
     {"phong-segment-diffuse", 2},
     {"phong-reciprocal-diffuse"},
     {"phong-reciprocal-segment-diffuse", 2}},
    {"Phong / linear segments of 8",
     "S3: 1.48",
     {"phong-diffuse"},
     {"phong-segment-diffuse", 3},
     {"phong-reciprocal-diffuse"},
     {"phong-reciprocal-segment-diffuse", 3}},
    {"Phong / segments of 4, halved by the root",
     "S3: 1.3",
     {"phong-diffuse"},
     {"dichotomy-root-diffuse", 2},
     {"phong-reciprocal-diffuse"},
     {"dichotomy-root-diffuse", 2}},
    {"Phong / segments of 8, halved by the root",
     "S3: 1.48",
     {"phong-diffuse"},
     {"dichotomy-root-diffuse", 3},
     {"phong-reciprocal-diffuse"},
     {"dichotomy-root-diffuse", 3}},
    {"Phong / segments of 4, halved by the printed linear polynomial",
     "S3: 1.8",
     {"phong-diffuse"},
     {"dichotomy-printed-linear-diffuse", 2},
     {"phong-reciprocal-diffuse"},
     {"dichotomy-printed-linear-diffuse", 2}},
    {"Phong / segments of 8, halved by the printed linear polynomial",
     "S3: 2.09",
     {"phong-diffuse"},
     {"dichotomy-printed-linear-diffuse", 3},
     {"phong-reciprocal-diffuse"},
     {"dichotomy-printed-linear-diffuse", 3}},
};

/// The methods in the table of operations: all but halving by a linear and by a cubic polynomial, which the
/// quadratic one lies between.
std::vector<std::string> tabled_shadings() {
  std::vector<std::string> names = shading_names();
  std::erase_if(
      names, [](const std::string& name) { return name == "dichotomy-linear" || name == "dichotomy-cubic"; });
  return names;
}

/// The pictures that the table of operations and the claims need.
std::vector<Drawn> all_drawn() {
  std::vector<Drawn> drawn;
  const auto add = [&drawn](const std::string& shading, int segment_bits) {
    const Drawn one{shading, segment_bits};
    if (std::find(drawn.begin(), drawn.end(), one) == drawn.end()) drawn.push_back(one);
  };
  for (const std::string& shading : tabled_shadings()) add(shading, kUsualSegment);
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
      "How many times as much the first of two methods costs, on `sphere:8x4`, 320x240 pixels, one light, "
      "Blinn's\n"
      "highlight: large triangles, so that the pixels count and not the set-up. *Shading* is instructions "
      "less those of\n"
      "flat shading. *Classic* Phong has a root bit by bit and three divisions per normal; *reciprocal* is\n"
      "`phong-reciprocal`, instructions again. S3's own figures are for the diffuse part, and so are those "
      "of segments.\n"
      "S0 counts vectors of three components where the recurrence here steps two scalars. Every dichotomy "
      "here divides\n"
      "the normals at the ends of a segment by a reciprocal root. `arcspan compare --table` measures other "
      "meshes.\n\n"
      "| ratio | paper | classic: instructions | time | shading | reciprocal |\n"
      "|---|---|---:|---:|---:|---:|");
  for (const Claim& claim : kClaims) {
    std::printf("| %s | %s | %s | %s |\n", claim.what, claim.paper,
                cost_ratio(coarse, claim.slower, claim.faster).c_str(),
                instruction_ratio(coarse, claim.modern_slower, claim.modern_faster).c_str());
  }
  std::puts("");
}

void print_operations(Bench& bench) {
  using arcspan_counting::Operation;
  std::puts(
      "Operations per pixel of the same frame, illumination and clamping included, counted by compiling the "
      "pipeline\n"
      "with integers that count. *Set-up* is all kinds together for vertices, triangles and row starts. The "
      "error is\n"
      "the root mean square in 8-bit steps from classic Phong in double precision.\n\n"
      "| shading | multiply | add | divide | root | look-up | set-up | instructions | error |\n"
      "|---|---:|---:|---:|---:|---:|---:|---:|---:|");
  for (const std::string& shading : tabled_shadings()) {
    const MethodFigures m = bench.figures(shading);
    std::printf("| %s |", shading.c_str());
    for (const Operation kind :
         {Operation::kMultiply, Operation::kAdd, Operation::kDivide, Operation::kRoot, Operation::kLookUp}) {
      std::printf(" %.2f |", m.per_pixel[static_cast<std::size_t>(kind)]);
    }
    std::printf(" %.1f | %.1f | %.2f |\n", m.around, bench.cost(shading).instructions, m.error.rms);
  }
  std::puts("");
}

void print_normal(const char* what, const char* paper, const arcspan_counting::OperationCounts& counts) {
  using arcspan_counting::Operation;
  std::printf("| %s | %s |", what, paper);
  for (const Operation kind : {Operation::kMultiply, Operation::kDivide, Operation::kRoot, Operation::kAdd,
                               Operation::kShift, Operation::kLookUp}) {
    std::printf(" %llu |", static_cast<unsigned long long>(counts[kind]));
  }
  std::puts("");
}

void print_operation_claims() {
  std::puts(
      "S0 counts the normal of a pixel alone; so does this table, by drawing with an illumination that does "
      "nothing.\n"
      "Further operations round: to 15 bits before and after dividing, and the product of the recurrence.\n\n"
      "| normal of a pixel | S0 | multiply | divide | root | add | shift | look-up |\n"
      "|---|---|---:|---:|---:|---:|---:|---:|");
  print_normal("classic Phong", "3 multiplies, 3 divisions, 5 additions, a root",
               arcspan_counting::classic_normal_operations());
  print_normal("Phong by a reciprocal root", "-", arcspan_counting::reciprocal_normal_operations());
  print_normal("Lyon, one scalar", "no division, no root", arcspan_counting::lyon_operations());
  print_normal("Duff, one scalar", "3 multiplies and additions less than Phong",
               arcspan_counting::duff_operations());
  print_normal("SLERP by eq. 2, three components",
               "three times 2 divisions, 2 multiplies, 3 additions, 2 look-ups",
               arcspan_counting::slerp_normal_operations());
  print_normal("eq. 7 or 14, one component or scalar", "1 multiply, 1 shift, 1 subtraction",
               arcspan_counting::recurrence_operations());
  print_normal("eq. 7 and 9 to 11, four pixels of a scalar", "-", arcspan_counting::four_steps_operations());
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
  Bench bench(self, kMesh, timing, all_drawn());
  print_claims(bench);
  print_operations(bench);
  print_operation_claims();
}
