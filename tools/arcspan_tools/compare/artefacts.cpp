// SPDX-License-Identifier: MIT
#include <arcspan_tools/compare/artefacts.hpp>
#include <arcspan_tools/compare/scan_line_polygon.hpp>
#include <arcspan_tools/mesh/plain/generate.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace arcspan::tools {
namespace {

constexpr Size kSize{201, 151};  // odd: there is a middle pixel
constexpr std::int32_t kMiddleX = kSize.width / 2;
constexpr std::int32_t kMiddleY = kSize.height / 2;
constexpr int kTurnStep = 5;
constexpr int kFlickerSegments = 12;

/// A grey surface without ambient light, so that brightness is what the shading makes of it.
Surface grey(double diffuse, double specular, std::int32_t shininess) {
  return {{1, 1, 1}, 0, diffuse, specular, shininess};
}

Scene front_view(double distance) {
  Scene scene;
  scene.size = kSize;
  scene.camera.eye = Vec3{0, 0, distance};
  scene.camera.target = Vec3{0, 0, 0};
  scene.camera.fov_degrees = 30;
  scene.lights = {{0, 0, 1}};
  scene.background = {0, 0, 0};
  return scene;
}

/// A corner of a triangle around the origin, its normal leaning away from there.
void add_corner(MeshData& mesh, double degrees, double radius, double lean_degrees) {
  const double c = std::cos(degrees * kDegree);
  const double s = std::sin(degrees * kDegree);
  const double lean = std::sin(lean_degrees * kDegree);
  mesh.positions.push_back({radius * c, radius * s, 0});
  mesh.normals.push_back({lean * c, lean * s, std::cos(lean_degrees * kDegree)});
}

MeshData triangle(std::array<double, 3> corner_degrees, double lean_degrees) {
  MeshData mesh;
  for (const double degrees : corner_degrees) add_corner(mesh, degrees, 1, lean_degrees);
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

/// Two rectangles with a common upright edge at x = 0, 1 and `right` wide, normals from -30 over 0 to 30
/// degrees.
MeshData strip(double right) {
  MeshData mesh;
  const std::array<double, 3> columns{-1, 0, right};
  for (std::size_t i = 0; i < 3; ++i) {
    const double turn = 30 * (static_cast<double>(i) - 1) * kDegree;
    for (const double y : {-0.7, 0.7}) {
      mesh.positions.push_back({columns[i], y, 0});
      mesh.normals.push_back({std::sin(turn), 0, std::cos(turn)});
    }
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}};
  return mesh;
}

/// Three unit vectors at right angles to one another, each as far from z.
std::array<Vec3, 3> three_lights() {
  std::array<Vec3, 3> lights;
  for (std::size_t i = 0; i < 3; ++i) {
    const double around = (15 + 120.0 * static_cast<double>(i)) * kDegree;
    const double side = std::sqrt(2.0 / 3);
    lights[i] = {side * std::cos(around), side * std::sin(around), std::sqrt(1.0 / 3)};
  }
  return lights;
}

double angle_between(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)) / kDegree; }

template <class Shading>
double flicker_of(const Shading& shading) {
  double brightest = 0;
  double darkest = 255;
  for (int turn = 0; turn < 360 / kFlickerSegments; ++turn) {
    const double level = peak(ArtefactScene::turning_sphere(turn).picture(shading));
    brightest = std::max(brightest, level);
    darkest = std::min(darkest, level);
  }
  return brightest - darkest;
}

template <class Shading>
RotationSpread spread_of(const Shading& shading, double apart) {
  double brightest = 0;
  double darkest = 255;
  std::vector<Vec3> normals;
  for (int turn = 0; turn < 360; turn += kTurnStep) {
    const ArtefactScene scene = ArtefactScene::turned(apart, turn);
    const double level = scene.middle(shading);
    brightest = std::max(brightest, level);
    darkest = std::min(darkest, level);
    normals.push_back(scene.middle_normal(shading));
  }
  RotationSpread spread{brightest - darkest, 0};
  for (const Vec3& a : normals) {
    for (const Vec3& b : normals) spread.degrees = std::max(spread.degrees, angle_between(a, b));
  }
  return spread;
}

}  // namespace

