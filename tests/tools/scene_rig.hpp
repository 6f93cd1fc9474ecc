// SPDX-License-Identifier: MIT
#pragma once

#include <tests/tools/gltf_rig.hpp>

#include <string>
#include <utility>
#include <vector>

namespace arcspan::test {

template <class Numbers>
std::string listed(const Numbers& numbers, const char* between = " ") {
  std::string text;
  for (const auto number : numbers) text += (text.empty() ? "" : between) + std::to_string(number);
  return text;
}

/// Makes Collada files with the tube of bending_tube(), on the joints `lower` and `upper`, with the same node
/// of the mesh, which must not count.
class ColladaTube {
 public:
  std::string unit = "1";
  std::string up = "Y_UP";
  /// Joints and weights of each vertex; there are joints `a`, `b` and `c`, too, at the place of `upper`.
  std::vector<std::vector<std::pair<int, float>>> weights{};

  explicit ColladaTube(std::size_t rings = 9) : tube_(make_tube(rings)) {
    for (std::size_t i = 0; i < tube_.weights.size(); i += 4)
      weights.push_back({{0, tube_.weights[i]}, {1, tube_.weights[i + 1]}});
  }

  /// Adds keys of a property of a node: `upper/turn.ANGLE` is in degrees about z, `lower/move` and
  /// `lower/size` have x, y and z.
  void channel(const std::string& target, const Floats& times, const Floats& values) {
    const std::string name = "c" + std::to_string(++channels_);
    const bool is_angle = values.size() == times.size();
    const std::string kinds = [&] {
      std::string all;
      for (std::size_t i = 0; i < times.size(); ++i) all += " LINEAR";
      return all;
    }();
    animations_ +=
        source(name + "t", times, {"TIME"}) +
        source(name + "v", values,
               is_angle ? std::vector<std::string>{"ANGLE"} : std::vector<std::string>{"X", "Y", "Z"}) +
        "<source id='" + name + "k'><Name_array id='" + name + "ka' count='" + std::to_string(times.size()) +
        "'>" + kinds + "</Name_array><technique_common><accessor source='#" + name + "ka' count='" +
        std::to_string(times.size()) +
        "'><param name='INTERPOLATION' type='name'/></accessor></technique_common></source>" +
        "<sampler id='" + name + "s'><input semantic='INPUT' source='#" + name +
        "t'/><input semantic='OUTPUT' source='#" + name + "v'/><input semantic='INTERPOLATION' source='#" +
        name + "k'/></sampler><channel source='#" + name + "s' target='" + target + "'/>";
  }

  [[nodiscard]] std::string text() const {
    return "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' "
           "version='1.4.1'>"
           "<asset><unit meter='" +
           unit + "'/><up_axis>" + up + "</up_axis></asset><library_animations><animation name='bend'>" +
           animations_ + "</animation></library_animations>" + geometry() + skin() + R"(
<library_visual_scenes><visual_scene id='scene'>
<node id='lower' sid='lower' type='JOINT'><translate sid='move'>0 0 0</translate><scale sid='size'>1 1 1</scale>
<node id='upper' sid='upper' type='JOINT'><translate>0 1 0</translate><rotate sid='turn'> 0 0 1 0</rotate>
<node id='a' sid='a' type='JOINT'/><node id='b' sid='b' type='JOINT'/><node id='c' sid='c' type='JOINT'/>
</node></node>
<node id='tube-node'><translate>50 0 0</translate><scale>3 3 3</scale>
<instance_controller url='#skin'><skeleton>#lower</skeleton></instance_controller></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#scene'/></scene></COLLADA>)";
  }

 private:
  static std::string source(const std::string& id, const Floats& values,
                            const std::vector<std::string>& params) {
    std::string text =
        "<source id='" + id + "'><float_array id='" + id + "a' count='" + std::to_string(values.size()) +
        "'>" + listed(values) + "</float_array><technique_common><accessor source='#" + id + "a' count='" +
        std::to_string(values.size() / params.size()) + "' stride='" + std::to_string(params.size()) + "'>";
    for (const std::string& param : params) text += "<param name='" + param + "' type='float'/>";
    return text + "</accessor></technique_common></source>";
  }

  [[nodiscard]] std::string geometry() const {
    std::vector<unsigned> corners;
    for (const std::uint16_t i : tube_.indices) corners.insert(corners.end(), {i, i});
    return "<library_geometries><geometry id='tube' name='tube'><mesh>" +
           source("positions", tube_.positions, {"X", "Y", "Z"}) +
           source("normals", tube_.normals, {"X", "Y", "Z"}) +
           "<vertices id='vertices'><input semantic='POSITION' source='#positions'/></vertices>"
           "<triangles count='" +
           std::to_string(tube_.indices.size() / 3) +
           "'><input semantic='VERTEX' source='#vertices' offset='0'/>"
           "<input semantic='NORMAL' source='#normals' offset='1'/><p>" +
           listed(corners) + "</p></triangles></mesh></geometry></library_geometries>";
  }

