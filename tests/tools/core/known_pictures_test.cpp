// SPDX-License-Identifier: MIT
// Pictures whose every pixel is known: rays are cast in double precision, from the meshes before they are
// converted.
#include <arcspan_tools/mesh/plain/generate.hpp>
#include <arcspan_tools/render/scene.hpp>
#include <arcspan_tools/render/turntable.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace arcspan;
using namespace arcspan::tools;

namespace {

constexpr int kColumns = 64;
constexpr int kRows = 32;

/// A texture of 64×32 that says where it is: red is the mip level, green the column, blue the row.
std::shared_ptr<const SurfaceTexture> places() {
  auto texture = std::make_shared<SurfaceTexture>();
  const TextureSize size{6, 5, 6};
  for (unsigned level = 0; level < size.levels; ++level) {
    for (std::uint32_t row = 0; row < (32u >> level); ++row) {
      for (std::uint32_t column = 0; column < (64u >> level); ++column) {
        texture->texels.push_back(0x100000 | (level + 1) << 11 | column << 5 | row);
      }
    }
  }
  REQUIRE(ok(Texture<SurfaceTexels>::make(texture->texels, size, texture->view)));
  return texture;
}

/// The texel of places() that a pixel in rgb565 shows.
struct Shown {
  int level;
  int column;
  int row;
};
std::optional<Shown> shown(Rgb8 c) {
  if (c.r < 8) return std::nullopt;
  return Shown{(c.r >> 3) - 1, c.g >> 2, c.b >> 3};
}

/// How far a point is from what is shown, in texels of the level, in the direction in which it is farthest.
double texels_away(const Shown& shown, const Uv& point) {
  const auto away = [&shown](double at, int count, int index) {
    const double texels = std::ldexp(at * count, -shown.level);
    const double whole = std::ldexp(count, -shown.level);
    return std::max(std::abs(std::remainder(texels - index - 0.5, whole)) - 0.5, 0.0);
  };
  return std::max(away(point.u, kColumns, shown.column), away(point.v, kRows, shown.row));
}

/// The rays of a camera. Distances along a ray are those before the camera.
class Rays {
 public:
  Rays(const Camera& camera, Size size)
      : eye_(camera.eye),
        size_(size),
        focal_(size.height / (2 * std::tan(camera.fov_degrees * std::acos(-1.0) / 360))) {
    z_ = normalised(camera.eye - camera.target);
    x_ = normalised(cross(camera.up, z_));
    y_ = cross(z_, x_);
  }
  [[nodiscard]] const Vec3& eye() const { return eye_; }
  [[nodiscard]] Vec3 direction(double x, double y) const {
    return x_ * ((x + 0.5 - size_.width / 2.0) / focal_) + y_ * ((size_.height / 2.0 - y - 0.5) / focal_) -
           z_;
  }
  /// x and y of a normal as the camera sees it.
  [[nodiscard]] Vec3 seen(const Vec3& normal) const { return {dot(normal, x_), dot(normal, y_), 0}; }

 private:
  Vec3 eye_;
  Vec3 x_;
  Vec3 y_;
  Vec3 z_;
  Size size_;
  double focal_;
};

/// A scene whose surfaces show their colours as they are.
Scene unlit_scene(Size size) {
  Scene scene;
  scene.size = size;
  scene.background = {0, 0, 0};
  scene.surface.colour = {1, 1, 1};
  scene.surface.ambient = 1;
  scene.surface.diffuse = 0;
  scene.surface.specular = 0;
  return scene;
}

Image drawn(const RenderJob& job, const char* format = "rgb565") {
  return find_renderer("gouraud", format, false).render(job, [](std::size_t) {}).image;
}

/// A lit triangle in double precision: what each shading method makes of its lights and its texel.
struct LitTriangle {
  static constexpr double kAmbient = 0.1;
  static constexpr double kDiffuse = 0.21;
  static constexpr double kSpecular = 0.45;
  static constexpr int kShininess = 20;
  static constexpr std::uint32_t kTexel = 26u << 11 | 30u << 5 | 9u;  // 5-6-5

