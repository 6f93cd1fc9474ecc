// SPDX-License-Identifier: MIT
#include <arcspan_tools/compare/instructions.hpp>
#include <arcspan_tools/mesh/plain/generate.hpp>
#include <arcspan_tools/render/scene.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <tests/artefacts/normal_operations.hpp>
#include <tests/artefacts/speed_claims.hpp>

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>

using namespace arcspan::tools;

namespace {

constexpr const char* kMeshes[] = {"sphere:8x4", "sphere:16x8", "sphere:32x16"};
constexpr int kUsualSegment = 2;

/// A method by name, those of this program included; nothing if there is none.
std::optional<MeasuredMethod> find_any(const std::string& shading) {
  for (const MeasuredMethod& method : measured_methods()) {
    if (method.shading == shading) return method;
  }
  const std::vector<std::string> names = shading_names();
  if (std::find(names.begin(), names.end(), shading) == names.end()) return std::nullopt;
  return find_method(shading);
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

/// Measures methods on one mesh.
class Bench {
 public:
  Bench(std::string self, std::string mesh_name, Timing timing)
      : self_(std::move(self)), name_(std::move(mesh_name)), timing_(timing), mesh_(make_mesh(name_)) {}

  /// A figure of time with two digits behind the point, or that there is none.
  [[nodiscard]] std::string time_text(double figure) const {
    if (timing_ == Timing::kLeftOut) return "untimed";
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", figure);
    return text;
  }

  /// Nothing if there is no such method.
  std::optional<MethodFigures> measure(const std::string& shading, int segment_bits = kUsualSegment) {
    const std::optional<MeasuredMethod> method = find_any(shading);
    if (!method) return std::nullopt;
    const std::pair<std::string, int> key{shading, segment_bits};
    const auto known = known_.find(key);
    if (known != known_.end()) return known->second;
    const RenderJob job = make_claim_job(mesh_, name_, segment_bits);
    MethodFigures figures =
        measure_method(*method, job, mesh_, draw_reference(job, ReferenceKind::kPhong), timing_);
    const auto count = drawing_instructions({self_, "--draw", shading, name_, std::to_string(segment_bits)});
    if (!count) throw Failure("valgrind", "not found; it counts the instructions");
    const RenderStats stats = method->render(job, {"rgb565"}, [](std::size_t) {}).stats;
    figures.instructions = static_cast<double>(*count) / static_cast<double>(stats.pixels);
    known_[key] = figures;
    return figures;
  }

 private:
  std::string self_;
  std::string name_;
  Timing timing_;
  FixedMesh mesh_;
  std::map<std::pair<std::string, int>, MethodFigures> known_;
};

/// A method, and the length of its segments if it has any.
struct Contender {
  const char* shading;
  int segment_bits = kUsualSegment;
};

/// `a` costs how many times `b`: three columns of the table.
std::string cost_ratio(Bench& bench, const Contender& a, const Contender& b) {
  const std::optional<MethodFigures> p = bench.measure(a.shading, a.segment_bits);
  const std::optional<MethodFigures> q = bench.measure(b.shading, b.segment_bits);
  if (!p || !q)
    return "not measured: there is no `" + std::string(!p ? a.shading : b.shading) + "` yet | - | -";
  const MethodFigures flat = *bench.measure("flat");
  char text[96];
  std::snprintf(text, sizeof text, "%.2f | %s | %.2f", *p->instructions / *q->instructions,
                bench.time_text(p->nanoseconds / q->nanoseconds).c_str(),
                (*p->instructions - *flat.instructions) / (*q->instructions - *flat.instructions));
  return text;
}

struct Claim {
  const char* what;
  const char* paper;
  Contender slower;
  Contender faster;
  const char* remark;
};

constexpr Claim kClaims[] = {
    {"classic Phong costs how many times Gouraud",
     "S3: more than 50",
     {"phong"},
     {"gouraud"},
     "S3 quotes it from elsewhere, without a machine; here all is integers: no power by a library, a "
     "division is "
     "one instruction, a root 16 steps"},
    {"classic Phong costs how many times the arcs (eq. 14)",
     "S0: more than 2",
     {"phong"},
     {"arc"},
     "S0 counts vectors; here two scalars in place of three components"},
    {"classic Phong costs how many times the arcs with vectors (eq. 7)",
     "S0: more than 2",
     {"phong"},
     {"arc-vector"},
     "the products with L and H are paid in both"},
    {"direct SLERP (eq. 2) costs how many times the arcs with vectors",
     "-",
     {"slerp"},
     {"arc-vector"},
     "the weights of eq. 2 serve all three components here, and divide by a reciprocal that a row makes "
     "once"},
    {"the arcs cost how many times Gouraud",
     "-",
     {"arc"},
     {"gouraud"},
     "the price of a highlight in every pixel"},
    {"segments of 4 pixels, linear inside: gain over Phong",
     "S3: 1.3",
     {"phong"},
     {"segment", 2},
     "S3 counts the diffuse part alone, and ends of segments by Phong's method; here they are ends of arcs"},
    {"segments of 8 pixels, linear inside: gain over Phong",
     "S3: 1.48",
     {"phong"},
     {"segment", 3},
     "as above"},
    {"segments of 4 pixels, linear inside: gain over the arcs", "-", {"arc"}, {"segment", 2}, ""},
    {"segments of 8 pixels, linear inside: gain over the arcs", "-", {"arc"}, {"segment", 3}, ""},
    {"segments of 4 pixels, halved by the root: gain over Phong",
     "S3: 1.3",
     {"phong"},
     {"dichotomy-root4"},
     "S3's text can be read either way; no division here, and the root is three multiplications by Newton's "
     "rule"},
    {"segments of 8 pixels, halved by the root: gain over Phong",
     "S3: 1.48",
     {"phong"},
     {"dichotomy-root8"},
     "as above"},
    {"segments of 4 pixels, halved by the linear polynomial: gain over Phong",
     "S3: 1.8",
     {"phong"},
     {"dichotomy-linear4"},
     "the diffuse part and the highlight"},
    {"segments of 8 pixels, halved by the linear polynomial: gain over Phong",
     "S3: 2.09",
     {"phong"},
     {"dichotomy-linear"},
     "as above"},
    {"segments of 16 pixels, halved by the linear polynomial: gain over Phong",
     "-",
     {"phong"},
     {"dichotomy-linear16"},
     ""},
    {"what the polynomial saves against the root, 4 pixels",
     "S3: 1.8 / 1.3 = 1.38",
     {"dichotomy-root4"},
     {"dichotomy-linear4"},
     "one root for each halving of a segment, not for each pixel"},
    {"what the polynomial saves against the root, 8 pixels",
     "S3: 2.09 / 1.48 = 1.41",
     {"dichotomy-root8"},
     {"dichotomy-linear"},
     "as above"},
};

void print_claims(Bench& coarse) {
  std::puts(
      "## Speed\n\n"
      "On `sphere:8x4`, 320x240 pixels, one light, Blinn's highlight: large triangles, so that the pixels\n"
      "count and not the set-up. The last column takes off what flat shading costs, that is, edges, rows, "
      "depth\n"
      "test and store: it is of the shading alone.\n\n"
      "| claim | paper | instructions | time | instructions of the shading | remarks |\n"
      "|---|---|---:|---:|---:|---|");
  for (const Claim& claim : kClaims) {
    std::printf("| %s | %s | %s | %s |\n", claim.what, claim.paper,
                cost_ratio(coarse, claim.slower, claim.faster).c_str(), claim.remark);
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
    const MethodFigures m = *bench.measure(shading);
    std::printf("| %s |", shading.c_str());
    for (const double rate : m.per_pixel) std::printf(" %.2f |", rate);
    std::printf(" %.1f | %.1f | %s | %.2f | %.1f |\n", m.around, *m.instructions,
                bench.time_text(m.nanoseconds).c_str(), m.error.rms, m.error.max);
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
  std::puts("");
}

}  // namespace

void draw_once(const std::string& shading, const std::string& mesh_name, int segment_bits) {
  const std::optional<MeasuredMethod> method = find_any(shading);
  if (!method) throw Failure(shading, "no such shading");
  const FixedMesh mesh = make_mesh(mesh_name);
  (void)method->render(make_claim_job(mesh, mesh_name, segment_bits), {"rgb565"}, [](std::size_t) {});
}

void print_speed(const std::string& self, Timing timing) {
  Bench coarse(self, kMeshes[0], timing);
  print_claims(coarse);
  for (const char* mesh : kMeshes) {
    Bench bench(self, mesh, timing);
    print_operations(bench, mesh);
  }
  print_operation_claims();
}
