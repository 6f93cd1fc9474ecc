// SPDX-License-Identifier: MIT
// Joints, clips and morph targets of Collada, FBX and 3DS files. Poses are compared with those of the same
// rig in glTF, with known places, and with poses computed in doubles from the loader library's own scene.
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/mesh/plain/rig_pose.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <catch2/catch.hpp>
#include <tests/tools/scene_rig.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <algorithm>
#include <filesystem>
#include <numeric>

using namespace arcspan::tools;
using namespace arcspan::test;

namespace {

Model model_of(const std::string& name, const std::string& text) {
  const TemporaryFolder folder;
  return load_model_file(folder.file(name, text));
}

Model in_pose(const Model& model, double time) {
  return posed(model, pose_at(*model.rig, model.rig->clips.at(0), time), "rig");
}

ColladaTube bending_collada() {
  ColladaTube tube;
  tube.channel("upper/turn.ANGLE", {0, .5f, 1, 2}, {0, 45, 90, 0});
  tube.channel("lower/move", {0, 2}, {0, 0, 0, 1, 0, 0});
  return tube;
}

/// Where the loader's own scene has the corners of triangles, in the order of nodes, meshes and faces.
class LibraryPoses {
 public:
  explicit LibraryPoses(const std::string& file)
      : scene_(importer_.ReadFile(file, aiProcess_Triangulate)), clip_(*scene_->mAnimations[0]) {}

  std::vector<Vec3> corners(double seconds) {
    ticks_ = seconds * (clip_.mTicksPerSecond > 0 ? clip_.mTicksPerSecond : 25);  // as 3DS means it
    std::vector<Vec3> all;
    visit(*scene_->mRootNode, all);
    return all;
  }

 private:
  void visit(const aiNode& node, std::vector<Vec3>& all) {
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
      const aiMesh& mesh = *scene_->mMeshes[node.mMeshes[m]];
      const std::vector<Vec3> places = mesh.mNumBones == 0 ? moved(mesh, global(&node)) : skinned(mesh);
      for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        for (unsigned k = 0; k < 3; ++k) all.push_back(places[mesh.mFaces[f].mIndices[k]]);
      }
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) visit(*node.mChildren[i], all);
  }

  static Vec3 vec3(const aiVector3D& v) { return {v.x, v.y, v.z}; }
  static Affine affine(const aiMatrix4x4& m) {
    return {{m.a1, m.b1, m.c1}, {m.a2, m.b2, m.c2}, {m.a3, m.b3, m.c3}, {m.a4, m.b4, m.c4}};
  }
  static std::vector<Vec3> moved(const aiMesh& mesh, const Affine& place) {
    std::vector<Vec3> places;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) places.push_back(place.point(vec3(mesh.mVertices[i])));
    return places;
  }
  std::vector<Vec3> skinned(const aiMesh& mesh) {
    std::vector<Vec3> places(mesh.mNumVertices);
    std::vector<double> sums(mesh.mNumVertices);  // Blender does not write weights whose sum is 1
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
      const aiBone& bone = *mesh.mBones[b];
      const Affine joint = global(scene_->mRootNode->FindNode(bone.mName)) * affine(bone.mOffsetMatrix);
      for (unsigned i = 0; i < bone.mNumWeights; ++i) {
        const auto& [vertex, weight] = bone.mWeights[i];
        places[vertex] = places[vertex] + joint.point(vec3(mesh.mVertices[vertex])) * weight;
        sums[vertex] += weight;
      }
    }
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) places[i] = places[i] * (1 / sums[i]);
    return places;
  }

  template <class Key, class Mix>
  auto at(const Key* keys, unsigned count, const Mix& mix) const {
    unsigned next = 0;
    while (next < count && keys[next].mTime <= ticks_) ++next;
    if (next == 0 || next == count) {
      const auto& value = keys[next == 0 ? 0 : count - 1].mValue;
      return mix(value, value, 0.);
    }
    const double from = keys[next - 1].mTime;
    return mix(keys[next - 1].mValue, keys[next].mValue, (ticks_ - from) / (keys[next].mTime - from));
  }

  Affine global(const aiNode* node) {
    const Affine own = local(*node);
    return node->mParent == nullptr ? own : global(node->mParent) * own;
  }
  Affine local(const aiNode& node) {
    for (unsigned i = 0; i < clip_.mNumChannels; ++i) {
      const aiNodeAnim& c = *clip_.mChannels[i];
      if (!(c.mNodeName == node.mName)) continue;
      const auto mixed = [](const aiVector3D& a, const aiVector3D& b, double t) {
        return vec3(a) * (1 - t) + vec3(b) * t;
      };
      const Quaternion q =
          at(c.mRotationKeys, c.mNumRotationKeys, [](const aiQuaternion& a, const aiQuaternion& b, double t) {
            return slerp(unit_length(Quaternion{a.x, a.y, a.z, a.w}),
                         unit_length(Quaternion{b.x, b.y, b.z, b.w}), t);
          });
      return NodeTransform{at(c.mPositionKeys, c.mNumPositionKeys, mixed), q,
                           at(c.mScalingKeys, c.mNumScalingKeys, mixed)}
          .affine();
    }
    return affine(node.mTransformation);
  }
  Assimp::Importer importer_{};
  const aiScene* scene_;
  const aiAnimation& clip_;
  double ticks_ = 0;
};

}  // namespace

