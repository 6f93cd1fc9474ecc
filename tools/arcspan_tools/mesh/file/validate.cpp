// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/mesh/file/validate.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>

namespace arcspan::tools {

void TriangleCount::add_face(std::int64_t corners) {
  triangles_ += std::max<std::int64_t>(corners - 2, 0);
  if (triangles_ <= static_cast<std::int64_t>(kMaxTriangles)) return;
  throw Failure(subject_, "too many triangles (more than " + std::to_string(kMaxTriangles) + ", the limit)");
}

ScreenedMesh screened(std::string_view bytes, MeshFormat format, const std::string& subject,
                      const SideFiles& files) {
  if (bytes.find_first_not_of(" \t\r\n\0") == std::string_view::npos) throw Failure(subject, "empty file");
  switch (format) {
    case MeshFormat::kObj:
      return screened_obj(bytes, subject, files);
    case MeshFormat::kPly:
      return screened_ply(bytes, subject);
    case MeshFormat::kStl:
      return screened_stl(bytes, subject);
    case MeshFormat::kOff:
      return screened_off(bytes, subject);
    case MeshFormat::kGltf:
    case MeshFormat::kCollada:
    case MeshFormat::k3ds:
      break;
  }
  throw Failure(subject, "unknown format");
}

}  // namespace arcspan::tools
