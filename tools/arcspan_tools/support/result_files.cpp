// SPDX-License-Identifier: MIT
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <arcspan_tools/support/result_files.hpp>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <deque>
#include <optional>

namespace arcspan::tools {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& target) {
  const fs::path folder = target.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

/// The folder may be what is missing.
[[noreturn]] void fail_in_folder_of(const fs::path& target, const fs::path& subject) {
  struct stat folder {};
  const int cause = errno;
  const bool is_there = ::stat(folder_of(target).c_str(), &folder) == 0;
  errno = cause;
  if (cause != ENOENT || is_there) fail_with_errno(subject, "write");
  throw Failure(subject.string(), "cannot write (there is no folder " + folder_of(target).string() + ")");
}

/// An empty temporary file beside `target`.
class TemporaryFile {
 public:
  TemporaryFile(const fs::path& target, const fs::path& subject) {
    const SignalPause pause;
    std::string name = temporary_pattern(target.parent_path());
    descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
    if (descriptor_ < 0) fail_in_folder_of(target, subject);
    removal_.emplace(name);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  [[nodiscard]] int descriptor() const { return descriptor_; }
  [[nodiscard]] Removal& removal() { return *removal_; }

  void close(const fs::path& subject) {
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) fail_with_errno(subject, "write");
  }

 private:
  std::optional<Removal> removal_;
  int descriptor_ = -1;
};

/// The mode that writing in place would have left: that of the file, or that of the user's mask for a new
/// one.
mode_t mode_for(const fs::path& target) {
  struct stat present {};
  if (::stat(target.c_str(), &present) == 0) return present.st_mode & 0777u;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666u & ~mask;
}

[[noreturn]] void fail_for_input(const fs::path& subject) {
  throw Failure(subject.string(), "is an input, which the result would replace");
}

void refuse_target(const fs::path& target, const fs::path& subject) {
  if (was_read(target)) fail_for_input(subject);
  struct stat present {};
  if (::stat(target.c_str(), &present) != 0) return;
  if (S_ISDIR(present.st_mode)) throw Failure(subject.string(), "cannot write (it is a directory)");
  if (::access(target.c_str(), W_OK) != 0) fail_with_errno(subject, "write");
}

/// A result that is complete, but not yet in its place.
class StagedFile {
 public:
  explicit StagedFile(const ResultFile& result)
      : subject_(result.path), target_(destination(result.path)), file_(checked(target_), subject_) {
    write_all(file_.descriptor(), result.bytes, subject_);
    if (::fchmod(file_.descriptor(), mode_for(target_)) != 0) fail_with_errno(subject_, "write");
    file_.close(subject_);
  }

  [[nodiscard]] FilePlacement placement() { return {file_.removal(), target_, subject_}; }

 private:
  const fs::path& checked(const fs::path& target) const {
    refuse_target(target, subject_);
    return target;
  }

  fs::path subject_;
  fs::path target_;
  TemporaryFile file_;
};

/// One file of place_all(). What it replaces is kept until the last one is in place.
class Placing {
 public:
  explicit Placing(const FilePlacement& placement) : placement_(placement) {}

  void place(bool keep_old) {
    if (keep_old && fs::exists(fs::symlink_status(placement_.target))) set_old_aside();
    rename(placement_.temporary.path(), placement_.target);
    placement_.temporary.cancel();
    placed_ = true;
  }

  void undo() {
    if (old_) {
      if (std::rename(old_->removal().path().c_str(), placement_.target.c_str()) == 0)
        old_->removal().cancel();
    } else if (placed_) {
      std::error_code ignored;
      fs::remove_all(placement_.target, ignored);
    }
  }

 private:
  void set_old_aside() {
    TemporaryFile& spare = spare_.emplace(placement_.target, placement_.subject);
    rename(placement_.target, spare.removal().path());
    old_ = &spare;
  }

  void rename(const fs::path& from, const fs::path& to) const {
    if (std::rename(from.c_str(), to.c_str()) != 0) fail_with_errno(placement_.subject, "write");
  }

