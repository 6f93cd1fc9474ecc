// SPDX-License-Identifier: MIT
#include <arcspan/animate/morphed_mesh.hpp>
#include <arcspan/animate/saturated_position.hpp>
#include <arcspan/numbers/integer.hpp>

namespace arcspan {

namespace {

constexpr int kMorphBits = animation_binary::kMorphWeightBits;

/// Sums of products of a weight and what a target adds. 256 targets fit 64 bits.
struct MorphSum {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t z = 0;

  void add(std::int32_t weight, std::int32_t dx, std::int32_t dy, std::int32_t dz) {
    x += weight * dx;
    y += weight * dy;
    z += weight * dz;
  }
};

/// The change of a coordinate by all targets, rounded, and limited to 2^20 so that the sum fits.
std::int32_t whole(std::int64_t sum) {
  return limited((sum + (std::int32_t{1} << (kMorphBits - 1))) >> kMorphBits, std::int32_t{1} << 20);
}

}  // namespace

Status MorphedMesh::make(const MeshView& mesh, const StoredAnimation& animation, std::size_t part,
                         std::span<const std::int16_t> weights, MorphedMesh& morphed) {
  const StoredMorph morph = animation.morph(part);
  if (morph.target_count() == 0 || morph.vertex_count() != mesh.vertex_count())
    return Status::kInvalidArgument;
  if (weights.size() < morph.target_count()) return Status::kBufferTooSmall;
  morphed.mesh_ = &mesh;
  morphed.weights_ = weights.data();
  morphed.morph_ = morph;
  return Status::kOk;
}

ObjectPosition MorphedMesh::position(std::size_t i) const {
  const ObjectPosition& v = mesh_->position(i);
  MorphSum sum;
  for (std::size_t j = morph_.first(i); j < morph_.first(i + 1); ++j) {
    const MorphRecord& record = morph_.record(j);
    sum.add(weights_[record.target], record.position.x, record.position.y, record.position.z);
  }
  return detail::saturated_position(v.x + whole(sum.x), v.y + whole(sum.y), v.z + whole(sum.z));
}

Direction MorphedMesh::direction(std::size_t i) const {
  const Direction n = unpack_normal(mesh_->normal(i));
  if (!morph_.has_normals() || morph_.first(i) == morph_.first(i + 1)) return n;
  MorphSum sum;
  for (std::size_t j = morph_.first(i); j < morph_.first(i + 1); ++j) {
    const std::int16_t* const added = morph_.normal(j);
    sum.add(weights_[morph_.record(j).target], added[0], added[1], added[2]);
  }
  // A direction has 15 fraction bits.
  constexpr int kUp = DirectionComponent::kFraction - animation_binary::kMorphNormalBits;
  const auto component = [](DirectionComponent c, std::int64_t added) {
    return c.raw() + whole(added * (1 << kUp));
  };
  const std::int32_t x = component(n.x, sum.x);
  const std::int32_t y = component(n.y, sum.y);
  const std::int32_t z = component(n.z, sum.z);
  return nearly_normalised(x, y, (x | y | z) == 0 ? 1 : z);
}

}  // namespace arcspan
