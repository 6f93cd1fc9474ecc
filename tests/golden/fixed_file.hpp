// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/fixed_point/fixed_mesh.hpp>

#include <filesystem>

namespace arcspan::test {

/// A file that holds a mesh converted to fixed point: builds without a mesh loader (32 bits, other compilers)
/// draw exactly the integers that the first build made. Written and read on machines of one byte order.
void write_fixed(const tools::FixedMesh& mesh, const std::filesystem::path& path);
[[nodiscard]] tools::FixedMesh read_fixed(const std::filesystem::path& path);

}  // namespace arcspan::test