TEST_CASE("scenes: a tube of Collada bends as the tube of glTF, in every unit and with every axis up") {
  GltfRig gltf = bending_tube();
  gltf.clip("bend");
  gltf.channel(2, "rotation", {0, .5f, 1, 2},
               gltf.quadruples(joined({turn_z(0), turn_z(45), turn_z(90), turn_z(0)})));
  gltf.channel(1, "translation", {0, 2}, gltf.vectors({0, 0, 0, 1, 0, 0}));
  const Model right = model_of("tube.glb", gltf.glb());
  ColladaTube tube = bending_collada();
  const Model plain = model_of("tube.dae", tube.text());
  CHECK(plain.warnings.empty());
  REQUIRE(plain.rig->clips.size() == 1);
  CHECK(plain.rig->clips[0].duration() == Approx(2));
  tube.unit = "0.01";
  tube.up = "Z_UP";
  const Model turned = model_of("tube.dae", tube.text());
  for (const double time : {0., .25, .5, .8, 1., 1.7, 2.}) {
    CAPTURE(time);
    const MeshData a = in_pose(right, time).parts.at(0).mesh;
    const MeshData b = in_pose(plain, time).parts.at(0).mesh;
    const MeshData c = in_pose(turned, time).parts.at(0).mesh;
    REQUIRE(a.triangles == b.triangles);
    REQUIRE(a.triangles == c.triangles);
    for (std::size_t i = 0; i < a.positions.size(); ++i) {
      const Vec3& p = a.positions[i];
      CHECK(length(b.positions[i] - p) < 2e-6);
      CHECK(length(c.positions[i] * 100 - Vec3{p.x, p.z, -p.y}) < 4e-6);
      CHECK(length(b.normals[i] - a.normals[i]) < 2e-6);
    }
  }
  // A corner of the upper end, turned by 90 degrees about (0, 1) and moved by 1/2.
  const std::vector<Vec3> bent = in_pose(plain, 1).parts[0].mesh.positions;
  CHECK(std::any_of(bent.begin(), bent.end(), [](Vec3 p) { return length(p - Vec3{-.5, 1.2, .2}) < 2e-6; }));
}

