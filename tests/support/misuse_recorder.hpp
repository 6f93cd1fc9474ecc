// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace arcspan::test {

/// Keeps the causes that on_misuse() is called with while it lives; without one a misuse ends the test
/// program, as it does with the library's own function. Only in builds with checks (ARCSPAN_CHECKED) there
/// are causes.
class MisuseRecorder {
 public:
  MisuseRecorder();
  ~MisuseRecorder();
  MisuseRecorder(const MisuseRecorder&) = delete;
  MisuseRecorder& operator=(const MisuseRecorder&) = delete;

  /// The causes since the last call, each once.
  [[nodiscard]] std::vector<std::string> take();

 private:
  friend struct MisuseHook;
  std::vector<std::string> causes_;
};

}  // namespace arcspan::test
