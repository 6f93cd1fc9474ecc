// SPDX-License-Identifier: MIT
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <tests/golden/fixed_file.hpp>

#include <cstring>
#include <string_view>
#include <type_traits>

namespace arcspan::test {
namespace {

constexpr std::string_view kMagic = "arcspan fixed mesh 1\n";

template <class T>
void append(std::string& out, const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  const auto count = static_cast<std::uint32_t>(values.size());
  out.append(reinterpret_cast<const char*>(&count), sizeof count);
  out.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

void take_bytes(std::string_view& in, void* to, std::size_t size) {
  if (in.size() < size) throw tools::Failure("fixed mesh", "truncated");
  std::memcpy(to, in.data(), size);
  in.remove_prefix(size);
}

template <class T>
std::vector<T> take(std::string_view& in) {
  std::uint32_t count = 0;
  take_bytes(in, &count, sizeof count);
  if (in.size() / sizeof(T) < count) throw tools::Failure("fixed mesh", "truncated");
  std::vector<T> values(count);
  take_bytes(in, static_cast<void*>(values.data()), count * sizeof(T));
  return values;
}

}  // namespace

void write_fixed(const tools::FixedMesh& mesh, const std::filesystem::path& path) {
  std::string out(kMagic);
  append(out, std::vector<double>{mesh.unit, mesh.centre.x, mesh.centre.y, mesh.centre.z});
  append(out, mesh.positions);
  append(out, mesh.normals);
  append(out, mesh.indices);
  tools::write_whole_file(path, out);
}

tools::FixedMesh read_fixed(const std::filesystem::path& path) {
  const std::string bytes = tools::read_whole_file(path, std::size_t{64} << 20);
  std::string_view in = bytes;
  if (!in.starts_with(kMagic)) throw tools::Failure(path.string(), "not a fixed mesh");
  in.remove_prefix(kMagic.size());
  const std::vector<double> place = take<double>(in);
  if (place.size() != 4) throw tools::Failure(path.string(), "not a fixed mesh");
  tools::FixedMesh mesh;
  mesh.unit = place[0];
  mesh.centre = {place[1], place[2], place[3]};
  mesh.positions = take<ObjectPosition>(in);
  mesh.normals = take<PackedNormal>(in);
  mesh.indices = take<std::uint16_t>(in);
  return mesh;
}

}  // namespace arcspan::test