  std::vector<SceneLight> lights;
  Highlight highlight;
  bool textured;
  std::array<Vec3, 3> positions{Vec3{-1, -1, 0}, Vec3{1.2, -0.7, 0}, Vec3{-0.1, 1.1, 0}};
  std::array<Vec3, 3> normals{normalised(Vec3{-0.3, -0.2, 1}), normalised(Vec3{0.3, -0.1, 1}),
                              normalised(Vec3{0, 0.3, 1})};

  [[nodiscard]] FixedModel model() const {
    MeshData mesh;
    mesh.positions.assign(positions.begin(), positions.end());
    mesh.normals.assign(normals.begin(), normals.end());
    mesh.texture_points = {{0, 0}, {1, 0}, {0, 1}};
    mesh.triangles = {{0, 1, 2}};
    return to_fixed(to_model(mesh));
  }
  [[nodiscard]] Scene scene() const {
    Scene scene = unlit_scene({40, 40});
    scene.camera.eye = Vec3{0, 0, 4};
    scene.camera.target = Vec3{0, 0, 0};
    scene.surface.ambient = kAmbient;
    scene.surface.diffuse = kDiffuse;
    scene.surface.specular = kSpecular;
    scene.surface.shininess = kShininess;
    scene.lights = lights;
    scene.highlight = highlight;
    scene.tolerance = 0;
    return scene;
  }