TEST_CASE("scenes: of five weights the four largest are kept, and a vertex without one follows its mesh") {
  ColladaTube tube = bending_collada();
  tube.weights[0] = {{0, .1f}, {1, .3f}, {2, .2f}, {3, .05f}, {4, .35f}};
  tube.weights[1] = {};
  const Model model = model_of("tube.dae", tube.text());
  CHECK(model.warnings == std::vector<std::string>{"left out: weights above four for a vertex (1)"});
  const auto found = std::find_if(model.rig->vertices.begin(), model.rig->vertices.end(),
                                  [](const RigVertex& v) { return v.weights[3] > 0; });
  REQUIRE(found != model.rig->vertices.end());
  CHECK(found->joints == std::array<std::size_t, 4>{4, 1, 2, 0});
  CHECK(found->weights[0] == Approx(.35 / .95));
  CHECK(std::accumulate(found->weights.begin(), found->weights.end(), 0.0) == Approx(1));
  const std::vector<Vec3> bent = in_pose(model, 1).parts[0].mesh.positions;
  CHECK(std::any_of(bent.begin(), bent.end(), [](Vec3 p) { return length(p - Vec3{49.4, 0, .6}) < 1e-4; }));
}

TEST_CASE("scenes: FBX with pivots, a rotation before others, axes, units and a morph target") {
  const Model model = model_of("plate.fbx", fbx_plate());
  CHECK(model.warnings.empty());
  REQUIRE(model.rig->clips.size() == 1);
  CHECK(model.rig->clips[0].name == "spin");
  CHECK(model.rig->clips[0].duration() == 2);
  // The loader library makes six nodes of one with a pivot. Those up to the rotation become one node; the
  // node that moves back by the pivot stays.
  CHECK(model.rig->nodes.size() == 3);
  CHECK(model.rig->clips[0].channels.size() == 2);  // what keeps its place at rest has none
  const auto corners = [&](double time) {
    const MeshData mesh = in_pose(model, time).parts.at(0).mesh;
    std::vector<Vec3> places;
    for (const std::uint32_t i : mesh.triangles.at(0)) places.push_back(mesh.positions[i]);
    return places;
  };
  for (const auto& [time, degrees] :
       std::vector<std::pair<double, double>>{{0, 90}, {.5, 135}, {1, 180}, {1.5, 315}, {2, 450}}) {
    CAPTURE(time);
    const std::vector<Vec3> found = corners(time);
    const double c = std::cos(degrees * kDegree);
    const double s = std::sin(degrees * kDegree);
    // (x, y, z) is (x, z, -y) in centimetres.
    CHECK(length(found[0] * 100 - Vec3{110 - 100 * c, 0, 100 * s}) < 1e-3);
    CHECK(length(found[1] * 100 - Vec3{110, 25 * time, 0}) < 1e-3);
    CHECK(length(found[2] * 100 - Vec3{110 - 100 * c - 100 * s, 0, 100 * s - 100 * c}) < 1e-3);
  }
}

/// fbx_plate() with one text in place of another.
std::string changed(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

/// The corners of the first triangle at a time, in centimetres with z up.
std::array<Vec3, 3> plate_corners(const Model& model, double time) {
  const MeshData mesh = in_pose(model, time).parts.at(0).mesh;
  std::array<Vec3, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 p = mesh.positions[mesh.triangles.at(0)[i]] * 100;
    corners[i] = {p.x, -p.z, p.y};
  }
  return corners;
}

TEST_CASE("scenes: clips of FBX move nodes with rotations before and after their own, as of Maya's joints") {
  const std::string pivot = "P: \"RotationPivot\", \"Vector3D\", \"Vector\", \"\",100,0,0\n";
  const std::string after = "P: \"PostRotation\", \"Vector3D\", \"Vector\", \"\",0,0,";
  for (const int post : {0, 90, 30}) {
    CAPTURE(post);
    const std::string rotation = post == 0 ? "" : after + std::to_string(post) + "\n";
    const Model model = model_of("plate.fbx", changed(fbx_plate(), pivot, rotation));
    CHECK(model.warnings.empty());
    for (const auto& [time, degrees] :
         std::vector<std::pair<double, double>>{{0, 0}, {.5, 45}, {1, 90}, {1.5, 225}, {2, 360}}) {
      CAPTURE(time);
      const auto found = plate_corners(model, time);
      const double c = 100 * std::cos((90 + degrees - post) * kDegree);
      const double s = 100 * std::sin((90 + degrees - post) * kDegree);
      CHECK(length(found[0] - Vec3{10, 0, 0}) < 1e-3);
      CHECK(length(found[1] - Vec3{10 + c, s, 25 * time}) < 1e-3);
      CHECK(length(found[2] - Vec3{10 - s, c, 0}) < 1e-3);
    }
  }
}

