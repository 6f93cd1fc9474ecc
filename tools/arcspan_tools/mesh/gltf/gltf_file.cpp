// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/gltf/base64.hpp>
#include <arcspan_tools/mesh/gltf/gltf_file.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace arcspan::tools {
namespace {

constexpr std::int64_t kMostBufferBytes = std::numeric_limits<std::int32_t>::max();

std::uint32_t chunk_number(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  }
  return value;
}

/// Extensions without which a file has the same shape: they are about looks, or have plain values besides.
bool is_harmless(std::string_view extension) {
  return extension.starts_with("KHR_materials_") || extension.starts_with("KHR_texture_") ||
         extension.starts_with("EXT_texture_") || extension == "KHR_mesh_quantization" ||
         extension == "KHR_lights_punctual";
}

/// `%20` and the like as characters.
std::string percent_decoded(const std::string& uri) {
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const auto digit = [&uri](std::size_t at) {
      const std::string_view digits = "0123456789abcdef";
      const char c = at < uri.size() ? uri[at] : ' ';
      return digits.find(c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c);
    };
    const std::size_t high = uri[i] == '%' ? digit(i + 1) : std::string_view::npos;
    const std::size_t low = uri[i] == '%' ? digit(i + 2) : std::string_view::npos;
    if (high == std::string_view::npos || low == std::string_view::npos) {
      name += uri[i];
    } else {
      name += static_cast<char>(16 * high + low);
      i += 2;
    }
  }
  return name;
}

}  // namespace

GltfFile::GltfFile(std::string_view bytes, std::string subject, SideFiles files)
    : subject_(std::move(subject)), files_(std::move(files)) {
  if (bytes.starts_with("glTF")) {
    read_binary(bytes);
  } else {
    parse(bytes);
  }
  if (!json_.is_object()) throw Failure(subject_, "not a glTF file");
  const JsonView asset = root().at("asset");
  const std::optional<JsonView> stated = asset.find("version");
  const std::string version = stated && stated->is_text() ? stated->text() : "";
  // Files of 1.0 may lack the version, or have a number.
  version_ = version.starts_with("2.") ? 2 : 1;
  if (version_ == 1 && !version.empty() && !version.starts_with("1.")) {
    stated->fail("'" + version + "' cannot be read (1.0 and 2.x can)");
  }
  check_extensions();
}

void GltfFile::read_binary(std::string_view bytes) {
  constexpr std::size_t kContainerBytes = 12;
  constexpr std::size_t kChunkHeaderBytes = 8;
  constexpr std::uint32_t kJson = 0x4E4F534A;
  constexpr std::uint32_t kBinary = 0x004E4942;
  if (bytes.size() < kContainerBytes + kChunkHeaderBytes) throw Failure(subject_, "truncated");
  const std::uint32_t version = chunk_number(bytes, 4);
  if (version != 2)
    throw Failure(subject_, "a .glb of version " + std::to_string(version) + " cannot be read");
  const std::uint32_t size = chunk_number(bytes, 8);
  if (size > bytes.size()) {
    throw Failure(subject_,
                  "truncated (" + std::to_string(bytes.size()) + " bytes of " + std::to_string(size) + ")");
  }
  bool has_json = false;
  for (std::size_t at = kContainerBytes; at + kChunkHeaderBytes <= size;) {
    const std::size_t length = chunk_number(bytes, at);
    const std::uint32_t type = chunk_number(bytes, at + 4);
    at += kChunkHeaderBytes;
    if (length > size - at) throw Failure(subject_, "a chunk is longer than the file");
    if (type == kJson && !has_json) {
      parse(bytes.substr(at, length));
      has_json = true;
    } else if (type == kBinary && chunk_.empty()) {
      chunk_ = bytes.substr(at, length);
    }
    at += length;
  }
  if (!has_json) throw Failure(subject_, "no JSON chunk");
}

void GltfFile::parse(std::string_view text) {
  try {
    json_ = nlohmann::json::parse(text.begin(), text.end());
  } catch (const nlohmann::json::exception& e) {
    const std::string message = e.what();
    const std::size_t after_id = message.find("] ");
    throw Failure(subject_,
                  "not a glTF file: " + message.substr(after_id == std::string::npos ? 0 : after_id + 2));
  }
}

void GltfFile::check_extensions() const {
  const std::optional<JsonView> required = root().find("extensionsRequired");
  for (std::size_t i = 0; required && i < required->size(); ++i) {
    const std::string extension = required->element(i).text();
    if (!is_harmless(extension)) {
      throw Failure(subject_, "needs the extension '" + extension + "', which cannot be read");
    }
  }
}

JsonView GltfFile::element(const char* list, const JsonView& id) const {
  const std::optional<JsonView> all = root().find(list);
  if (id.is_text()) {
    const std::optional<JsonView> named = all ? all->find(id.text()) : std::nullopt;
    if (named) return *named;
    id.fail("there is no '" + id.text() + "' in " + list);
  }
  const std::int64_t index = id.integer(0, kMostBufferBytes);
  if (!all || static_cast<std::size_t>(index) >= all->size()) {
    id.fail("there is no " + std::string(list) + "[" + std::to_string(index) + "]");
  }
  return all->element(static_cast<std::size_t>(index));
}

std::optional<std::string> GltfFile::find_uri(const JsonView& uri) const {
  const std::string text = uri.text();
  if (text.starts_with("data:")) {
    const std::size_t comma = text.find(";base64,");
    const std::optional<std::string> bytes =
        comma == std::string::npos ? std::nullopt : from_base64(std::string_view(text).substr(comma + 8));
    if (!bytes) uri.fail("is not data in base64");
    return *bytes;
  }
  if (std::optional<ReferredFile> file = files_(percent_decoded(text))) return std::move(file->bytes);
  return std::nullopt;
}

std::string GltfFile::read_uri(const JsonView& uri) const {
  if (std::optional<std::string> bytes = find_uri(uri)) return std::move(*bytes);
  uri.fail("cannot read '" + percent_decoded(uri.text()) + "' in the model's folder");
}

std::optional<std::string> GltfFile::image_bytes(const JsonView& image) {
  if (const std::optional<JsonView> view = image.find("bufferView")) {
    return std::string(view_bytes(element("bufferViews", *view), 0));
  }
  return find_uri(image.at("uri"));
}

const std::string& GltfFile::buffer(const JsonView& id) {
  const JsonView found = element("buffers", id);
  const auto [at, is_new] = buffers_.try_emplace(found.place());
  if (!is_new) return at->second;
  const std::optional<JsonView> uri = found.find("uri");
  at->second = uri ? read_uri(*uri) : chunk_;
  const std::int64_t stated = found.integer_or("byteLength", 0, 0, kMostBufferBytes);
  if (static_cast<std::size_t>(stated) > at->second.size()) {
    found.fail("has " + std::to_string(at->second.size()) + " bytes of " + std::to_string(stated));
  }
  return at->second;
}

std::string_view GltfFile::view_bytes(const JsonView& view, std::size_t offset) {
  const std::string_view all = buffer(view.at("buffer"));
  const auto begin = static_cast<std::size_t>(view.integer_or("byteOffset", 0, 0, kMostBufferBytes));
  const auto length = static_cast<std::size_t>(view.at("byteLength").integer(0, kMostBufferBytes));
  if (begin > all.size() || length > all.size() - begin) view.fail("reaches beyond its buffer");
  if (offset > length) view.fail("is shorter than an offset into it");
  return all.substr(begin + offset, length - offset);
}

}  // namespace arcspan::tools
