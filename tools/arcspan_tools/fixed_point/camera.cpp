// SPDX-License-Identifier: MIT
#include <arcspan/mesh/bounding_sphere.hpp>

#include <arcspan_tools/fixed_point/camera.hpp>
#include <arcspan_tools/fixed_point/rounding.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace arcspan::tools {
namespace {

/// Room around a mesh that is fitted into the picture.
constexpr double kMargin = 1.06;
/// The near plane of an eye inside or near a mesh, in object units: a 250th of the largest extent.
constexpr double kLeastNear = 256;
/// The largest translation, in object units: 64 times the largest extent.
constexpr double kMostUnits = 4'194'303;
/// The largest distance of an eye from which a mesh is to fit, in object units. The rest up to kMostUnits
/// is for the far side of the mesh and for another target.
constexpr double kMostFittingUnits = 4'000'000;

/// The camera's axes: x to the right, y up, z backwards.
struct Axes {
  Vec3 x;
  Vec3 y;
  Vec3 z;
};

Axes axes_of(Vec3 backwards, Vec3 up) {
  const Vec3 z = normalised(backwards);
  Vec3 x = cross(normalised(up), z);
  // Looking along `up`: any other direction will do for it.
  if (length(x) < 1e-6) x = cross(std::fabs(z.z) < 0.9 ? Vec3{0, 0, -1} : Vec3{0, 1, 0}, z);
  x = normalised(x);
  return {x, cross(z, x), z};
}

double tangent_of_half(double degrees) { return std::tan(degrees * std::numbers::pi / 360); }

/// Calls `use` with the vector from the centre to each vertex.
template <class Use>
void for_each_vertex(const FixedMeshes& meshes, const Use& use) {
  for (const FixedMesh& mesh : meshes) {
    for (const ObjectPosition& p : mesh.positions) {
      use(Vec3{double(p.x), double(p.y), double(p.z)} * mesh.unit);
    }
  }
}

// The least distance from the target at which every vertex lies inside the picture's four planes.
double fitting_distance(const FixedMeshes& meshes, Vec3 target, const Axes& axes, double fov_degrees,
                        Size size) {
  const double vertical = tangent_of_half(fov_degrees);
  const double horizontal = vertical * size.width / size.height;
  double distance = 0;
  for_each_vertex(meshes, [&](const Vec3& from_centre) {
    const Vec3 p = meshes.centre() + from_centre - target;
    const double aside =
        std::max(std::fabs(dot(p, axes.x)) / horizontal, std::fabs(dot(p, axes.y)) / vertical);
    distance = std::max(distance, dot(p, axes.z) + kMargin * aside);
  });
  return distance;
}

// The least tangent of half the vertical field of view at which every vertex lies inside the picture, seen
// from `distance`; infinite if there is none.
double fitting_tangent(const FixedMeshes& meshes, Vec3 target, const Axes& axes, double distance, Size size) {
  double tangent = 0;
  for_each_vertex(meshes, [&](const Vec3& from_centre) {
    const Vec3 p = meshes.centre() + from_centre - target;
    const double depth = distance - dot(p, axes.z);
    const double aside =
        std::max(std::fabs(dot(p, axes.x)) * size.height / size.width, std::fabs(dot(p, axes.y)));
    tangent = std::max(tangent, depth > 0 ? kMargin * aside / depth : INFINITY);
  });
  return tangent;
}

[[noreturn]] void refuse_far(const char* subject, double distance) {
  throw Failure(subject,
                formatted("too far away (%g; the limit is 64 times the size of the mesh)", distance));
}

// The distance at which the mesh fits, or the largest one with a field of view that is wide enough there.
void fit(Camera& camera, const CameraOptions& options, const FixedMeshes& meshes, Size size) {
  const double from_mesh = length(camera.target - meshes.centre());
  if (!(from_mesh <= kMostUnits * meshes.unit())) refuse_far("--target", from_mesh);
  const Axes axes = axes_of(options.view, options.up);
  const double most = kMostFittingUnits * meshes.unit();
  double distance = fitting_distance(meshes, camera.target, axes, camera.fov_degrees, size);
  if (distance > most) {
    const double tangent = fitting_tangent(meshes, camera.target, axes, most, size);
    if (!std::isfinite(tangent)) refuse_far("--target", from_mesh);
    const double degrees = std::atan(tangent) * 360 / std::numbers::pi;
    if (options.fov_given) {
      throw Failure("--fov",
                    formatted("too narrow for the whole mesh in %dx%d pixels (%g; the least is %.1f)",
                              size.width, size.height, options.fov_degrees, std::ceil(degrees * 10) / 10));
    }
    camera.fov_degrees = degrees;
    distance = most;
  }
  camera.eye = camera.target + axes.z * distance;
}

struct DepthRange {
  double nearest;
  double farthest;
};

DepthRange depths(const FixedMeshes& meshes, Vec3 eye, const Axes& axes) {
  DepthRange range{INFINITY, -INFINITY};
  for_each_vertex(meshes, [&](const Vec3& from_centre) {
    const double depth = dot(eye - meshes.centre() - from_centre, axes.z) / meshes.unit();
    range = {std::min(range.nearest, depth), std::max(range.farthest, depth)};
  });
  return range;
}

/// The distance of a plane; an eye may be 2^22 units away.
ObjectLength plane_length(double units) {
  return to_fixed_point<ObjectLength>(std::min(units, 8'388'607.0)).value();
}

Placement placement_of(Vec3 eye, const Axes& axes, const FixedMeshes& meshes) {
  const Vec3 rows[3] = {axes.x, axes.y, axes.z};
  Placement placement{};
  for (int i = 0; i < 3; ++i) {
    const double entries[3] = {rows[i].x, rows[i].y, rows[i].z};
    for (int j = 0; j < 3; ++j) {
      placement.rotation.m[i][j] = to_fixed_point<RotationEntry>(std::clamp(entries[j], -1.0, 1.0)).value();
    }
    const double moved = dot(meshes.centre() - eye, rows[i]) / meshes.unit();
    if (!(std::fabs(moved) <= kMostUnits)) refuse_far("--eye", length(meshes.centre() - eye));
    placement.translation[i] = to_fixed_point<ObjectLength>(moved).value();
  }
  return placement;
}

}  // namespace

