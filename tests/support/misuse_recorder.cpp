// SPDX-License-Identifier: MIT
#include <arcspan/checked.hpp>

#include <tests/support/misuse_recorder.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace arcspan {

namespace test {

namespace {
MisuseRecorder* recorder = nullptr;
}

MisuseRecorder::MisuseRecorder() { recorder = this; }
MisuseRecorder::~MisuseRecorder() { recorder = nullptr; }
std::vector<std::string> MisuseRecorder::take() { return std::exchange(causes_, {}); }

struct MisuseHook {
  static void record(const char* cause) {
    if (recorder == nullptr) {
      std::fprintf(stderr, "arcspan: misuse: %s\n", cause);
      std::abort();
    }
    std::vector<std::string>& causes = recorder->causes_;
    if (std::find(causes.begin(), causes.end(), cause) == causes.end()) causes.emplace_back(cause);
  }
};

}  // namespace test

/// In place of the library's.
void on_misuse(const char* cause) { test::MisuseHook::record(cause); }

}  // namespace arcspan