TEST_CASE("scenes: a morph target of FBX goes on at the keys of another") {
  std::string text = changed(fbx_plate(), " Model: 20,", R"( Geometry: 15, "Geometry::sunk", "Shape" {
  Version: 100
  Indexes: *1 { a: 0 }
  Vertices: *3 { a: 0,0,-80 }
  Normals: *3 { a: 0,0,0 }
 }
 Deformer: 16, "SubDeformer::sunk", "BlendShapeChannel" {
  Version: 100
  DeformPercent: 0
  FullWeights: *1 { a: 100 }
 }
 AnimationCurveNode: 34, "AnimCurveNode::DeformPercent", "" {
  Properties70: {
   P: "d|DeformPercent", "Number", "", "A",0
  }
 }
 AnimationCurve: 42, "AnimCurve::", "" {
  KeyTime: *2 { a: 23093079000,46186158000 }
  KeyValueFloat: *2 { a: 100,50 }
 }
 Model: 20,)");
  text = changed(text, " C: \"OP\",33,13",
                 " C: \"OO\",16,12\n C: \"OO\",15,16\n C: \"OO\",34,31\n C: \"OP\",34,16, \"DeformPercent\"\n"
                 " C: \"OP\",42,34, \"d|DeformPercent\"\n C: \"OP\",33,13");
  const Model model = model_of("plate.fbx", text);
  CHECK(model.warnings.empty());
  // The first target has keys at 0 and 2, the second at .5 and 1.
  for (const auto& [time, low] : std::vector<std::pair<double, double>>{
           {0, -80}, {.25, -80}, {.5, -80}, {.75, -60}, {1, -40}, {2, -40}}) {
    CAPTURE(time);
    const auto found = plate_corners(model, time);
    CHECK(found[0].z == Approx(low).margin(1e-3));
    CHECK(found[1].z == Approx(25 * time).margin(1e-3));
  }
}

TEST_CASE("scenes: a skin of FBX holds the mesh where the geometric transform of 3ds Max puts it") {
  const std::string ones = "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1";
  std::string text = changed(fbx_plate(), " Model: 20,", R"( Deformer: 50, "Deformer::skin", "Skin" {
  Version: 101
 }
 Deformer: 51, "SubDeformer::bone", "Cluster" {
  Version: 100
  Indexes: *3 { a: 0,1,2 }
  Weights: *3 { a: 1,1,1 }
  Transform: *16 { a: )" + ones + R"( }
  TransformLink: *16 { a: )" + ones + R"( }
 }
 Model: 52, "Model::bone", "LimbNode" {
  Version: 232
 }
 Model: 20,)");
  text = changed(text, "P: \"RotationPivot\"",
                 "P: \"GeometricTranslation\", \"Vector3D\", \"Vector\", \"\",0,0,7\n"
                 "P: \"GeometricScaling\", \"Vector3D\", \"Vector\", \"\",2,1,1\nP: \"RotationPivot\"");
  text = changed(text, " C: \"OO\",12,10",
                 " C: \"OO\",50,10\n C: \"OO\",51,50\n C: \"OO\",52,51\n C: \"OO\",52,0\n C: \"OO\",12,10");
  const auto found = plate_corners(model_of("plate.fbx", text), 0);
  CHECK(length(found[0] - Vec3{0, 0, 7}) < 1e-3);
  CHECK(length(found[1] - Vec3{200, 0, 7}) < 1e-3);
  CHECK(length(found[2] - Vec3{0, 100, 7}) < 1e-3);
}

