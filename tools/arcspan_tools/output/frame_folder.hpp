// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/output/frame_output.hpp>
#include <arcspan_tools/support/child_process.hpp>

#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// Numbered pictures in a folder. They are collected in a hidden folder: beside a folder that does not exist,
/// whose place it takes when all pictures are there; within a folder that exists, into which they are moved
/// then.
class FrameFolder : public FrameOutput {
 public:
  FrameFolder(const std::filesystem::path& folder, const FrameFormat& format);

  void add(Image frame) override;
  void finish(const std::string& summary) override;

 private:
  [[nodiscard]] std::string name_of(std::size_t number) const;
  void refuse_longer_ones(std::size_t frames) const;

  std::filesystem::path folder_;
  bool exists_;
  std::optional<ScratchFolder> collected_;
  std::vector<Removal*> frames_;  ///< files of collected_
  std::string extension_;
  ImageFormat pictures_;
};

}  // namespace arcspan::tools
