// SPDX-License-Identifier: MIT
// Meshes that pose their vertices, drawn with every source of vertices, clipped and in bands.
#include <arcspan/animate/pose.hpp>
#include <arcspan/animate/skinned_mesh.hpp>
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>

#include <catch2/catch.hpp>
#include <tests/support/animated_rig.hpp>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Frame = hal::Framebuffer<Rgb565>;
using Light = Illumination<1, Highlight::kBlinn>;
constexpr std::int32_t kSize = 96;

/// The posed vertices of another mesh, kept in memory.
struct KeptMesh {
  template <class Mesh>
  explicit KeptMesh(const Mesh& mesh) : triangles(mesh.view()) {
    for (std::size_t i = 0; i < triangles.vertex_count(); ++i) {
      positions.push_back(mesh.position(i));
      directions.push_back(mesh.direction(i));
    }
  }
  [[nodiscard]] const MeshView& view() const { return triangles; }
  [[nodiscard]] ObjectPosition position(std::size_t i) const { return positions.at(i); }
  [[nodiscard]] Direction direction(std::size_t i) const { return directions.at(i); }

  MeshView triangles;
  std::vector<ObjectPosition> positions;
  std::vector<Direction> directions;
};

struct Scene {
  Scene() {
    Rig rig = tube(5, 4, 40000, 4000, 1);
    rig.clips.push_back(bending(rig, Interpolation::kLinear, 25));
    file = rig.file();
    StoredModel model;
    REQUIRE(ok(view_model_binary(file, model)));
    REQUIRE(ok(view_animation(model, animation)));
    part = model.part(0);
    REQUIRE(ok(pose_nodes(animation, {{animation.clip(0), 700'000}, {}, 0}, nodes)));
    REQUIRE(ok(pose_joints(animation.skin(0), nodes, joints)));
    REQUIRE(ok(SkinnedMesh::make(part.mesh, animation, 0, joints, mesh)));
    place(-60000);
    const DirectionalLight sun{normalised(2, 3, 4), Coefficient::of(1.0)};
    REQUIRE(ok(Light::make(part.material, {sun}, normalised(0, 0, 1), light)));
  }
  /// Moves the mesh along the view.
  void place(std::int32_t z) {
    Placement placement{Rotation::about_y({4000}), {}};
    placement.translation[2] = ObjectLength::from_raw(z * 256);
    REQUIRE(ok(ClipTransform::make(placement,
                                   {PixelLength::of(kSize), ObjectLength::of(4000), ObjectLength::of(200000)},
                                   {kSize, kSize}, transform)));
  }

  Bytes file;
  StoredAnimation animation;
  ModelPart part;
  NodeMatrix nodes[6];
  JointMatrix joints[5];
  SkinnedMesh mesh;
  ClipTransform transform;
  Light light;
};

/// The pixels of a picture in bands of so many rows.
template <class Method, class Mesh, class Source>
std::vector<std::uint16_t> drawn(const Scene& scene, const Mesh& mesh, Source&& source,
                                 std::int32_t rows = kSize) {
  std::vector<std::uint16_t> picture;
  std::vector<std::uint16_t> depths(DepthBuffer::words(kSize, rows));
  std::vector<Frame::Word> words(Frame::words(kSize, rows));
  for (std::int32_t top = 0; top < kSize; top += rows) {
    Frame frame(words, kSize, rows);
    DepthBuffer depth(depths, kSize, rows);
    frame.move_to(top);
    depth.move_to(top);
    frame.clear({});
    depth.clear();
    CHECK(ok(draw_mesh<Method>(mesh, scene.transform, scene.light, frame, depth, source).status));
    picture.insert(picture.end(), words.begin(), words.end());
  }
  return picture;
}

template <class Method>
void check_pictures(const Scene& scene) {
  const KeptMesh kept(scene.mesh);
  const auto truth = drawn<Method>(scene, kept, NoCache{});
  CHECK(truth != std::vector<std::uint16_t>(truth.size()));
  CHECK(truth != drawn<Method>(scene, scene.part.mesh, NoCache{}));
  CHECK(truth == drawn<Method>(scene, scene.mesh, NoCache{}));
  std::vector<CachedVertex<Method>> vertices(scene.part.mesh.vertex_count());
  std::vector<TriangleRows> rows(TriangleRows::entries(scene.part.mesh.triangle_count()));
  CHECK(truth == drawn<Method>(scene, scene.mesh, VertexCache<Method>(vertices)));
  CHECK(truth == drawn<Method>(scene, scene.mesh, VertexCache<Method>(vertices, rows), 24));
  VertexCache<Method> filled(vertices, rows);
  REQUIRE(ok(filled.fill(scene.mesh, scene.transform, scene.light)));
  CHECK(truth == drawn<Method>(scene, scene.mesh, filled, 32));
  CHECK(drawn<Method>(scene, scene.mesh, NoCache{}, 8) == truth);
}

}  // namespace

TEST_CASE("a skinned mesh is drawn where its vertices are, with every source of vertices") {
  Scene scene;
  check_pictures<Gouraud<Light>>(scene);
  check_pictures<Flat<Light>>(scene);  // its normals are those of posed faces
}

TEST_CASE("a skinned mesh is clipped where its vertices are") {
  Scene scene;
  scene.place(-14000);
  check_pictures<Gouraud<Light>>(scene);
}

TEST_CASE("the planes of a mesh are not used where it is posed") {
  Scene scene;
  std::vector<FacePlane> planes(scene.part.mesh.triangle_count(), FacePlane{0, 0, 127, 0});
  MeshView mesh = scene.part.mesh;
  REQUIRE(ok(mesh.attach(planes, {0, 16, 65535})));  // as if all faced the same way
  SkinnedMesh skinned;
  REQUIRE(ok(SkinnedMesh::make(mesh, scene.animation, 0, scene.joints, skinned)));
  CHECK(drawn<Gouraud<Light>>(scene, skinned, NoCache{}) ==
        drawn<Gouraud<Light>>(scene, scene.mesh, NoCache{}));
}