ArtefactScene::ArtefactScene(const MeshData& mesh, Scene scene)
    : mesh_(to_fixed(mesh)), scene_(std::move(scene)) {}

ArtefactScene ArtefactScene::highlight() {
  Scene scene = front_view(4);
  scene.surface = grey(0.5, 0.45, 64);
  return {triangle({90, 210, 330}, 25), scene};
}

ArtefactScene ArtefactScene::fold() {
  Scene scene = front_view(4);
  scene.surface = grey(1, 0, 1);
  return {strip(1), scene};
}

ArtefactScene ArtefactScene::narrow_fold() {
  Scene scene = front_view(4);
  scene.surface = grey(1, 0, 1);
  scene.lights = {{1, 0, 1}};
  return {strip(0.3), scene};
}

ArtefactScene ArtefactScene::star() {
  constexpr std::uint32_t kSpokes = 10;
  MeshData mesh;
  const auto add = [&mesh](double radius, double degrees) {
    const Vec3 at{radius * std::cos(degrees * kDegree), radius * std::sin(degrees * kDegree), 0};
    mesh.positions.push_back(at);
    mesh.normals.push_back(normalised(at * 0.5 + Vec3{0, 0, 1}));
  };
  add(0, 0);
  for (std::uint32_t i = 0; i < kSpokes; ++i) add(i % 2 == 0 ? 1 : 0.4, 90 + 36.0 * i);
  for (std::uint32_t i = 1; i < kSpokes; i += 2) add(1, 90 + 36.0 * i);
  for (std::uint32_t i = 0; i < kSpokes; ++i) {
    const std::uint32_t here = 1 + i;
    const std::uint32_t next = 1 + (i + 1) % kSpokes;
    const std::uint32_t rim = 1 + kSpokes + i / 2;  // outside of the short spoke, which is one of the two
    mesh.triangles.push_back({0, here, next});
    mesh.triangles.push_back({here, rim, next});
  }
  Scene scene = front_view(4);
  scene.surface = grey(0.2, 0.75, 128);
  return {mesh, scene};
}

ArtefactScene ArtefactScene::turning_sphere(double turn) {
  MeshData mesh = generate(*parse_generated_mesh("sphere:" + std::to_string(kFlickerSegments) + "x6"));
  const auto turned_about_y = [turn](Vec3 v) {
    const double c = std::cos(turn * kDegree);
    const double s = std::sin(turn * kDegree);
    return Vec3{c * v.x + s * v.z, v.y, c * v.z - s * v.x};
  };
  for (Vec3& position : mesh.positions) position = turned_about_y(position);
  for (Vec3& normal : mesh.normals) normal = turned_about_y(normal);
  Scene scene = front_view(5);
  scene.surface = grey(0.4, 0.55, 32);
  return {mesh, scene};
}

ArtefactScene ArtefactScene::concave() {
  MeshData mesh;
  for (const PolygonCorner& corner : concave_polygon()) {
    mesh.positions.push_back({corner.x, corner.y, 0});
    mesh.normals.push_back(corner.normal);
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};  // Q R P, Q P S
  Scene scene = front_view(4);
  scene.surface = grey(0.9, 0, 1);
  return {mesh, scene};
}

ArtefactScene ArtefactScene::turned(double apart, double turn) {
  // Normals leaning by `lean` at 120 degrees from one another are `apart` from one another.
  const double lean = std::asin(std::sin(apart / 2 * kDegree) / std::sin(60 * kDegree)) / kDegree;
  // Not regular, lest it look the same after a third of a turn.
  MeshData mesh = triangle({80, 200, 320}, lean);
  mesh.positions[0] = mesh.positions[0] * 1.25;
  mesh.positions[1] = mesh.positions[1] * 0.8;
  Scene scene = front_view(5.5);
  scene.camera.up = {std::sin(turn * kDegree), std::cos(turn * kDegree), 0};
  scene.lights = {{0.5, 0.3, 1}};
  scene.surface = grey(0.6, 0.35, 16);
  return {mesh, scene};
}

Image ArtefactScene::drawn(const std::string& shading, const Scene& scene) const {
  const RenderJob job = make_job(scene, mesh_, "artefact");
  return find_renderer(shading, "rgb888", false).render(job, [](std::size_t) {}).image;
}

