// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/collada_text.hpp>

#include <cstring>
#include <set>

namespace arcspan::tools {
namespace {

/// An attribute in the text of a tag; empty if there is none.
std::string_view attribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
    if (at == 0 || std::strchr(" \t\r\n", tag[at - 1]) == nullptr) continue;
    const std::string_view rest = tag.substr(at + name.size());
    if (rest.size() < 2 || rest[0] != '=' || (rest[1] != '"' && rest[1] != '\'')) continue;
    return rest.substr(2, rest.find(rest[1], 2) - 2);
  }
  return {};
}

}  // namespace

std::string without_blanks_before_numbers(std::string_view xml) {
  std::string out;
  out.reserve(xml.size());
  for (std::size_t i = 0; i < xml.size(); ++i) {
    out += xml[i];
    if (xml[i] != '>') continue;
    const std::size_t next = xml.find_first_not_of(" \t\r\n", i + 1);
    if (next != std::string_view::npos && std::strchr("+-.0123456789", xml[next]) != nullptr &&
        xml[next] != 0)
      i = next - 1;
  }
  return out;
}

std::size_t count_shared_joints(std::string_view xml) {
  if (xml.find("<instance_controller") == std::string_view::npos) return 0;
  std::size_t count = 0;
  constexpr std::string_view kNode = "<node";
  std::set<std::string_view> known;
  for (std::size_t at = xml.find(kNode); at < xml.size(); at = xml.find(kNode, at + 1)) {
    const std::string_view tag = xml.substr(at, xml.find_first_of("<>", at + 1) - at);
    const std::string_view sid = attribute(tag, "sid");
    if (sid.empty() || attribute(tag, "type") != "JOINT" || known.insert(sid).second) continue;
    ++count;
  }
  return count;
}

}  // namespace arcspan::tools
