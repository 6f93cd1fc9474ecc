// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// A value within a JSON file, which knows its place for messages: `materials[2].name`. Throws a Failure that
/// names the file and the place if the value is not what is asked for.
class JsonView {
 public:
  /// `json` and `subject`, the file's name, must outlive this.
  JsonView(const nlohmann::json& json, const std::string& subject, std::string place = "")
      : json_(&json), subject_(&subject), place_(std::move(place)) {}

  /// The member of an object; nothing if it has none of that name or this is no object.
  [[nodiscard]] std::optional<JsonView> find(const std::string& key) const;
  /// The member of an object, which must have it.
  [[nodiscard]] JsonView at(const std::string& key) const;
  /// Elements of an array, or members of an object; 0 for anything else.
  [[nodiscard]] std::size_t size() const;
  /// Element i of an array, or member i of an object.
  [[nodiscard]] JsonView element(std::size_t i) const;

  /// The names of the members of an object.
  [[nodiscard]] std::vector<std::string> keys() const;

  [[nodiscard]] bool is_text() const { return json_->is_string(); }
  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool truth() const;
  [[nodiscard]] double number() const;
  [[nodiscard]] std::int64_t integer(std::int64_t least, std::int64_t most) const;
  /// An array of so many numbers; `least` of them are enough.
  [[nodiscard]] std::vector<double> numbers(std::size_t least, std::size_t most) const;

  /// Members with a value for those that are missing.
  [[nodiscard]] double number_or(const std::string& key, double value) const;
  [[nodiscard]] std::int64_t integer_or(const std::string& key, std::int64_t value, std::int64_t least,
                                        std::int64_t most) const;
  [[nodiscard]] std::string text_or(const std::string& key, const std::string& value) const;

  [[nodiscard]] const std::string& place() const { return place_; }
  /// Throws `subject: place: what`.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  const nlohmann::json* json_;
  const std::string* subject_;
  std::string place_;
};

}  // namespace arcspan::tools
