// SPDX-License-Identifier: MIT
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace arcspan::tools {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_with_errno(const fs::path& path, const char* doing) {
  throw Failure(path.string(), std::string("cannot ") + doing + " (" + std::strerror(errno) + ")");
}

/// An open file descriptor that unlinks its temporary unless it was renamed into place.
class Temporary {
 public:
  explicit Temporary(const fs::path& target)
      : target_(target), name_((target.parent_path() / ("." + target.filename().string() + ".XXXXXX"))) {
    descriptor_ = ::mkstemp(name_.data());
    if (descriptor_ < 0) fail_with_errno(target_, "write");
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!placed_) ::unlink(name_.c_str());
  }

  [[nodiscard]] int descriptor() const { return descriptor_; }

  void place() {
    // mkstemp makes files private; the result gets the mode that a plain open would have given it.
    const mode_t mask = ::umask(0);
    ::umask(mask);
    if (::fchmod(descriptor_, 0666 & ~mask) != 0) fail_with_errno(target_, "write");
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) fail_with_errno(target_, "write");
    if (::rename(name_.c_str(), target_.c_str()) != 0) fail_with_errno(target_, "write");
    placed_ = true;
  }

 private:
  fs::path target_;
  std::string name_;
  int descriptor_ = -1;
  bool placed_ = false;
};

void write_all(int descriptor, std::string_view bytes, const fs::path& path) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_with_errno(path, "write");
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void write_in_place(const fs::path& path, std::string_view bytes) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) fail_with_errno(path, "write");
  try {
    write_all(descriptor, bytes, path);
  } catch (...) {
    ::close(descriptor);
    throw;
  }
  if (::close(descriptor) != 0) fail_with_errno(path, "write");
}

}  // namespace

bool is_standard_output(const fs::path& path) {
  const std::string& name = path.native();
  if (name == "-") return true;
  return name.size() > 2 && name.ends_with(":-") &&
         std::all_of(name.begin(), name.end() - 2, [](unsigned char c) { return std::isalnum(c) != 0; });
}

std::string output_kind(const fs::path& path, std::string_view otherwise) {
  std::string kind = path.extension().string();
  if (is_standard_output(path)) {
    const std::string& name = path.native();
    kind = name == "-" ? "." + std::string(otherwise) : "." + name.substr(0, name.size() - 2);
  }
  std::transform(kind.begin(), kind.end(), kind.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return kind.empty() ? kind : kind.substr(1);
}

std::FILE* report_stream(std::initializer_list<fs::path> outputs) {
  const auto count = std::count_if(outputs.begin(), outputs.end(), is_standard_output);
  if (count > 1) throw Failure("standard output", "only one result can go there");
  return count == 1 ? stderr : stdout;
}

void write_whole_file(const fs::path& path, std::string_view bytes) {
  if (is_standard_output(path)) {
    std::fflush(stdout);
    return write_all(STDOUT_FILENO, bytes, "standard output");
  }
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) throw Failure(path.string(), "cannot write (it is a directory)");
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_in_place(path, bytes);
  fs::path target = path;
  if (fs::exists(status)) target = fs::canonical(path, error);
  if (error && fs::exists(status)) throw Failure(path.string(), "cannot write (" + error.message() + ")");
  try {
    Temporary temporary(target);
    write_all(temporary.descriptor(), bytes, path);
    temporary.place();
  } catch (const fs::filesystem_error& e) {
    throw Failure(path.string(), std::string("cannot write (") + e.code().message() + ")");
  }
}

std::string read_whole_file(const fs::path& path, std::size_t limit) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw Failure(path.string(), "cannot read (no such file)");
  if (!fs::is_regular_file(status)) throw Failure(path.string(), "cannot read (not a regular file)");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) throw Failure(path.string(), "cannot read (" + error.message() + ")");
  if (size > limit) {
    throw Failure(path.string(), "too large (" + std::to_string(size) + " bytes; the limit is " +
                                     std::to_string(limit) + ")");
  }
  std::ifstream in(path, std::ios::binary);
  if (!in) fail_with_errno(path, "read");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(size));
  if (in.gcount() != static_cast<std::streamsize>(size))
    throw Failure(path.string(), "cannot read to its end");
  return bytes;
}

}  // namespace arcspan::tools
