// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/compile/compile_mesh.hpp>
#include <arcspan_tools/mesh/compile/tidy.hpp>
#include <arcspan_tools/mesh/plain/crease.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace arcspan::tools {
namespace {

/// The crease angle of normals that simplification makes anew, in degrees: the widest triangles that the
/// arcs draw at full speed.
constexpr double kDefaultCrease = 60;

/// compacted() of each part; parts that have no triangle left are dropped.
FixedModel compacted(const FixedModel& model) {
  FixedModel out;
  out.rig = model.rig;
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    FixedMesh mesh = compacted(model.meshes[i], model.rig.get());
    if (mesh.indices.empty()) continue;
    out.meshes.push_back(std::move(mesh));
    out.looks.push_back(model.looks[i]);
  }
  return out;
}

/// Looks for the model with the most triangles that fits.
class Search {
 public:
  Search(const Model& model, const MeshLimits& limits, const BytesOf& bytes_of, const std::string& subject,
         const std::function<void(std::size_t)>& tried)
      : model_(model), limits_(limits), bytes_of_(bytes_of), subject_(subject), tried_(tried) {}

  CompiledModel run() {
    const Outcome whole = attempt(Simplification::kNone, model_.triangle_count());
    if (whole == Outcome::kFits) return best_;
    if (whole == Outcome::kEmpty) throw Failure(subject_, "no triangle has an area in 16-bit positions");
    if (search(Simplification::kWithNormals)) return best_;
    // New vertices would follow no joints.
    const bool keeps_vertices = model_.rig != nullptr;
    for (const Simplification how : {Simplification::kByPosition, Simplification::kByCells}) {
      if (!keeps_vertices && search(how)) return best_;
    }
    throw Failure(subject_, "cannot be simplified to " + wanted() +
                                (keeps_vertices ? " with its joints and clips" : "") +
                                " (no attempt came below " + std::to_string(least_triangles_) +
                                " triangles or " + std::to_string(least_bytes_) + " bytes)" +
                                (keeps_vertices ? "; see --pose" : ""));
  }

 private:
  enum class Outcome { kFits, kTooLarge, kEmpty };

  [[nodiscard]] std::string wanted() const {
    const std::string bytes = limits_.max_bytes ? std::to_string(*limits_.max_bytes) + " bytes" : "";
    const std::string triangles =
        limits_.max_triangles ? std::to_string(*limits_.max_triangles) + " triangles" : "";
    return triangles + (bytes.empty() || triangles.empty() ? "" : " and ") + bytes;
  }

  Outcome attempt(Simplification how, std::size_t target) {
    tried_(++attempts_);
    const double crease = limits_.crease_degrees.value_or(kDefaultCrease);
    Simplified simplified = simplify(model_, how, target, crease, subject_);
    simplified.model.has_curves = limits_.curves;
    if (simplified.model.triangle_count() == 0) return Outcome::kEmpty;
    FixedModel fixed = compacted(to_fixed(simplified.model));
    if (fixed.meshes.empty()) return Outcome::kEmpty;
    for (FixedMesh& mesh : fixed.meshes) {
      if (!mesh.sources.empty()) mesh = with_separate_slots(ordered(mesh));  // may have more vertices
    }
    const std::size_t triangles = fixed.triangle_count();
    const std::size_t bytes = bytes_of_(fixed);
    least_triangles_ = std::min(least_triangles_, triangles);
    least_bytes_ = std::min(least_bytes_, bytes);
    if (limits_.max_triangles && triangles > *limits_.max_triangles) return Outcome::kTooLarge;
    if (limits_.max_bytes && bytes > *limits_.max_bytes) return Outcome::kTooLarge;
    best_.model = std::move(fixed);
    best_.how = how;
    best_.error = simplified.error;
    return Outcome::kFits;
  }

  /// Bisects for the largest target that fits, to half a percent; leaves it in best_.
  bool search(Simplification how) {
    std::size_t above =
        std::min(limits_.max_triangles.value_or(model_.triangle_count()), model_.triangle_count());
    if (attempt(how, above) == Outcome::kFits) return true;
    std::size_t below = 1;
    const Outcome least = attempt(how, below);
    if (least == Outcome::kTooLarge) return false;
    bool found = least == Outcome::kFits;
    while (above - below > 1 + below / 200) {
      const std::size_t middle = below + (above - below) / 2;
      const Outcome outcome = attempt(how, middle);
      found = found || outcome == Outcome::kFits;
      (outcome == Outcome::kTooLarge ? above : below) = middle;
    }
    return found;
  }

  const Model& model_;
  const MeshLimits& limits_;
  const BytesOf& bytes_of_;
  const std::string& subject_;
  const std::function<void(std::size_t)>& tried_;
  CompiledModel best_;
  std::size_t attempts_ = 0;
  std::size_t least_triangles_ = std::numeric_limits<std::size_t>::max();
  std::size_t least_bytes_ = std::numeric_limits<std::size_t>::max();
};

}  // namespace

CompiledModel compile_model(const Model& model, const MeshLimits& limits, const BytesOf& bytes_of,
                            const std::string& subject, const std::function<void(std::size_t)>& tried) {
  const Model creased = limits.crease_degrees ? with_crease(model, *limits.crease_degrees, subject) : model;
  CompiledModel compiled = Search(creased, limits, bytes_of, subject, tried).run();
  const auto triangles = static_cast<double>(compiled.model.triangle_count());
  for (FixedMesh& mesh : compiled.model.meshes) {
    const std::size_t count = mesh.indices.size() / 3;
    const double share = static_cast<double>(count) / triangles;
    compiled.cache_misses_before += share * cache_misses_per_triangle(mesh);
    if (mesh.sources.empty()) mesh = ordered(mesh);  // others are in order
    compiled.cache_misses += share * cache_misses_per_triangle(mesh);
  }
  return compiled;
}

}  // namespace arcspan::tools
