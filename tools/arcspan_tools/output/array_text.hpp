// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace arcspan::tools {

/// The elements of an array in a generated header, as many in a line as fit.
class ArrayText {
 public:
  void add(const std::string& element) {
    if (column_ + element.size() + 2 > kColumns) {
      text_ += "\n   ";
      column_ = 3;
    }
    text_ += " " + element + ",";
    column_ += element.size() + 2;
  }
  /// The definition of an array of them.
  [[nodiscard]] std::string array(const std::string& type, const std::string& name) const {
    return "inline constexpr " + type + " " + name + c_array();
  }
  /// The same, behind the name.
  [[nodiscard]] std::string c_array() const { return "[] = {" + text_ + "\n};\n\n"; }

 private:
  static constexpr std::size_t kColumns = 108;

  std::string text_;
  std::size_t column_ = kColumns;
};

/// `text` for a comment in a generated header, which must not end in a backslash, nor hold a line's end.
[[nodiscard]] inline std::string harmless(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\\') c = '?';
  }
  return text;
}

}  // namespace arcspan::tools
