// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/file_descriptor.hpp>

#include <fcntl.h>
#include <unistd.h>

namespace arcspan::linux_host {

FileDescriptor FileDescriptor::open_device(const char* path) {
  // O_NOCTTY: a terminal that is opened by mistake does not become the controlling terminal.
  return FileDescriptor(::open(path, O_RDWR | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
}

void FileDescriptor::close() {
  if (is_open()) ::close(fd_);
  fd_ = kNone;
}

}  // namespace arcspan::linux_host