  /// The light that a normal reflects: ambient and diffuse part, and highlights.
  struct Light {
    Vec3 diffuse{kAmbient, kAmbient, kAmbient};
    Vec3 specular{};
  };
  [[nodiscard]] Light light(const Vec3& n) const {
    constexpr Vec3 kEye{0, 0, 1};
    Light sum;
    for (const SceneLight& light : lights) {
      const Vec3 l = normalised(light.towards);
      const double cosine = dot(n, l);
      if (cosine <= 0) continue;
      sum.diffuse = sum.diffuse + light.colour * (kDiffuse * cosine);
      const double c = highlight == Highlight::kBlinn ? dot(n, normalised(l + kEye))
                                                      : 2 * cosine * dot(n, kEye) - dot(l, kEye);
      if (c > 0) sum.specular = sum.specular + light.colour * (kSpecular * std::pow(c, kShininess));
    }
    return sum;
  }
  /// Highlights lie on the texture where they are computed per pixel; elsewhere they are part of the light.
  [[nodiscard]] Vec3 reflected(const Vec3& diffuse, const Vec3& specular) const {
    const Vec3 texel = textured ? Vec3{26 / 31.0, 30 / 63.0, 9 / 31.0} : Vec3{1, 1, 1};
    const auto channel = [](double t, double d, double s) { return std::min(t * std::min(d, 1.0) + s, 1.0); };
    return {channel(texel.x, diffuse.x, specular.x), channel(texel.y, diffuse.y, specular.y),
            channel(texel.z, diffuse.z, specular.z)};
  }
  /// The colour at barycentric coordinates.
  [[nodiscard]] Vec3 colour(const std::string& shading, const std::array<double, 3>& at) const {
    const auto all = [this](const Vec3& n) {
      const Light of_vertex = light(n);
      return reflected(of_vertex.diffuse + of_vertex.specular, {});
    };
    if (shading == "flat") return all({0, 0, 1});
    if (shading == "gouraud")
      return all(normals[0]) * at[0] + all(normals[1]) * at[1] + all(normals[2]) * at[2];
    const Light of_pixel = light(normalised(normals[0] * at[0] + normals[1] * at[1] + normals[2] * at[2]));
    return reflected(of_pixel.diffuse, of_pixel.specular);
  }
};

constexpr double kFloor = 100;  ///< half its side
constexpr int kTiles = 40;      ///< along a side, two triangles each
constexpr double kTexture = 8;  ///< side of a repetition
constexpr double kHalfTile = kFloor / kTiles;

/// A floor at y = 0, with u along x and v along z.
FixedModel floor_of_tiles() {
  MeshData mesh;
  for (int j = 0; j <= kTiles; ++j) {
    for (int i = 0; i <= kTiles; ++i) {
      const Vec3 p{2 * kHalfTile * i - kFloor, 0, 2 * kHalfTile * j - kFloor};
      mesh.positions.push_back(p);
      mesh.normals.push_back({0, 1, 0});
      mesh.texture_points.push_back({p.x / kTexture, p.z / kTexture});
    }
  }
  for (std::uint32_t j = 0; j < kTiles; ++j) {
    for (std::uint32_t i = 0; i < kTiles; ++i) {
      const std::uint32_t a = j * (kTiles + 1) + i;
      const std::uint32_t b = a + kTiles + 1;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  }
  return to_fixed(to_model(mesh));
}

Scene floor_scene() {
  Scene scene = unlit_scene({240, 160});
  scene.camera.eye = Vec3{3, 4, 0.5};
  scene.camera.target = Vec3{13, 2, -30};
  scene.camera.fov_degrees = 60;
  return scene;
}

/// Where a ray meets the floor, as a multiple of its direction; nothing if it does not.
std::optional<double> meets_floor(const Rays& rays, const Vec3& direction) {
  if (direction.y >= 0) return std::nullopt;
  const double t = -rays.eye().y / direction.y;
  const Vec3 p = rays.eye() + direction * t;
  if (std::abs(p.x) > kFloor || std::abs(p.z) > kFloor) return std::nullopt;
  return t;
}

/// The mip level of a pixel of the floor: its longer side in texels, where one side is along the row.
std::optional<double> level_at(const Rays& rays, int x, int y) {
  const auto texels = [&](double px, double py) -> std::optional<Vec3> {
    const Vec3 direction = rays.direction(px, py);
    const std::optional<double> t = meets_floor(rays, direction);
    if (!t) return std::nullopt;
    const Vec3 p = rays.eye() + direction * *t;
    return Vec3{p.x / kTexture * kColumns, p.z / kTexture * kRows, 0};
  };
  const auto at = texels(x, y);
  const auto right = texels(x + 0.01, y);
  const auto below = texels(x, y + 0.01);
  if (!at || !right || !below) return std::nullopt;
  const Vec3 along = (*right - *at) * 100;
  const double step = std::log2(std::max(std::abs(along.x), std::abs(along.y)));
  const double area = std::log2(std::abs(cross(along, (*below - *at) * 100).z));
  return std::clamp(std::max(step, area - step), 0.0, 5.0);
}

}  // namespace

TEST_CASE("a floor up to the horizon shows the texels and mip levels of every pixel", "[textures]") {
  const FixedModel floor = floor_of_tiles();
  const Scene scene = floor_scene();
  RenderJob job = make_job(scene, floor, "floor");
  job.parts[0].texture = places();
  const Image image = drawn(job);
  const Rays rays(place_camera(scene.camera, floor, scene.size), scene.size);
  std::array<int, 6> levels{};
  int covered = 0;
  int unequal = 0;
  int outside = 0;
  int gaps = 0;
  double worst = 0;
  for (int y = 0; y < scene.size.height; ++y) {
    for (int x = 0; x < scene.size.width; ++x) {
      const Vec3 direction = rays.direction(x, y);
      const std::optional<double> t = meets_floor(rays, direction);
      const std::optional<Shown> pixel = shown(image.at(x, y));
      if (!t) {
        // The far border is a row of pixels at most from where it should be.
        outside += pixel && !meets_floor(rays, rays.direction(x, y + 1)) ? 1 : 0;
        continue;
      }
      if (!pixel) {
        gaps += meets_floor(rays, rays.direction(x, y - 1)) ? 1 : 0;
        continue;
      }
      ++covered;
      const Vec3 p = rays.eye() + direction * *t;
      worst = std::max(worst, texels_away(*pixel, {p.x / kTexture, p.z / kTexture}));
      ++levels[static_cast<std::size_t>(pixel->level)];
      const std::optional<double> level = level_at(rays, x, y);
      if (level && std::abs(pixel->level - *level) > 0.75) ++unequal;
    }
  }
  CHECK(covered > 19000);
  CHECK(outside == 0);
  CHECK(gaps == 0);
  // Half a texel, and what 16 bits of positions and texture points are off.
  CHECK(worst <= 0.7);
  for (const int count : levels) CHECK(count > 30);
  // Half a level by rounding; within a tile or a piece it changes by a quarter.
  CHECK(unequal < covered / 100);
}

TEST_CASE("fog on a floor is linear in the distance before the camera", "[textures]") {
  const FixedModel floor = floor_of_tiles();
  Scene scene = floor_scene();
  scene.fog = SceneFog{5, 60, Vec3{0.2, 0, 0.4}};
  const Image image = drawn(make_job(scene, floor, "floor"), "rgb888");
  const Rays rays(place_camera(scene.camera, floor, scene.size), scene.size);
  const double near_plane = 256 * floor.meshes[0].unit;
  int in_fog = 0;
  int wrong = 0;
  for (int y = 0; y < scene.size.height; ++y) {
    for (int x = 0; x < scene.size.width; ++x) {
      const std::optional<double> t = meets_floor(rays, rays.direction(x, y));
      if (!t || !meets_floor(rays, rays.direction(x, y - 1))) continue;
      const double share = std::clamp((*t - 5) / 55, 0.0, 1.0);
      if (share > 0 && share < 1) ++in_fog;
      const double apart = *t * *t / near_plane / 65023;  // of two depths
      const double slack = 2 + 255 * apart / 55;
      const Rgb8 c = image.at(x, y);
      const std::array<double, 3> off{c.r - (255 + (51 - 255) * share), c.g - 255 * (1 - share),
                                      c.b - (255 + (102 - 255) * share)};
      for (const double difference : off) wrong += std::abs(difference) <= slack ? 0 : 1;
    }
  }
  CHECK(wrong == 0);
  CHECK(in_fog > 8000);
}

namespace {

/// A cube of side 2 whose faces each show the whole texture.
FixedModel cube() {
  MeshData mesh;
  for (const double side : {-1.0, 1.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (const Uv& p : std::initializer_list<Uv>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        const std::array<double, 3> at{side, 2 * p.u - 1, 2 * p.v - 1};
        const auto turned = [&](int i) { return at[static_cast<std::size_t>((i + 3 - axis) % 3)]; };
        mesh.positions.push_back({turned(0), turned(1), turned(2)});
        mesh.normals.push_back(Vec3{axis == 0 ? side : 0, axis == 1 ? side : 0, axis == 2 ? side : 0});
        mesh.texture_points.push_back(p);
      }
      const std::uint32_t b = side > 0 ? 1 : 3;
      mesh.triangles.push_back({first, first + b, first + 2});
      mesh.triangles.push_back({first, first + 2, first + 4 - b});
    }
  }
  return to_fixed(to_model(mesh));
}

/// Where a ray meets the cube first: the point of its face, and how near to an edge that is.
struct CubeHit {
  Uv point;
  double from_edge;
};
std::optional<CubeHit> meets_cube(const Vec3& eye, const Vec3& direction) {
  const std::array<double, 3> from{eye.x, eye.y, eye.z};
  const std::array<double, 3> along{direction.x, direction.y, direction.z};
  std::optional<CubeHit> hit;
  double nearest = INFINITY;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double t = ((along[axis] < 0 ? 1 : -1) - from[axis]) / along[axis];
    const double a = from[(axis + 1) % 3] + along[(axis + 1) % 3] * t;
    const double b = from[(axis + 2) % 3] + along[(axis + 2) % 3] * t;
    if (!(t > 0) || t >= nearest || std::abs(a) > 1 || std::abs(b) > 1) continue;
    nearest = t;
    hit = CubeHit{{(a + 1) / 2, (b + 1) / 2}, 1 - std::max(std::abs(a), std::abs(b))};
  }
  return hit;
}

}  // namespace

