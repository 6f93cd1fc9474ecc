// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace arcspan::tools {

/// OBJ text for the loader library, in which every corner can have a tag: texture coordinates that are the
/// number of its face, from 0, and a number of the caller's. The library passes them on, so that triangles
/// can be traced to the faces that they are made of. Both numbers are exact in floats up to 2^24.
class TaggedObj {
 public:
  explicit TaggedObj(bool tagged) : tagged_(tagged) {}

  /// A line of `v` or `vn`, without its end.
  void line(const std::string& text) { (text_ += text) += '\n'; }

  /// A corner of the current face: indices from 1, `normal` 0 if it has none.
  void corner(std::int64_t vertex, std::int64_t normal, std::int64_t tag) {
    face_ += ' ' + std::to_string(vertex);
    if (tagged_) {
      line("vt " + std::to_string(faces_) + ' ' + std::to_string(tag));
      face_ += '/' + std::to_string(++tags_);
    }
    if (normal != 0) face_ += (tagged_ ? "/" : "//") + std::to_string(normal);
  }

  void end_face() {
    line('f' + face_);
    face_.clear();
    ++faces_;
  }

  [[nodiscard]] bool tagged() const { return tagged_; }
  [[nodiscard]] std::int64_t faces() const { return faces_; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  bool tagged_;
  std::int64_t faces_ = 0;
  std::int64_t tags_ = 0;
  std::string face_;
  std::string text_;
};

}  // namespace arcspan::tools