  FilePlacement placement_;
  std::optional<TemporaryFile> spare_;
  TemporaryFile* old_ = nullptr;  ///< the spare once it holds the old file
  bool placed_ = false;
};

bool is_written_directly(const fs::path& path) {
  if (is_standard_output(path)) return true;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void write_directly(const ResultFile& result) {
  if (is_standard_output(result.path)) {
    std::fflush(stdout);
    return write_all(STDOUT_FILENO, result.bytes, "standard output");
  }
  const int descriptor = ::open(result.path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) fail_with_errno(result.path, "write");
  try {
    write_all(descriptor, result.bytes, result.path);
  } catch (...) {
    ::close(descriptor);
    throw;
  }
  if (::close(descriptor) != 0) fail_with_errno(result.path, "write");
}

/// A name and the file that it refers to. Two names are compared by their files.
struct NamedFile {
  fs::path name;
  fs::path place;                 ///< without links and dots
  std::optional<struct stat> is;  ///< nothing if it does not exist

  explicit NamedFile(const fs::path& path) : name(path) {
    struct stat present {};
    if (is_standard_output(path)) {
      if (::fstat(STDOUT_FILENO, &present) == 0) is = present;
      return;
    }
    std::error_code error;
    const fs::path target = destination(path);
    place = fs::weakly_canonical(folder_of(target), error) / target.filename();
    if (::stat(target.c_str(), &present) == 0) is = present;
  }

  [[nodiscard]] bool is_special() const { return is && !S_ISREG(is->st_mode); }
  [[nodiscard]] bool is_same_as(const NamedFile& other) const {
    if (is_special() || other.is_special()) return false;
    if (is && other.is) return is->st_dev == other.is->st_dev && is->st_ino == other.is->st_ino;
    return !place.empty() && place == other.place;
  }
};

std::vector<NamedFile> named_files(const std::vector<fs::path>& paths) {
  std::vector<NamedFile> files;
  for (const fs::path& path : paths) {
    if (!path.empty()) files.emplace_back(path);
  }
  return files;
}

void refuse_lost_folder(const fs::path& path) {
  struct stat folder {};
  const fs::path target = destination(path);
  if (!target.has_filename()) return;
  if (::stat(folder_of(target).c_str(), &folder) != 0) fail_in_folder_of(target, path);
}

}  // namespace

fs::path destination(const fs::path& path) {
  constexpr int kMostLinks = 40;  // as the kernel follows
  fs::path at = path;
  for (int links = 0; links <= kMostLinks; ++links) {
    std::error_code error;
    if (!fs::is_symlink(fs::symlink_status(at, error))) return at;
    const fs::path leads_to = fs::read_symlink(at, error);
    if (error) throw Failure(path.string(), "cannot write (" + error.message() + ")");
    at = at.parent_path() / leads_to;  // an absolute one replaces the folder
  }
  throw Failure(path.string(), "cannot write (the symbolic link leads in a circle)");
}

void check_results(const std::vector<fs::path>& results, const std::vector<fs::path>& inputs) {
  (void)report_stream(results);  // refuses two on standard output
  const std::vector<NamedFile> written = named_files(results);
  const std::vector<NamedFile> read = named_files(inputs);
  for (std::size_t i = 0; i < written.size(); ++i) {
    const NamedFile& file = written[i];
    for (const NamedFile& input : read) {
      if (file.is_same_as(input)) fail_for_input(file.name);
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (file.is_same_as(written[k])) throw Failure(file.name.string(), "cannot hold two results");
    }
    if (!is_standard_output(file.name)) refuse_lost_folder(file.name);
  }
}

void write_results(const std::vector<ResultFile>& results, const std::string& summary) {
  std::deque<StagedFile> staged;
  for (const ResultFile& result : results) {
    if (!is_written_directly(result.path)) staged.emplace_back(result);
  }
  for (const ResultFile& result : results) {
    if (is_written_directly(result.path)) write_directly(result);
  }
  std::vector<FilePlacement> placements;
  placements.reserve(staged.size());
  for (StagedFile& file : staged) placements.push_back(file.placement());
  std::vector<fs::path> paths;
  paths.reserve(results.size());
  for (const ResultFile& result : results) paths.push_back(result.path);
  place_all(placements, summary, report_stream(paths));
}

void place_all(const std::vector<FilePlacement>& placements, const std::string& summary, std::FILE* stream) {
  for (const FilePlacement& placement : placements) refuse_target(placement.target, placement.subject);
  if (std::fputs(summary.c_str(), stream) < 0 || std::fflush(stream) != 0) {
    fail_with_errno(stream == stdout ? "standard output" : "standard error", "write");
  }
  const SignalPause pause;
  std::deque<Placing> files;
  try {
    for (const FilePlacement& placement : placements) {
      files.emplace_back(placement).place(files.size() < placements.size());
    }
  } catch (...) {
    for (auto file = files.rbegin(); file != files.rend(); ++file) file->undo();
    throw;
  }
}

}  // namespace arcspan::tools