TEST_CASE("a grid on a cube stays in its place through a whole turn, without gaps at edges", "[textures]") {
  const FixedModel model = cube();
  Scene scene = unlit_scene({96, 72});
  scene.camera.fov_degrees = 55;
  scene.camera.eye = Vec3{0.3, 1.9, 2.4};
  constexpr std::size_t kFrames = 36;
  const Turntable turntable(scene, model, kFrames);
  for (std::size_t frame = 0; frame < kFrames; ++frame) {
    const Scene turned = turntable.scene(frame);
    RenderJob job = make_job(turned, model, "cube");
    job.parts[0].texture = places();
    const Image image = drawn(job);
    const Rays rays(place_camera(turned.camera, model, scene.size), scene.size);
    // Whether each pixel is on the cube, with a border of pixels around the picture.
    const auto width = static_cast<std::size_t>(scene.size.width) + 2;
    std::vector<int> on_cube(width * (static_cast<std::size_t>(scene.size.height) + 2));
    const auto at = [&on_cube, width](int x, int y) -> int& {
      return on_cube[static_cast<std::size_t>(y + 1) * width + static_cast<std::size_t>(x + 1)];
    };
    int compared = 0;
    double worst = 0;
    for (int y = 0; y < scene.size.height; ++y) {
      for (int x = 0; x < scene.size.width; ++x) {
        const std::optional<CubeHit> hit = meets_cube(rays.eye(), rays.direction(x, y));
        const std::optional<Shown> pixel = shown(image.at(x, y));
        at(x, y) = hit ? 1 : 0;
        if (!hit || !pixel || hit->from_edge < 0.03) continue;
        worst = std::max(worst, texels_away(*pixel, hit->point));
        ++compared;
      }
    }
    int gaps = 0;
    int beside = 0;
    for (int y = 0; y < scene.size.height; ++y) {
      for (int x = 0; x < scene.size.width; ++x) {
        const int around = at(x - 1, y) + at(x + 1, y) + at(x, y - 1) + at(x, y + 1);
        const bool covered = shown(image.at(x, y)).has_value();
        gaps += at(x, y) == 1 && around == 4 && !covered ? 1 : 0;
        beside += at(x, y) == 0 && around == 0 && covered ? 1 : 0;
      }
    }
    CAPTURE(frame);
    CHECK(worst <= 0.55);
    CHECK(gaps == 0);
    CHECK(beside == 0);
    CHECK(compared > 1200);
  }
}

