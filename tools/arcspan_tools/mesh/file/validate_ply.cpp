// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/ply_header.hpp>
#include <arcspan_tools/mesh/file/validate.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <bit>
#include <charconv>
#include <cmath>

namespace arcspan::tools {
namespace {

void append_number(std::string& out, double value) {
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  out.append(text, end);
}

/// The numbers of a PLY body, one after the other, from text or from either byte order.
class PlyBody {
 public:
  PlyBody(TextLines& lines, PlyEncoding encoding)
      : lines_(lines), encoding_(encoding), bytes_(lines.rest()) {}

  /// Starts the next element; `what` names it in messages.
  void begin(std::string what) {
    what_ = std::move(what);
    word_ = 0;
    if (encoding_ == PlyEncoding::kText) lines_.next_words(what_);
  }

  double number(PlyType type) {
    const double value = encoding_ == PlyEncoding::kText ? lines_.number_at(word_++) : binary(type);
    if (!std::isfinite(value)) fail("a number that is not finite in " + what_);
    return value;
  }

  std::int64_t integer(PlyType type, std::int64_t most, const char* what) {
    const double value = number(type);
    if (value >= 0 && value <= static_cast<double>(most) && value == std::floor(value)) {
      return static_cast<std::int64_t>(value);
    }
    std::string text;
    append_number(text, value);
    fail(std::string(what) + " out of range (" + text + "; allowed are 0 to " + std::to_string(most) +
         ") in " + what_);
  }

  [[noreturn]] void fail(const std::string& what) const { lines_.fail(what); }

 private:
  double binary(PlyType type) {
    if (bytes_.size() < type.bytes) fail("the file ends before " + what_);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < type.bytes; ++i) {
      const std::size_t from = encoding_ == PlyEncoding::kBigEndian ? type.bytes - 1 - i : i;
      bits |= std::uint64_t{static_cast<unsigned char>(bytes_[from])} << (8 * i);
    }
    bytes_.remove_prefix(type.bytes);
    if (type.kind == PlyType::Kind::kFloat) {
      return type.bytes == 8 ? std::bit_cast<double>(bits)
                             : double{std::bit_cast<float>(static_cast<std::uint32_t>(bits))};
    }
    const double magnitude = static_cast<double>(bits);
    const double range = std::ldexp(1.0, 8 * type.bytes);
    return type.kind == PlyType::Kind::kSigned && magnitude >= range / 2 ? magnitude - range : magnitude;
  }

  TextLines& lines_;
  PlyEncoding encoding_;
  std::string_view bytes_;
  std::string what_;
  std::size_t word_ = 0;
};

std::size_t property_index(const PlyElement& element, std::string_view name) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    if (element.properties[i].name == name && !element.properties[i].count_type) return i;
  }
  return element.properties.size();
}

void skip(PlyBody& body, const PlyProperty& property) {
  constexpr std::int64_t kMostInList = 1 << 20;
  std::int64_t numbers = 1;
  if (property.count_type) numbers = body.integer(*property.count_type, kMostInList, "length of a list");
  for (std::int64_t i = 0; i < numbers; ++i) (void)body.number(property.type);
}

std::string nth(const PlyElement& element, std::int64_t i) {
  return element.name + " " + std::to_string(i + 1) + " of " + std::to_string(element.count);
}

struct PlyScreen {
  const PlyHeader& header;
  PlyBody body;
  std::string vertices{};
  std::string faces{};
  std::int64_t vertex_count = 0;
  std::int64_t face_count = 0;
  bool has_normals = false;

  void read_vertices(const PlyElement& element) {
    static constexpr const char* kNames[] = {"x", "y", "z", "nx", "ny", "nz"};
    std::size_t at[6];
    for (std::size_t i = 0; i < 6; ++i) at[i] = property_index(element, kNames[i]);
    const std::size_t none = element.properties.size();
    if (at[0] == none || at[1] == none || at[2] == none) body.fail("the vertices have no x, y and z");
    has_normals = at[3] != none && at[4] != none && at[5] != none;
    vertex_count = element.count;
    std::vector<double> values(element.properties.size());
    for (std::int64_t v = 0; v < element.count; ++v) {
      body.begin(nth(element, v));
      for (std::size_t p = 0; p < none; ++p) {
        if (element.properties[p].count_type) {
          skip(body, element.properties[p]);
        } else {
          values[p] = body.number(element.properties[p].type);
        }
      }
      for (std::size_t i = 0; i < (has_normals ? 6u : 3u); ++i) {
        append_number(vertices, values[at[i]]);
        vertices += ' ';
      }
      vertices += '\n';
    }
  }

  void read_face(const PlyElement& element) {
    for (const PlyProperty& property : element.properties) {
      if (!property.count_type || (property.name != "vertex_indices" && property.name != "vertex_index")) {
        skip(body, property);
        continue;
      }
      const std::int64_t corners = body.integer(*property.count_type, kMostCorners, "number of corners");
      std::string face = std::to_string(corners);
      for (std::int64_t c = 0; c < corners; ++c) {
        face += ' ' + std::to_string(body.integer(property.type, vertex_count - 1, "vertex index"));
      }
      if (corners < 3) continue;
      faces += face + '\n';
      ++face_count;
    }
  }

  void read(const PlyElement& element, const std::string& subject) {
    if (element.name == "vertex") return read_vertices(element);
    if (element.name == "face" && element.count > std::int64_t{kMaxTriangles}) {
      throw Failure(subject, "too many faces (" + std::to_string(element.count) + "; the limit is " +
                                 std::to_string(kMaxTriangles) + ")");
    }
    for (std::int64_t i = 0; i < element.count; ++i) {
      body.begin(nth(element, i));
      if (element.name == "face") {
        read_face(element);
      } else {
        for (const PlyProperty& property : element.properties) skip(body, property);
      }
    }
  }
};

}  // namespace

// The file is rewritten as text for the library, with positions, normals and faces only.
std::string screened_ply(std::string_view bytes, const std::string& subject) {
  TextLines lines(bytes, subject);
  const PlyHeader header = read_ply_header(lines);
  PlyScreen screen{header, PlyBody(lines, header.encoding)};
  for (const PlyElement& element : header.elements) {
    // Nothing in the file would stop the count of an element without properties.
    if (element.properties.empty() && element.count > 0)
      lines.fail("element " + in_quotes(element.name) + " is empty");
    screen.read(element, subject);
  }
  if (screen.face_count == 0) throw Failure(subject, "no faces");
  std::string out = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(screen.vertex_count) +
                    "\nproperty float x\nproperty float y\nproperty float z\n";
  if (screen.has_normals) out += "property float nx\nproperty float ny\nproperty float nz\n";
  out += "element face " + std::to_string(screen.face_count) +
         "\nproperty list int int vertex_indices\nend_header\n";
  return out + screen.vertices + screen.faces;
}

}  // namespace arcspan::tools