ReferencePicture ArtefactScene::reference(ReferenceKind kind) const {
  return draw_reference(make_job(scene_, mesh_, "artefact"), kind);
}

Image ArtefactScene::picture(ReferenceKind kind) const { return reference(kind).image({0, 0, 0}); }

Profile ArtefactScene::middle_row(const std::string& shading) const {
  const Image image = drawn(shading, scene_);
  const ReferencePicture cover = reference(ReferenceKind::kPhong);
  Profile profile;
  for (std::int32_t x = 0; x < kSize.width; ++x) {
    if (cover.at(x, kMiddleY) != nullptr) profile.emplace_back(x, image.at(x, kMiddleY).g);
  }
  return profile;
}

Profile ArtefactScene::middle_row(ReferenceKind kind) const {
  const ReferencePicture picture = reference(kind);
  Profile profile;
  for (std::int32_t x = 0; x < kSize.width; ++x) {
    const ReferenceSample* sample = picture.at(x, kMiddleY);
    if (sample != nullptr) profile.emplace_back(x, sample->levels[1]);
  }
  return profile;
}

double ArtefactScene::middle(const std::string& shading) const {
  return drawn(shading, scene_).at(kMiddleX, kMiddleY).g;
}

double ArtefactScene::middle(ReferenceKind kind) const {
  return reference(kind).at(kMiddleX, kMiddleY)->levels[1];
}

Vec3 ArtefactScene::middle_normal(const std::string& shading) const {
  Vec3 normal;
  for (const Vec3& light : three_lights()) {
    Scene scene = scene_;
    scene.lights = {light};
    scene.surface = grey(1, 0, 1);
    normal = normal + light * drawn(shading, scene).at(kMiddleX, kMiddleY).g;
  }
  return normalised(normal);
}

Vec3 ArtefactScene::middle_normal(ReferenceKind kind) const {
  return reference(kind).at(kMiddleX, kMiddleY)->normal;
}

double peak(const Profile& profile) {
  double highest = 0;
  for (const auto& [x, level] : profile) highest = std::max(highest, level);
  return highest;
}

double peak(const Image& picture) {
  double highest = 0;
  for (const Rgb8& pixel : picture.pixels) highest = std::max<double>(highest, pixel.g);
  return highest;
}

double highlight_elongation(const Image& picture) {
  constexpr int kDirections = 360;
  const double half = picture.at(kMiddleX, kMiddleY).g / 2.0;
  double nearest = kSize.width;
  double farthest = 0;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * std::numbers::pi * i / kDirections;
    double radius = 0;
    const auto level_at = [&](double r) {
      const auto x = kMiddleX + static_cast<std::int32_t>(std::lround(r * std::cos(angle)));
      const auto y = kMiddleY + static_cast<std::int32_t>(std::lround(r * std::sin(angle)));
      const bool inside = x >= 0 && y >= 0 && x < kSize.width && y < kSize.height;
      return inside ? picture.at(x, y).g : 0;
    };
    while (level_at(radius) >= half) radius += 0.25;
    nearest = std::min(nearest, radius);
    farthest = std::max(farthest, radius);
  }
  return farthest / nearest;
}

ColumnStep largest_step(const Image& picture, std::int32_t x) {
  ColumnStep largest;
  for (std::int32_t y = 1; y < picture.height; ++y) {
    const int above = picture.at(x, y - 1).g;
    const int below = picture.at(x, y).g;
    if (above > 0 && below > 0 && std::abs(above - below) > largest.steps)
      largest = {std::fabs(above - below), y};
  }
  return largest;
}

double flicker(const std::string& shading) { return flicker_of(shading); }
double flicker(ReferenceKind kind) { return flicker_of(kind); }

double kink(const Profile& profile, double x, int reach) {
  const auto level_at = [&profile](double at) {
    const auto found = std::find_if(profile.begin(), profile.end(),
                                    [at](const auto& point) { return std::fabs(point.first - at) < 0.5; });
    return found == profile.end() ? 0.0 : found->second;
  };
  return (level_at(x + reach) - 2 * level_at(x) + level_at(x - reach)) / reach;
}

RotationSpread rotation_spread(const std::string& shading, double apart) { return spread_of(shading, apart); }
RotationSpread rotation_spread(ReferenceKind kind, double apart) { return spread_of(kind, apart); }

}  // namespace arcspan::tools
