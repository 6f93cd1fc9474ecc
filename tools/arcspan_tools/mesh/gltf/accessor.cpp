// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/gltf/accessor.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <string_view>

namespace arcspan::tools {
namespace {

constexpr std::int64_t kMostByteOffset = 0x7FFFFFFF;
/// Elements of an accessor: three for each of the most triangles, and vertices that they leave over.
constexpr std::int64_t kMostElements = 1 << 22;

/// A number type: its bytes, and how they are read.
struct ComponentType {
  std::size_t bytes = 1;
  bool is_signed = false;
  bool is_float = false;
};

ComponentType component_type(const JsonView& json) {
  switch (json.integer(0, 0xFFFF)) {
    case 5120:
      return {1, true, false};
    case 5121:
      return {1, false, false};
    case 5122:
      return {2, true, false};
    case 5123:
      return {2, false, false};
    case 5125:
      return {4, false, false};
    case 5126:
      return {4, true, true};
    default:
      json.fail("is not a component type");
  }
}

std::size_t components_of(const JsonView& json) {
  const std::string name = json.text();
  if (name == "SCALAR") return 1;
  if (name == "VEC2") return 2;
  if (name == "VEC3") return 3;
  if (name == "VEC4" || name == "MAT2") return 4;
  if (name == "MAT3") return 9;
  if (name == "MAT4") return 16;
  json.fail("'" + name + "' is not a type of element");
}

double read_number(std::string_view bytes, std::size_t at, ComponentType type, bool normalised) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < type.bytes; ++i) {
    bits |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  }
  if (type.is_float) return double{std::bit_cast<float>(bits)};
  const int width = static_cast<int>(8 * type.bytes);
  const double range = std::ldexp(1.0, width);
  double value = bits;
  if (type.is_signed && value >= range / 2) value -= range;
  if (!normalised) return value;
  return type.is_signed ? std::max(value / (range / 2 - 1), -1.0) : value / (range - 1);
}

/// Where numbers lie and how.
struct ElementLayout {
  std::string_view bytes;
  std::size_t stride = 0;
  std::size_t components = 1;
  ComponentType type;
  bool normalised = false;

  void require(std::size_t count, const JsonView& owner) const {
    const std::size_t last = components * type.bytes;
    if (count > 0 &&
        (last > bytes.size() || (count - 1) > (bytes.size() - last) / std::max(stride, std::size_t{1}))) {
      owner.fail("reaches beyond its buffer view");
    }
  }
  void read(std::size_t i, double* values) const {
    for (std::size_t c = 0; c < components; ++c) {
      values[c] = read_number(bytes, i * stride + c * type.bytes, type, normalised);
    }
  }
};

/// The layout that `place`, an accessor or a part of a sparse one, says. `owner` states the stride in 1.0.
ElementLayout layout_of(GltfFile& file, const JsonView& place, ComponentType type, std::size_t components,
                        bool normalised) {
  const JsonView view = file.element("bufferViews", place.at("bufferView"));
  const auto offset = static_cast<std::size_t>(place.integer_or("byteOffset", 0, 0, kMostByteOffset));
  const JsonView& strided = file.version() == 1 ? place : view;
  auto stride = static_cast<std::size_t>(strided.integer_or("byteStride", 0, 0, 0xFFFF));
  if (stride == 0) stride = components * type.bytes;
  return {file.view_bytes(view, offset), stride, components, type, normalised};
}

void read_sparse(GltfFile& file, const JsonView& sparse, ComponentType type, bool normalised,
                 AccessorData& data) {
  const JsonView indices = sparse.at("indices");
  const JsonView values = sparse.at("values");
  const auto count = static_cast<std::size_t>(sparse.at("count").integer(0, kMostElements));
  const ElementLayout places =
      layout_of(file, indices, component_type(indices.at("componentType")), 1, false);
  const ElementLayout numbers = layout_of(file, values, type, data.components, normalised);
  places.require(count, indices);
  numbers.require(count, values);
  for (std::size_t i = 0; i < count; ++i) {
    double at = 0;
    places.read(i, &at);
    if (!(at >= 0 && at < static_cast<double>(data.count()))) indices.fail("an index is out of range");
    numbers.read(i, data.values.data() + static_cast<std::size_t>(at) * data.components);
  }
}

}  // namespace

AccessorData read_accessor(GltfFile& file, const JsonView& id, std::size_t least, std::size_t most) {
  const JsonView accessor = file.element("accessors", id);
  const ComponentType type = component_type(accessor.at("componentType"));
  const auto count = static_cast<std::size_t>(accessor.at("count").integer(0, kMostElements));
  const std::optional<JsonView> normalised = accessor.find("normalized");
  const bool is_normalised = normalised && normalised->truth();
  AccessorData data;
  data.components = components_of(accessor.at("type"));
  if (data.components < least || data.components > most) {
    accessor.at("type").fail("elements of " + std::to_string(data.components) +
                             " components do not fit here");
  }
  data.values.resize(count * data.components);
  if (accessor.find("bufferView")) {
    const ElementLayout layout = layout_of(file, accessor, type, data.components, is_normalised);
    layout.require(count, accessor);
    for (std::size_t i = 0; i < count; ++i) layout.read(i, data.values.data() + i * data.components);
  }
  if (const std::optional<JsonView> sparse = accessor.find("sparse")) {
    read_sparse(file, *sparse, type, is_normalised, data);
  }
  return data;
}

}  // namespace arcspan::tools
