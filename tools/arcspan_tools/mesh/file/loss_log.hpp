// SPDX-License-Identifier: MIT
#pragma once

#include <assimp/DefaultLogger.hpp>
#include <assimp/NullLogger.hpp>

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace arcspan::tools {

using LeftOutCounts = std::map<std::string, std::size_t>;

/// Counts what the library leaves out of a scene and reports only in its log.
class LossLog : public Assimp::NullLogger {
 public:
  explicit LossLog(LeftOutCounts& counts) : counts_(counts) {}

  void OnWarn(const char* message) override { count(message); }
  void OnError(const char* message) override { count(message); }

 private:
  void count(std::string_view message) {
    constexpr std::pair<std::string_view, const char*> kLosses[] = {
        {"Unable to find geometry for ID", "meshes that are not in the file or have shape keys of Collada"},
        {"Unable to resolve reference to instanced node", "nodes that are not in the file"},
        {"polygon vertex index out of range", "meshes with a face index out of range"},
        {"ignoring vertex data channel", "normals and the like in an unknown order"},
        {"length of input data unexpected", "normals and the like in an unknown order"}};
    for (const auto& [words, kind] : kLosses) {
      if (message.find(words) != std::string_view::npos) ++counts_[kind];
    }
  }

  LeftOutCounts& counts_;
};

/// Has the library's log written to a LossLog.
class WithLossLog {
 public:
  explicit WithLossLog(LeftOutCounts& counts) {
    Assimp::DefaultLogger::set(new LossLog(counts));  // the library deletes it
  }
  WithLossLog(const WithLossLog&) = delete;
  WithLossLog& operator=(const WithLossLog&) = delete;
  ~WithLossLog() { Assimp::DefaultLogger::set(nullptr); }
};

}  // namespace arcspan::tools