  [[nodiscard]] std::string skin() const {
    Floats binds;
    for (int joint = 0; joint < 5; ++joint) {
      const float y = joint == 0 ? 0.f : -1.f;
      const Floats bind{1, 0, 0, 0, 0, 1, 0, y, 0, 0, 1, 0, 0, 0, 0, 1};
      binds.insert(binds.end(), bind.begin(), bind.end());
    }
    Floats values;
    std::vector<std::size_t> counts;
    std::vector<std::size_t> pairs;
    for (const auto& vertex : weights) {
      counts.push_back(vertex.size());
      for (const auto& [joint, weight] : vertex) {
        pairs.insert(pairs.end(), {static_cast<std::size_t>(joint), values.size()});
        values.push_back(weight);
      }
    }
    return "<library_controllers><controller id='skin'><skin source='#tube'>"
           "<bind_shape_matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>"
           "<source id='names'><Name_array id='namesa' count='5'>lower upper a b "
           "c</Name_array><technique_common>"
           "<accessor source='#namesa' count='5'><param name='JOINT' "
           "type='name'/></accessor></technique_common>"
           "</source><source id='binds'><float_array id='bindsa' count='80'>" +
           listed(binds) +
           "</float_array><technique_common><accessor source='#bindsa' count='5' stride='16'>"
           "<param name='TRANSFORM' type='float4x4'/></accessor></technique_common></source>" +
           source("weights", values, {"WEIGHT"}) +
           "<joints><input semantic='JOINT' source='#names'/>"
           "<input semantic='INV_BIND_MATRIX' source='#binds'/></joints><vertex_weights count='" +
           std::to_string(counts.size()) +
           "'><input semantic='JOINT' source='#names' offset='0'/>"
           "<input semantic='WEIGHT' source='#weights' offset='1'/><vcount>" +
           listed(counts) + "</vcount><v>" + listed(pairs) +
           "</v></vertex_weights></skin></controller></library_controllers>";
  }

  Tube tube_;
  std::string animations_{};
  int channels_ = 0;
};

/// A triangle (0, 0, 0), (100, 0, 0), (0, 100, 0) as FBX text, in centimetres with z up. It turns about its
/// second corner, from 90 degrees on: by 90 degrees about z in a second and 270 in another. A morph target
/// lifts that corner by 50 in two seconds.
inline std::string fbx_plate() {
  const auto curve = [](int id, const std::vector<long long>& seconds, const std::vector<int>& values) {
    std::vector<long long> times;
    for (const long long s : seconds) times.push_back(s * 46186158000);
    const std::string count = std::to_string(times.size());
    return "AnimationCurve: " + std::to_string(id) +
           ", \"AnimCurve::\", \"\" {\n Default: 0\n KeyVer: 4008\n KeyTime: *" + count +
           " { a: " + listed(times, ",") + " }\n KeyValueFloat: *" + count + " { a: " + listed(values, ",") +
           " }\n KeyAttrFlags: *1 { a: 24836 }\n KeyAttrDataFloat: *4 { a: 0,0,255790911,0 }\n "
           "KeyAttrRefCount: *1 { a: " +
           count + " }\n}\n";
  };
  return R"(; FBX 7.4.0 project file
FBXHeaderExtension: {
 FBXHeaderVersion: 1003
 FBXVersion: 7400
}
GlobalSettings: {
 Version: 1000
 Properties70: {
  P: "UpAxis", "int", "Integer", "",2
  P: "UpAxisSign", "int", "Integer", "",1
  P: "FrontAxis", "int", "Integer", "",1
  P: "FrontAxisSign", "int", "Integer", "",-1
  P: "CoordAxis", "int", "Integer", "",0
  P: "CoordAxisSign", "int", "Integer", "",1
  P: "UnitScaleFactor", "double", "Number", "",1
  P: "TimeMode", "enum", "", "",11
 }
}
Objects: {
 Geometry: 10, "Geometry::plate", "Mesh" {
  Vertices: *9 { a: 0,0,0,100,0,0,0,100,0 }
  PolygonVertexIndex: *3 { a: 0,1,-3 }
  GeometryVersion: 124
 }
 Geometry: 11, "Geometry::lifted", "Shape" {
  Version: 100
  Indexes: *1 { a: 1 }
  Vertices: *3 { a: 0,0,50 }
  Normals: *3 { a: 0,0,0 }
 }
 Deformer: 12, "Deformer::shapes", "BlendShape" {
  Version: 100
 }
 Deformer: 13, "SubDeformer::lifted", "BlendShapeChannel" {
  Version: 100
  DeformPercent: 0
  FullWeights: *1 { a: 100 }
 }
 Model: 20, "Model::plate", "Mesh" {
  Version: 232
  Properties70: {
   P: "RotationPivot", "Vector3D", "Vector", "",100,0,0
   P: "RotationActive", "bool", "", "",1
   P: "PreRotation", "Vector3D", "Vector", "",0,0,90
   P: "Lcl Translation", "Lcl Translation", "", "A",10,0,0
  }
 }
 AnimationStack: 30, "AnimStack::spin", "" {
  Properties70: {
   P: "LocalStop", "KTime", "Time", "",92372316000
   P: "ReferenceStop", "KTime", "Time", "",92372316000
  }
 }
 AnimationLayer: 31, "AnimLayer::base", "" { }
 AnimationCurveNode: 32, "AnimCurveNode::R", "" {
  Properties70: {
   P: "d|X", "Number", "", "A",0
   P: "d|Y", "Number", "", "A",0
   P: "d|Z", "Number", "", "A",0
  }
 }
 AnimationCurveNode: 33, "AnimCurveNode::DeformPercent", "" {
  Properties70: {
   P: "d|DeformPercent", "Number", "", "A",0
  }
 }
)" + curve(40, {0, 1, 2}, {0, 90, 360}) +
         curve(41, {0, 2}, {0, 100}) + R"(}
Connections: {
 C: "OO",20,0
 C: "OO",10,20
 C: "OO",12,10
 C: "OO",13,12
 C: "OO",11,13
 C: "OO",31,30
 C: "OO",32,31
 C: "OO",33,31
 C: "OP",32,20, "Lcl Rotation"
 C: "OP",33,13, "DeformPercent"
 C: "OP",40,32, "d|Z"
 C: "OP",41,33, "d|DeformPercent"
}
)";
}

}  // namespace arcspan::test