TEST_CASE("scenes: a texture of FBX is mapped by the set of texture coordinates that it names") {
  const auto set = [](int number, const std::string& name, const std::string& points) {
    const std::string i = std::to_string(number);
    return "  LayerElementUV: " + i + " {\n Version: 101\n Name: \"" + name +
           "\"\n MappingInformationType: \"ByPolygonVertex\"\n ReferenceInformationType: \"Direct\"\n"
           " UV: *6 { a: " +
           points + " }\n }\n  Layer: " + i +
           " {\n Version: 100\n LayerElement: {\n Type: \"LayerElementUV\"\n TypedIndex: " + i + "\n }\n" +
           (number == 0 ? " LayerElement: {\n Type: \"LayerElementMaterial\"\n TypedIndex: 0\n }\n" : "") +
           " }\n";
  };
  const std::string other = "0,0,0,0,0,0";
  const std::string named = "0,1,0.5,1,0,0.25";
  const std::string material =
      "  LayerElementMaterial: 0 {\n Version: 101\n Name: \"\"\n MappingInformationType: \"AllSame\"\n"
      " ReferenceInformationType: \"IndexToDirect\"\n Materials: *1 { a: 0 }\n }\n";
  const std::string plain =
      "  Vertices: *9 { a: 0,0,0,100,0,0,0,100,0 }\n"
      "  PolygonVertexIndex: *3 { a: 0,1,-3 }\n  GeometryVersion: 124\n";
  // The second mesh has the sets in the other order.
  std::string text =
      changed(fbx_plate(), "  GeometryVersion: 124\n",
              "  GeometryVersion: 124\n" + material + set(0, "light", other) + set(1, "skin", named));
  text = changed(text, " Model: 20,",
                 " Geometry: 60, \"Geometry::second\", \"Mesh\" {\n" + plain + material +
                     set(0, "skin", named) + set(1, "light", other) + R"( }
 Model: 61, "Model::second", "Mesh" {
  Version: 232
 }
 Material: 62, "Material::paint", "" {
  Version: 102
  ShadingModel: "phong"
 }
 Texture: 63, "Texture::paint", "" {
  Properties70: {
   P: "UVSet", "KString", "", "", "skin"
  }
  FileName: "paint.ppm"
  RelativeFilename: "paint.ppm"
 }
 Model: 20,)");
  text = changed(text, " C: \"OO\",12,10",
                 " C: \"OO\",61,0\n C: \"OO\",60,61\n C: \"OO\",62,61\n C: \"OO\",62,20\n"
                 " C: \"OP\",63,62, \"DiffuseColor\"\n C: \"OO\",12,10");
  const TemporaryFolder folder;
  (void)folder.file("paint.ppm", "P6 1 1 255\n\x9\x9\x9");
  const Model model = load_model_file(folder.file("plate.fbx", text));
  CHECK(model.warnings == std::vector<std::string>{});
  REQUIRE(model.parts.size() == 2);
  for (const ModelPart& part : model.parts) {
    REQUIRE(part.mesh.texture_points.size() == 3);
    std::vector<Uv> found;
    for (const std::uint32_t i : part.mesh.triangles.at(0)) found.push_back(part.mesh.texture_points[i]);
    CHECK(found == std::vector<Uv>{{0, 0}, {.5, 0}, {0, .75}});
  }
  // The scale of a texture is not drawn, and that is said.
  text = changed(text, "   P: \"UVSet\"",
                 "   P: \"Scaling\", \"Vector3D\", \"Vector\", \"\",2,2,1\n   P: \"UVSet\"");
  CHECK(load_model_file(folder.file("tiled.fbx", text)).warnings ==
        std::vector<std::string>{"left out: scales, shifts and turns of textures (2)"});
}

TEST_CASE("scenes: meshes and normals of FBX that cannot be read are left out, and a line says so") {
  const TemporaryFolder folder;
  const std::string file = folder.file("plate.fbx", changed(fbx_plate(), "a: 0,1,-3", "a: 0,9,-3"));
  CHECK(message_of<Failure>([&] { (void)load_model_file(file); }) ==
        file + ": no faces; left out: meshes with a face index out of range (1)");
  const std::string normals =
      "  LayerElementNormal: 0 {\n Version: 101\n Name: \"\"\n MappingInformationType: \"AllSame\"\n"
      " ReferenceInformationType: \"Direct\"\n Normals: *3 { a: 0,0,1 }\n }\n  Layer: 0 {\n Version: 100\n"
      " LayerElement: {\n Type: \"LayerElementNormal\"\n TypedIndex: 0\n }\n }\n";
  const std::string version = "  GeometryVersion: 124\n";
  CHECK(model_of("plate.fbx", changed(fbx_plate(), version, version + normals)).warnings ==
        std::vector<std::string>{"left out: normals and the like in an unknown order (1)"});
}