Camera place_camera(const CameraOptions& options, const FixedMeshes& meshes, Size size) {
  Camera camera{{}, options.target.value_or(meshes.centre()), options.up, options.fov_degrees};
  if (options.eye) {
    camera.eye = *options.eye;
  } else {
    fit(camera, options, meshes, size);
  }
  return camera;
}

FixedCamera to_fixed(const Camera& camera, const FixedMeshes& meshes, Size size) {
  // Twice the limit, which is checked axis by axis below: here it keeps all that follows finite.
  const double distance = length(camera.eye - meshes.centre());
  if (!(distance <= 2 * kMostUnits * meshes.unit())) refuse_far("--eye", distance);
  if (camera.eye == camera.target) throw Failure("--eye", "is where the target is");
  if (length(camera.up) == 0) throw Failure("--up", "has no direction");
  const Vec3 backwards = camera.eye - camera.target;
  const Axes axes = axes_of(backwards, camera.up);
  const DepthRange depth = depths(meshes, camera.eye, axes);
  const double near_plane = std::max(depth.nearest * 0.98, kLeastNear);
  const double far_plane = std::max(depth.farthest, near_plane) * 1.02;
  const double focal = size.height / (2 * tangent_of_half(camera.fov_degrees));
  const Projection projection{to_fixed_point<PixelLength>(focal).value_or(PixelLength{}),
                              plane_length(near_plane), plane_length(far_plane)};
  FixedCamera fixed;
  fixed.to_eye = to_direction(backwards);
  fixed.placement = placement_of(camera.eye, axes, meshes);
  fixed.projection = projection;
  fixed.nearest = depth.nearest * meshes.unit();
  fixed.farthest = depth.farthest * meshes.unit();
  const Status status =
      ClipTransform::make(fixed.placement, projection, {size.width, size.height}, fixed.transform);
  if (!ok(status))
    throw Failure("camera", std::string("cannot look at this mesh (") + to_string(status) + ")");
  return fixed;
}

double distance_of(const MeshView& mesh, const Placement& placement) {
  const ObjectPosition middle = bounding_sphere(mesh).middle;
  const auto entry = [&placement](std::size_t i) {
    return std::ldexp(placement.rotation.m[2][i].raw(), -RotationEntry::kFraction);
  };
  return -(entry(0) * middle.x + entry(1) * middle.y + entry(2) * middle.z +
           std::ldexp(placement.translation[2].raw(), -ObjectLength::kFraction));
}

Direction to_direction(Vec3 v) {
  const Vec3 unit = normalised(v);
  const auto component = [](double c) { return static_cast<std::int32_t>(rounded(std::ldexp(c, 29))); };
  return arcspan::normalised(component(unit.x), component(unit.y), component(unit.z));
}

}  // namespace arcspan::tools
