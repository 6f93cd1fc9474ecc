// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/generate.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace arcspan::tools {
namespace {

constexpr double kTubeRadius = 0.4;

// cos and sin of i/n of a turn, exact in the eight main directions whatever the library's last bit is.
struct CosineAndSine {
  double cosine;
  double sine;
};
CosineAndSine direction(std::int32_t i, std::int32_t n) {
  const double angle = 2 * std::numbers::pi * i / n;
  const auto tidy = [](double v) { return std::fabs(v) < 1e-15 ? 0.0 : v; };
  return {tidy(std::cos(angle)), tidy(std::sin(angle))};
}

std::int64_t vertex_count(const GeneratedMesh& mesh) {
  const std::int64_t around = mesh.around;
  const std::int64_t along = mesh.along;
  return mesh.kind == GeneratedMesh::Kind::kSphere ? around * (along - 1) + 2 : around * along;
}

// Two triangles between corner a and the one diagonal from it, counter-clockwise seen from outside.
void add_quad(MeshData& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

void add_vertex(MeshData& mesh, Vec3 position, Vec3 normal) {
  mesh.positions.push_back(position);
  mesh.normals.push_back(normal);
}

MeshData sphere(std::int32_t around, std::int32_t bands) {
  MeshData mesh;
  add_vertex(mesh, {0, 1, 0}, {0, 1, 0});
  for (std::int32_t band = 1; band < bands; ++band) {
    const CosineAndSine polar = direction(band, 2 * bands);
    for (std::int32_t i = 0; i < around; ++i) {
      const CosineAndSine turn = direction(i, around);
      const Vec3 point{polar.sine * turn.sine, polar.cosine, polar.sine * turn.cosine};
      add_vertex(mesh, point, point);
    }
  }
  add_vertex(mesh, {0, -1, 0}, {0, -1, 0});
  const auto ring = [&](std::int32_t band, std::int32_t i) {
    return static_cast<std::uint32_t>(1 + (band - 1) * around + i % around);
  };
  const auto south = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  for (std::int32_t i = 0; i < around; ++i) {
    mesh.triangles.push_back({0, ring(1, i), ring(1, i + 1)});
    for (std::int32_t band = 1; band + 1 < bands; ++band) {
      add_quad(mesh, ring(band, i), ring(band + 1, i), ring(band + 1, i + 1), ring(band, i + 1));
    }
    mesh.triangles.push_back({ring(bands - 1, i), south, ring(bands - 1, i + 1)});
  }
  return mesh;
}

MeshData torus(std::int32_t around, std::int32_t tube) {
  MeshData mesh;
  for (std::int32_t i = 0; i < around; ++i) {
    const CosineAndSine turn = direction(i, around);
    for (std::int32_t j = 0; j < tube; ++j) {
      const CosineAndSine round = direction(j, tube);
      const Vec3 normal{round.cosine * turn.sine, round.sine, round.cosine * turn.cosine};
      const Vec3 centre{turn.sine, 0, turn.cosine};
      add_vertex(mesh, centre + normal * kTubeRadius, normal);
    }
  }
  const auto at = [&](std::int32_t i, std::int32_t j) {
    return static_cast<std::uint32_t>(i % around * tube + j % tube);
  };
  for (std::int32_t i = 0; i < around; ++i) {
    for (std::int32_t j = 0; j < tube; ++j)
      add_quad(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  }
  return mesh;
}

double turns(double sine, double cosine) { return std::atan2(sine, cosine) / (2 * std::numbers::pi); }

/// The texture point of a vertex; u may be any at a pole.
Uv texture_point(GeneratedMesh::Kind kind, const Vec3& p) {
  const double from_axis = std::hypot(p.x, p.z);
  const double u = 0.5 + turns(p.x, p.z);
  if (kind == GeneratedMesh::Kind::kSphere) return {u, 2 * turns(from_axis, p.y)};
  return {u, 0.5 - turns(p.y, from_axis - 1)};
}

/// `value` plus the whole number that brings it nearest to `other`: seams end within no triangle.
double nearest_turn(double value, double other) { return value + std::round(other - value); }

}  // namespace

RawModel generate_with_texture_points(const GeneratedMesh& wanted) {
  RawModel raw = to_raw(to_model(generate(wanted)));
  for (std::array<RawMesh::Corner, 3>& corners : raw.mesh.triangles) {
    const auto is_pole = [](const RawMesh::Corner& c) { return c.position.x == 0 && c.position.z == 0; };
    const std::size_t first = is_pole(corners[0]) ? 1 : 0;
    const Uv anchor = texture_point(wanted.kind, corners[first].position);
    double sum = 0;
    for (RawMesh::Corner& corner : corners) {
      const Uv own = texture_point(wanted.kind, corner.position);
      corner.texture_point = Uv{nearest_turn(own.u, anchor.u), nearest_turn(own.v, anchor.v)};
      if (!is_pole(corner)) sum += corner.texture_point->u;
    }
    // A pole lies between the other two corners of each of its triangles.
    for (RawMesh::Corner& corner : corners) {
      if (is_pole(corner)) corner.texture_point->u = sum / 2;
    }
  }
  return raw;
}

std::optional<GeneratedMesh> parse_generated_mesh(const std::string& name) {
  const std::size_t colon = name.find(':');
  const std::string_view kind = std::string_view(name).substr(0, colon);
  if (colon == std::string::npos || (kind != "sphere" && kind != "torus")) return std::nullopt;
  GeneratedMesh mesh;
  mesh.kind = kind == "sphere" ? GeneratedMesh::Kind::kSphere : GeneratedMesh::Kind::kTorus;
  const std::optional<Size> size = parse_size(std::string_view(name).substr(colon + 1));
  const std::int32_t least_along = mesh.kind == GeneratedMesh::Kind::kSphere ? 2 : 3;
  if (!size || size->width < 3 || size->height < least_along) {
    throw Failure(
        name, "expected " + std::string(kind) + ":AROUNDxALONG, at least 3x" + std::to_string(least_along));
  }
  mesh.around = size->width;
  mesh.along = size->height;
  if (vertex_count(mesh) > std::int64_t{kMaxVertices}) {
    throw Failure(name, "too many vertices (" + std::to_string(vertex_count(mesh)) + "; the limit is " +
                            std::to_string(kMaxVertices) + ")");
  }
  return mesh;
}

MeshData generate(const GeneratedMesh& wanted) {
  return wanted.kind == GeneratedMesh::Kind::kSphere ? sphere(wanted.around, wanted.along)
                                                     : torus(wanted.around, wanted.along);
}

}  // namespace arcspan::tools