TEST_CASE("scenes: models of others are where the loader's own scene is in each frame") {
  const std::string folder = "/usr/share/assimp/models/";
  if (!std::filesystem::exists(folder)) return;
  struct Case {
    const char* file;
    double unit;
  };
  for (const Case& of :
       {Case{"FBX/huesitos.fbx", .01}, Case{"Collada/box_nested_animation.dae", 1},
        Case{"Collada/anims_with_full_rotations_between_keys.DAE", 1}, Case{"3DS/RotatingCube.3DS", 1}}) {
    CAPTURE(of.file);
    const Model model = load_model_file(folder + of.file);
    LibraryPoses library(folder + of.file);
    const double end = model.rig->clips.at(0).duration();
    for (int frame = 0; frame <= 40; ++frame) {
      const Model pose = in_pose(model, end * frame / 40);
      const std::vector<Vec3> right = library.corners(end * frame / 40);
      double extent = 0;
      for (const Vec3& p : right) extent = std::max(extent, length(p - right[0]) * of.unit);
      double worst = 0;
      std::size_t corner = 0;
      for (const ModelPart& part : pose.parts) {
        for (const auto& triangle : part.mesh.triangles) {
          // Triangles of nodes that mirror have two of their corners exchanged.
          Vec3 sum = part.mesh.positions[triangle[0]] + part.mesh.positions[triangle[1]] +
                     part.mesh.positions[triangle[2]];
          for (int k = 0; k < 3; ++k) sum = sum - right.at(corner++) * of.unit;
          worst = std::max(worst, length(sum) / 3);
        }
      }
      CHECK(corner == right.size());
      CHECK(worst < 2e-5 * extent);
    }
  }
}

TEST_CASE("scenes: what is wrong with an animation leaves it out, and a line says so") {
  ColladaTube tube;
  tube.channel("upper/turn.ANGLE", {0, 2000}, {0, 90});
  const Model model = model_of("tube.dae", tube.text());
  CHECK(model.rig->clips.empty());
  CHECK(model.warnings ==
        std::vector<std::string>{
            "the animation 'bend' is left out: the node 'upper': key 1 is not at a time of 0...1000 s"});
}

TEST_CASE("scenes: meshes and nodes that the loader does not find are left out, and a line says so") {
  const std::string text = ColladaTube().text();
  const auto with = [&text](const std::string& nodes) {
    std::string changed = text;
    return changed.insert(changed.find("</visual_scene>"), nodes);
  };
  const std::string gone = "<node id='gone'><instance_geometry url='#gone'/></node>";
  const std::string meshes = "left out: meshes that are not in the file or have shape keys of Collada";
  const Model model =
      model_of("tube.dae", with(gone + gone + "<node id='n'><instance_node url='#m'/></node>"));
  CHECK(model.warnings == std::vector<std::string>{meshes + " (2), nodes that are not in the file (1)"});
  CHECK(model.parts.size() == model_of("tube.dae", text).parts.size());

  std::string empty = text;
  empty.replace(empty.find("url='#skin'"), 11, "url='#gone'");
  const TemporaryFolder folder;
  const std::string file = folder.file("tube.dae", empty);
  CHECK(message_of<Failure>([&] { (void)load_model_file(file); }) == file + ": no faces; " + meshes + " (1)");
}

