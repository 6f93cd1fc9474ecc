// SPDX-License-Identifier: MIT
#include <arcspan/model/model_binary.hpp>

#include <arcspan_tools/fixed_point/material.hpp>
#include <arcspan_tools/output/bytes.hpp>
#include <arcspan_tools/output/mesh_writer.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>
#include <bit>
#include <set>

namespace arcspan::tools {
namespace {

namespace layout = arcspan::model_binary;

void append(std::string& out, double value) { append_number(out, std::bit_cast<std::uint64_t>(value), 8); }

void append(std::string& out, const ChannelCoefficients& c) {
  for (const Coefficient channel : {c.r, c.g, c.b})
    append_number(out, static_cast<std::uint64_t>(channel.raw()), 2);
}

/// The bytes around the mesh binaries.
std::size_t bytes_around(std::size_t parts) {
  return layout::kHeaderBytes + parts * layout::kPartBytes + layout::kChecksumBytes;
}

void append_entry(std::string& out, const PartLook& look, std::string name, std::size_t begin,
                  std::size_t bytes) {
  const Material material = material_of(look);
  append_number(out, begin, 4);
  append_number(out, bytes, 4);
  for (const ChannelCoefficients& c : {material.ambient, material.diffuse, material.specular}) append(out, c);
  append_number(out, static_cast<std::uint64_t>(material.shininess), 2);
  append_number(out, std::uint64_t{look.material.two_sided ? layout::kTwoSided : std::uint16_t{0}}, 2);
  append_number(out, std::uint64_t{0}, 2);
  name.resize(layout::kNameBytes - 1);
  out += name + '\0';
}

std::string name_of(const PartLook& look, std::size_t number) {
  if (!look.names.empty()) return look.names.back();
  return look.material.name.empty() ? "part " + std::to_string(number) : look.material.name;
}

}  // namespace

Material material_of(const PartLook& look) { return to_fixed(with_material({}, look.material, {})); }

bool is_plain_mesh(const FixedModel& model) {
  FileMaterial named;
  named.name = model.looks[0].material.name;
  return model.meshes.size() == 1 && model.looks[0].material == named;
}

std::vector<std::string> part_names(const FixedModel& model) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < model.looks.size(); ++i) {
    const PartLook& look = model.looks[i];
    std::string name = name_of(look, i + 1);
    if (!taken.insert(name).second) {
      if (!look.material.name.empty() && look.material.name != name) name += " " + look.material.name;
      const std::string base = name;
      for (int n = 2; !taken.insert(name).second; ++n) name = base + " " + std::to_string(n);
    }
    names.push_back(name);
  }
  return names;
}

std::size_t model_bytes(CompiledOutput output, const FixedModel& model, bool planes) {
  std::size_t sum = 0;
  for (const FixedMesh& mesh : model.meshes) {
    sum += mesh_bytes(output, mesh.positions.size(), mesh.indices.size() / 3, planes);
  }
  if (is_plain_mesh(model)) return sum;
  const std::size_t parts = model.meshes.size();
  return sum + (output == CompiledOutput::kBinary ? bytes_around(parts) : parts * sizeof(Material));
}

std::string model_binary_file(const FixedModel& model) {
  if (is_plain_mesh(model)) return mesh_binary_file(model.meshes[0], figures_of(model.meshes[0]));
  constexpr std::size_t kMostParts = 0xFFFF;
  if (model.meshes.size() > kMostParts) throw Failure("model", "more than 65535 parts");
  const std::vector<std::string> names = part_names(model);
  std::string meshes;
  std::string entries;
  std::size_t most = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const FixedMesh& mesh = model.meshes[i];
    const std::string binary = mesh_binary_file(mesh, figures_of(mesh));
    append_entry(entries, model.looks[i], names[i], bytes_around(names.size()) + meshes.size(),
                 binary.size());
    meshes += binary;
    most = std::max(most, mesh.positions.size());
  }
  std::string out;
  append_number(out, layout::kMagic, 4);
  append_number(out, layout::kVersion, 2);
  append_number(out, names.size(), 2);
  append_number(out, bytes_around(names.size()) + meshes.size(), 4);
  append_number(out, most, 4);
  const FixedMesh& first = model.meshes[0];
  for (const double value : {first.unit, first.centre.x, first.centre.y, first.centre.z}) append(out, value);
  out += entries;
  append_checksum(out);
  return out + meshes;
}

}  // namespace arcspan::tools
