// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/compile/compile_mesh.hpp>
#include <arcspan_tools/mesh/compile/tidy.hpp>
#include <arcspan_tools/mesh/plain/crease.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <limits>

namespace arcspan::tools {
namespace {

/// The crease angle of normals that simplification makes anew, in degrees: the widest triangles that the
/// arcs draw at full speed.
constexpr double kDefaultCrease = 60;

/// Looks for the mesh with the most triangles that fits.
class Search {
 public:
  Search(const MeshData& mesh, const MeshLimits& limits, const BytesOf& bytes_of, const std::string& subject,
         const std::function<void(std::size_t)>& tried)
      : mesh_(mesh), limits_(limits), bytes_of_(bytes_of), subject_(subject), tried_(tried) {}

  CompiledMesh run() {
    const Outcome whole = attempt(Simplification::kNone, mesh_.triangles.size());
    if (whole == Outcome::kFits) return best_;
    if (whole == Outcome::kEmpty) throw Failure(subject_, "no triangle has an area in 16-bit positions");
    for (const Simplification how :
         {Simplification::kWithNormals, Simplification::kByPosition, Simplification::kByCells}) {
      if (search(how)) return best_;
    }
    throw Failure(subject_, "cannot be simplified that far (the least is " +
                                std::to_string(least_triangles_) + " triangles in " +
                                std::to_string(least_bytes_) + " bytes)");
  }

 private:
  enum class Outcome { kFits, kTooLarge, kEmpty };

  Outcome attempt(Simplification how, std::size_t target) {
    tried_(++attempts_);
    const double crease = limits_.crease_degrees.value_or(kDefaultCrease);
    const Simplified simplified = simplify(mesh_, how, target, crease, subject_);
    if (simplified.mesh.triangles.empty()) return Outcome::kEmpty;
    FixedMesh fixed = compacted(to_fixed(simplified.mesh));
    if (fixed.indices.empty()) return Outcome::kEmpty;
    const std::size_t triangles = fixed.indices.size() / 3;
    const std::size_t bytes = bytes_of_(fixed.positions.size(), triangles);
    least_triangles_ = std::min(least_triangles_, triangles);
    least_bytes_ = std::min(least_bytes_, bytes);
    if (limits_.max_triangles && triangles > *limits_.max_triangles) return Outcome::kTooLarge;
    if (limits_.max_bytes && bytes > *limits_.max_bytes) return Outcome::kTooLarge;
    best_.mesh = std::move(fixed);
    best_.how = how;
    best_.error = simplified.error;
    return Outcome::kFits;
  }

  /// Bisects for the largest target that fits, to half a percent; leaves it in best_.
  bool search(Simplification how) {
    std::size_t above =
        std::min(limits_.max_triangles.value_or(mesh_.triangles.size()), mesh_.triangles.size());
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

  const MeshData& mesh_;
  const MeshLimits& limits_;
  const BytesOf& bytes_of_;
  const std::string& subject_;
  const std::function<void(std::size_t)>& tried_;
  CompiledMesh best_;
  std::size_t attempts_ = 0;
  std::size_t least_triangles_ = std::numeric_limits<std::size_t>::max();
  std::size_t least_bytes_ = std::numeric_limits<std::size_t>::max();
};

}  // namespace

CompiledMesh compile_mesh(const MeshData& mesh, const MeshLimits& limits, const BytesOf& bytes_of,
                          const std::string& subject, const std::function<void(std::size_t)>& tried) {
  const MeshData creased = limits.crease_degrees ? with_crease(mesh, *limits.crease_degrees, subject) : mesh;
  CompiledMesh compiled = Search(creased, limits, bytes_of, subject, tried).run();
  compiled.cache_misses_before = cache_misses_per_triangle(compiled.mesh);
  compiled.mesh = ordered(compiled.mesh);
  compiled.cache_misses = cache_misses_per_triangle(compiled.mesh);
  return compiled;
}

}  // namespace arcspan::tools