TEST_CASE("scenes: joints of a second skeleton with the names of the first are no silent exchange") {
  std::string text = ColladaTube().text();
  text.insert(text.find("</visual_scene>"),
              "<node\n  id='of_other'\tsid='upper'\n  type='JOINT'/><node id='of_a_third' sid=\"lower\" "
              "type=\"JOINT\"/>"
              "<node id='no_joint' sid='upper'/>");
  CHECK(model_of("tube.dae", text).warnings ==
        std::vector<std::string>{
            "left out: joints with the sid of another, which meshes follow in their place (2)"});
  const std::size_t begin = text.find("<instance_controller");
  const std::string end = "</instance_controller>";
  text.replace(begin, text.find(end) + end.size() - begin, "<instance_geometry url='#tube'/>");
  CHECK(model_of("tube.dae", text).warnings.empty());  // no mesh follows joints
}

TEST_CASE("scenes: FBX as a still model has materials, pictures in the file, and metres") {
  const std::string folder = "/usr/share/assimp/models/FBX/";
  if (!std::filesystem::exists(folder)) return;
  const Model phong = load_model_file(folder + "phong_cube.fbx");
  const FileMaterial& material = phong.parts.at(0).look.material;
  CHECK(material.colour == Vec3{.5, .25, .25});
  CHECK(length(material.specular.value() - Vec3{.125, .125, .25}) < 1e-6);
  CHECK(material.shininess == 10);
  CHECK(material.opacity == .5);
  CHECK(phong.rig == nullptr);
  const Model box = load_model_file(folder + "embedded_ascii/box_embedded_texture_fragmented.fbx");
  REQUIRE(box.parts.at(0).look.material.texture != nullptr);
  CHECK(box.parts[0].look.material.texture->name == "paper.png");
  double highest = 0;
  for (const Vec3& p : box.parts[0].mesh.positions) highest = std::max(highest, p.y);
  CHECK(highest == Approx(1));
  // Its pictures are not there; their names are those of a Windows machine.
  CHECK(load_model_file(folder + "spider.fbx")
            .warnings.at(0)
            .starts_with(
                "left out: textures (4): 'SpiderTex.jpg' (not in the model's folder), 'drkwood2.jpg' ("));
}

TEST_CASE("scenes: a Collada archive has its pictures in it, and numbers may follow blanks") {
  const std::string folder = "/usr/share/assimp/models/Collada/";
  if (!std::filesystem::exists(folder)) return;
  const Model duck = load_model_file(folder + "duck.zae");
  CHECK(duck.warnings.empty());
  CHECK(duck.parts.at(0).look.material.texture != nullptr);
  CHECK(load_model_file(folder + "library_animation_clips.dae").rig->clips.size() == 2);
}

TEST_CASE("scenes: files that are cut, or no files of their kind, are refused in one line that names them") {
  const TemporaryFolder folder;
  const auto refused = [&](const char* name, const std::string& bytes) {
    const std::string path = folder.file(name, bytes);
    const std::string message = message_of<Failure>([&] { (void)load_model_file(path); });
    CAPTURE(message);
    CHECK(message.starts_with(path + ": "));
    CHECK(message.find('\n') == std::string::npos);
    CHECK(message.find("::") == std::string::npos);
  };
  const std::string plate = fbx_plate();
  const std::string tube = bending_collada().text();
  for (std::size_t part = 1; part < 8; ++part) {
    refused("a.fbx", plate.substr(0, plate.size() * part / 12));
    refused("a.dae", tube.substr(0, tube.size() * part / 8));
  }
  for (const char* name : {"a.fbx", "a.dae", "a.zae"}) {
    refused(name, "Kaydara FBX Binary  ");
    refused(name,
            std::string("Kaydara FBX Binary  \0\x1a\0\xe8\x1c\0\0\xff\xff\xff\x7f\xff\xff\xff\x7f", 35));
    refused(name, "PK\3\4" + std::string(100, '\xff'));
  }
  std::string wrong = plate;
  wrong.replace(wrong.find("a: 0,1,-3"), 9, "a: 0,9,-3");
  refused("a.fbx", wrong);
  wrong = plate;
  wrong.replace(wrong.find("*9 { a: 0"), 9, "*9 { a: inf");
  refused("a.fbx", wrong);
}
