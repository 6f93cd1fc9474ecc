// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/output/frame_output.hpp>

#include <string>

namespace arcspan::tools {

/// Numbered pictures in a folder. They are collected in a hidden folder beside it that takes its place, or
/// whose pictures are moved over, when all are there.
class FrameFolder : public FrameOutput {
 public:
  FrameFolder(const std::filesystem::path& folder, const FrameFormat& format);
  ~FrameFolder() override;

  void add(Image frame) override;
  void finish() override;

 private:
  [[nodiscard]] std::string name_of(std::size_t number) const;
  void refuse_longer_ones(std::size_t frames) const;

  std::filesystem::path folder_;
  std::string collected_;
  std::string extension_;
  ImageFormat pictures_;
  std::size_t count_ = 0;
};

}  // namespace arcspan::tools
