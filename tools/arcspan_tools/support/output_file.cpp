// SPDX-License-Identifier: MIT
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <arcspan_tools/support/result_files.hpp>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

namespace arcspan::tools {
namespace fs = std::filesystem;

namespace {

using FileNumber = std::pair<dev_t, ino_t>;

/// Device and inode of a regular file, which are the same under all its names. Nothing if `path` is not one.
std::optional<FileNumber> number_of(const fs::path& path) {
  struct stat file {};
  if (::stat(path.c_str(), &file) != 0 || !S_ISREG(file.st_mode)) return std::nullopt;
  return FileNumber{file.st_dev, file.st_ino};
}

/// The files that read_whole_file() has read in this process.
std::set<FileNumber>& read_files() {
  static std::set<FileNumber> files;
  return files;
}

}  // namespace

void fail_with_errno(const fs::path& subject, const char* doing) {
  throw Failure(subject.string(), std::string("cannot ") + doing + " (" + std::strerror(errno) + ")");
}

void write_all(int descriptor, std::string_view bytes, const fs::path& subject) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_with_errno(subject, "write");
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

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

std::FILE* report_stream(const std::vector<fs::path>& outputs) {
  const auto count = std::count_if(outputs.begin(), outputs.end(), is_standard_output);
  if (count > 1) throw Failure("standard output", "only one result can go there");
  return count == 1 ? stderr : stdout;
}

void write_whole_file(const fs::path& path, std::string bytes, const std::string& summary) {
  write_results({{path, std::move(bytes)}}, summary);
}

void write_new_file(const fs::path& path, std::string_view bytes, const fs::path& subject) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) fail_with_errno(subject, "write");
  try {
    write_all(descriptor, bytes, subject);
  } catch (...) {
    ::close(descriptor);
    throw;
  }
  if (::close(descriptor) != 0) fail_with_errno(subject, "write");
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
  if (const std::optional<FileNumber> number = number_of(path)) read_files().insert(*number);
  return bytes;
}

bool was_read(const fs::path& path) {
  const std::optional<FileNumber> number = number_of(path);
  return number && read_files().contains(*number);
}

}  // namespace arcspan::tools