TEST_CASE("transparent squares are drawn from the farthest to the nearest, from both sides", "[textures]") {
  struct Square {
    double z;
    Vec3 colour;
    double opacity;
  };
  // In no order of the file; the third is opaque.
  const std::vector<Square> squares = {
      {0.5, {1, 0, 0}, 0.5}, {-1, {0, 1, 0}, 0.25}, {-0.25, {0.9, 0.9, 0.2}, 1}, {1, {0, 0.2, 1}, 0.75}};
  Model model;
  for (const Square& square : squares) {
    ModelPart part;
    part.look.material.colour = square.colour;
    part.look.material.opacity = square.opacity;
    for (const auto& [x, y] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
      part.mesh.positions.push_back({x, y, square.z});
      part.mesh.normals.push_back({0, 0, 1});
    }
    part.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    model.parts.push_back(part);
  }
  const FixedModel fixed = to_fixed(model);
  Scene scene = unlit_scene({40, 40});
  scene.two_sided = true;
  scene.background = {0.4, 0.4, 0.4};
  for (const double side : {1.0, -1.0}) {
    scene.camera.eye = Vec3{0, 0, 4 * side};
    scene.camera.target = Vec3{0, 0, 0};
    std::vector<Square> sorted = squares;
    std::sort(sorted.begin(), sorted.end(),
              [side](const Square& a, const Square& b) { return a.z * side < b.z * side; });
    Vec3 wanted = scene.background;
    for (const Square& square : sorted)
      wanted = wanted * (1 - square.opacity) + square.colour * square.opacity;
    const Rgb8 c = drawn(make_job(scene, fixed, "squares"), "rgb888").at(20, 20);
    CAPTURE(side);
    CHECK(std::abs(c.r - 255 * wanted.x) <= 2);
    CHECK(std::abs(c.g - 255 * wanted.y) <= 2);
    CHECK(std::abs(c.b - 255 * wanted.z) <= 2);
  }
}

