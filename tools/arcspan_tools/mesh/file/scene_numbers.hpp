// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <vector>

namespace arcspan::tools {

/// A list of numbers, vectors or the like in a scene of import_scene(); empty if it has none of this name.
template <class T>
std::vector<T> scene_numbers(const nlohmann::json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) return {};
  const std::vector<std::uint8_t>& bytes = found->get_binary();
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!values.empty())
    std::memcpy(static_cast<void*>(values.data()), bytes.data(), values.size() * sizeof(T));
  return values;
}

}  // namespace arcspan::tools
