// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/collada_text.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>

namespace arcspan::tools {
namespace {

constexpr std::int64_t kMostColladaSets = 1000;

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

/// Calls `visit` with the text of each tag that begins with `name`, a '<' included.
template <class Visit>
void for_each_tag(std::string_view xml, std::string_view name, const Visit& visit) {
  for (std::size_t at = xml.find(name); at < xml.size(); at = xml.find(name, at + 1))
    visit(xml.substr(at, xml.find_first_of("<>", at + 1) - at));
}

/// The number of a set of texture coordinates in an attribute of a tag; 0 if it is left out.
std::int64_t set_number(std::string_view tag, std::string_view name) {
  return std::clamp<std::int64_t>(parse_integer(attribute(tag, name)).value_or(0), 0, kMostColladaSets);
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
  std::set<std::string_view> known;
  for_each_tag(xml, "<node", [&](std::string_view tag) {
    const std::string_view sid = attribute(tag, "sid");
    if (sid.empty() || attribute(tag, "type") != "JOINT" || known.insert(sid).second) return;
    ++count;
  });
  return count;
}

std::string with_numbered_sets(std::string_view xml) {
  std::map<std::string_view, std::int64_t> bound;
  for_each_tag(xml, "<bind_vertex_input", [&](std::string_view tag) {
    bound.try_emplace(attribute(tag, "semantic"), set_number(tag, "input_set"));
  });
  std::int64_t first = kMostColladaSets;
  for_each_tag(xml, "<input", [&](std::string_view tag) {
    if (attribute(tag, "semantic") == "TEXCOORD") first = std::min(first, set_number(tag, "set"));
  });
  std::string out;
  std::size_t done = 0;
  for_each_tag(xml, "<texture", [&](std::string_view tag) {
    const std::string_view name = attribute(tag, "texcoord");
    if (name.empty()) return;
    const auto at = static_cast<std::size_t>(name.data() - xml.data());
    const auto found = bound.find(name);
    const std::int64_t set = found == bound.end() ? first : std::max(found->second, first);
    out.append(xml.substr(done, at - done)).append(std::to_string(set - first));
    done = at + name.size();
  });
  return out.append(xml.substr(done));
}

}  // namespace arcspan::tools