TEST_CASE("a chrome ball shows its picture where the camera sees its normals point", "[textures]") {
  const FixedModel ball = to_fixed(to_model(generate(parse_generated_mesh("sphere:64x32").value())));
  Scene scene = unlit_scene({120, 90});
  scene.matcap = places();
  for (const Vec3& view : {Vec3{0, 0, 1}, Vec3{1, 2, -1}}) {
    scene.camera.view = view;
    const RenderJob job = make_job(scene, ball, "ball");
    const Image image = find_renderer("arc", "rgb565", false).render(job, [](std::size_t) {}).image;
    const Rays rays(place_camera(scene.camera, ball, scene.size), scene.size);
    int compared = 0;
    double worst = 0;
    for (int y = 0; y < scene.size.height; ++y) {
      for (int x = 0; x < scene.size.width; ++x) {
        const Vec3 d = rays.direction(x, y);
        const double b = dot(rays.eye(), d) / dot(d, d);
        const double root = b * b - (dot(rays.eye(), rays.eye()) - 1) / dot(d, d);
        if (root < 0.02) continue;  // near the outline, where the mesh has corners
        const Vec3 normal = rays.eye() + d * (-b - std::sqrt(root));
        const Vec3 seen = rays.seen(normal);
        const std::optional<Shown> pixel = shown(image.at(x, y));
        if (!pixel) continue;
        worst = std::max(worst, texels_away(*pixel, {(seen.x + 1) / 2, (1 - seen.y) / 2}));
        ++compared;
      }
    }
    CAPTURE(view.x);
    CHECK(worst <= 1);
    CHECK(compared > 3500);
  }
}

TEST_CASE("any lights on any surface are those of double precision", "[textures]") {
  const auto lights = static_cast<std::size_t>(GENERATE(1, 2, 3, 4));
  const bool coloured = GENERATE(false, true);
  const bool textured = GENERATE(false, true);
  const Highlight highlight = GENERATE(Highlight::kBlinn, Highlight::kPhong);
  // In rgb565 products and sums are computed in 5 and 6 bits, grey light with 65 levels.
  const auto [format, most] = GENERATE(std::pair("rgb888", 2.5), std::pair("rgb565", 12.0));
  std::vector<SceneLight> all{{0.2, 0.1, 1}, {-0.4, 0.5, 1}, {0.9, -0.1, 0.4}, {-0.7, -0.9, 0.3}};
  if (coloured) {
    all[0].colour = {1, 0.6, 0.2};
    all[2].colour = {0.1, 0.4, 1};
  }
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(lights), all.end());
  const LitTriangle triangle{all, highlight, textured};
  const FixedModel model = triangle.model();
  RenderJob job = make_job(triangle.scene(), model, "triangle");
  auto texture = std::make_shared<SurfaceTexture>();
  texture->texels.assign(64, 0x100000 | LitTriangle::kTexel);
  REQUIRE(ok(Texture<SurfaceTexels>::make(texture->texels, {3, 3, 1}, texture->view)));
  if (textured) job.parts[0].texture = texture;
  const Rays rays(place_camera(triangle.scene().camera, model, {40, 40}), {40, 40});
  for (const std::string shading : {"flat", "gouraud", "arc", "phong"}) {
    if (textured && shading == "phong") continue;
    const Image image = find_renderer(shading, format, false).render(job, [](std::size_t) {}).image;
    double worst = 0;
    int compared = 0;
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 40; ++x) {
        const Vec3 p = rays.eye() + rays.direction(x, y) * rays.eye().z;
        const auto& [a, b, c] = triangle.positions;
        const double area = cross(b - a, c - a).z;
        const std::array<double, 3> at{cross(b - p, c - p).z / area, cross(c - p, a - p).z / area,
                                       cross(a - p, b - p).z / area};
        if (std::min({at[0], at[1], at[2]}) < 0) continue;
        if (image.at(x, y) == Rgb8{}) continue;  // on an edge
        const Vec3 wanted = triangle.colour(shading, at) * 255;
        const Rgb8 c8 = image.at(x, y);
        worst = std::max(
            {worst, std::abs(c8.r - wanted.x), std::abs(c8.g - wanted.y), std::abs(c8.b - wanted.z)});
        ++compared;
      }
    }
    CAPTURE(lights, coloured, textured, highlight == Highlight::kPhong, shading, format);
    CHECK(worst <= most);
    CHECK(compared > 300);
  }
}
