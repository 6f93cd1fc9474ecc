// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace arcspan::tools {

/// An error that stops a command, as one line for the user: `subject: what is wrong (value or line)`. The
/// subject is the file or option at fault; main() prints the line and exits with status 1, or 2 for an
/// option.
class Failure : public std::runtime_error {
 public:
  Failure(const std::string& subject, const std::string& what)
      : std::runtime_error(subject + ": " + what), subject_bytes_(subject.size()) {}

  [[nodiscard]] bool is_about_option() const { return std::string_view(what()).starts_with("--"); }
  /// What is wrong, without the subject.
  [[nodiscard]] const char* reason() const { return what() + subject_bytes_ + 2; }

 private:
  std::size_t subject_bytes_;
};

}  // namespace arcspan::tools
