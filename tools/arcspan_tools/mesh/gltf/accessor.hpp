// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/gltf/gltf_file.hpp>
#include <arcspan_tools/support/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace arcspan::tools {

/// The numbers of an accessor, element after element.
struct AccessorData {
  std::size_t components = 1;  ///< of an element
  std::vector<double> values;  ///< integers that are normalised are 0...1 or -1...1

  [[nodiscard]] std::size_t count() const { return values.size() / components; }
  [[nodiscard]] Vec3 vec3(std::size_t i) const { return {element(i)[0], element(i)[1], element(i)[2]}; }
  [[nodiscard]] const double* element(std::size_t i) const { return values.data() + i * components; }
};

/// Reads the accessor that `id` refers to, sparse ones too; its elements must have `least` to `most`
/// components. Numbers are as they are in the file, and may be infinite. Throws a Failure.
[[nodiscard]] AccessorData read_accessor(GltfFile& file, const JsonView& id, std::size_t least,
                                         std::size_t most);

}  // namespace arcspan::tools
