// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/gltf/json_view.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <cmath>

namespace arcspan::tools {

std::optional<JsonView> JsonView::find(const std::string& key) const {
  if (!json_->is_object()) return std::nullopt;
  const auto found = json_->find(key);
  if (found == json_->end()) return std::nullopt;
  return JsonView(*found, *subject_, place_.empty() ? key : place_ + "." + key);
}

JsonView JsonView::at(const std::string& key) const {
  if (const std::optional<JsonView> member = find(key)) return *member;
  fail("'" + key + "' is missing");
}

std::size_t JsonView::size() const { return json_->is_structured() ? json_->size() : 0; }

JsonView JsonView::element(std::size_t i) const {
  const auto at = std::next(json_->begin(), static_cast<std::ptrdiff_t>(i));
  const std::string name = json_->is_object() ? "'" + at.key() + "'" : std::to_string(i);
  return JsonView(*at, *subject_, place_ + "[" + name + "]");
}

std::vector<std::string> JsonView::keys() const {
  std::vector<std::string> names;
  if (!json_->is_object()) return names;
  for (const auto& [name, value] : json_->items()) names.push_back(name);
  return names;
}

std::string JsonView::text() const {
  if (!json_->is_string()) fail("is not a string");
  return json_->get<std::string>();
}

bool JsonView::truth() const {
  if (!json_->is_boolean()) fail("is neither true nor false");
  return json_->get<bool>();
}

double JsonView::number() const {
  if (!json_->is_number()) fail("is not a number");
  const double value = json_->get<double>();
  if (!std::isfinite(value)) fail("is not a finite number");
  return value;
}

std::int64_t JsonView::integer(std::int64_t least, std::int64_t most) const {
  const double value = number();
  if (value != std::floor(value) || value < static_cast<double>(least) || value > static_cast<double>(most)) {
    fail("is not an integer " + std::to_string(least) + " to " + std::to_string(most) + " (" + json_->dump() +
         ")");
  }
  return static_cast<std::int64_t>(value);
}

std::vector<double> JsonView::numbers(std::size_t least, std::size_t most) const {
  if (!json_->is_array() || json_->size() < least || json_->size() > most) {
    fail("is not an array of " + std::to_string(least) + " numbers");
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < json_->size(); ++i) values.push_back(element(i).number());
  return values;
}

double JsonView::number_or(const std::string& key, double value) const {
  const std::optional<JsonView> member = find(key);
  return member ? member->number() : value;
}

std::int64_t JsonView::integer_or(const std::string& key, std::int64_t value, std::int64_t least,
                                  std::int64_t most) const {
  const std::optional<JsonView> member = find(key);
  return member ? member->integer(least, most) : value;
}

std::string JsonView::text_or(const std::string& key, const std::string& value) const {
  const std::optional<JsonView> member = find(key);
  return member ? member->text() : value;
}

void JsonView::fail(const std::string& what) const {
  throw Failure(*subject_, place_.empty() ? what : place_ + ": " + what);
}

}  // namespace arcspan::tools
