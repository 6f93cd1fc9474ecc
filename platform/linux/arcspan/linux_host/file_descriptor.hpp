// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

namespace arcspan::linux_host {

/// Owns a file descriptor and closes it in the destructor.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  explicit FileDescriptor(int fd) : fd_(fd) {}
  FileDescriptor(FileDescriptor&& other) noexcept : fd_(std::exchange(other.fd_, kNone)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor() { close(); }

  /// Opens a device for reading and writing, not inherited by child processes. On failure is_open() is false
  /// and errno has the cause.
  [[nodiscard]] static FileDescriptor open_device(const char* path);

  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] bool is_open() const { return fd_ != kNone; }
  void close();

 private:
  static constexpr int kNone = -1;
  int fd_ = kNone;
};

}  // namespace arcspan::linux_host
