#include "scenarios/command/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <vector>

#include "scenarios/command/errors.h"

namespace ballpark::command {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw DestinationError(fmt::format("cannot write '{}': {}", path, why));
}

/// Creates a file beside `target` that nobody else uses.
int create_beside(const std::string& target, std::string& name) {
  for (int attempt = 0;; ++attempt) {
    name = fmt::format("{}.partial-{}-{}", target, getpid(), attempt);
    const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
}

}  // namespace

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

OutputFile::OutputFile(const std::string& path, bool seekable) : path_(path), target_(path) {
  struct stat info {};
  const bool exists = stat(path.c_str(), &info) == 0;
  if (path.empty()) refuse(path, "the file name is empty");
  if (exists && S_ISDIR(info.st_mode)) refuse(path, "it is a folder");
  if (exists && seekable && !S_ISREG(info.st_mode)) refuse(path, "it is not a regular file");
  if (exists && access(path.c_str(), W_OK) != 0) refuse(path, strerror(errno));
  int descriptor = -1;
  if (exists && !S_ISREG(info.st_mode)) {
    descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    if (exists) target_ = std::filesystem::canonical(path).string();
    const std::string folder = folder_of(target_);
    if (stat(folder.c_str(), &info) != 0) refuse(path, fmt::format("there is no folder '{}'", folder));
    descriptor = create_beside(target_, working_path_);
  }
  if (descriptor < 0) refuse(path, strerror(errno));
  file_ = fdopen(descriptor, "w");
}

OutputFile::~OutputFile() {
  if (file_) std::fclose(file_);
  if (!working_path_.empty()) unlink(working_path_.c_str());
}

void OutputFile::fail(const std::string& why) const {
  throw WriteError(fmt::format("writing '{}' failed: {}", path_, why));
}

void OutputFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail(strerror(errno));
  bytes_ += text.size();
}

// The kernel copies, where it can between these files; what it leaves goes by hand.
void OutputFile::write_from(int descriptor, std::uint64_t size) {
  if (std::fflush(file_) != 0) fail(strerror(errno));
  off_t at = 0;
  const auto end = static_cast<off_t>(size);
  const auto left = [&] { return static_cast<std::size_t>(end - at); };
  while (at < end && copy_file_range(descriptor, &at, fileno(file_), nullptr, left(), 0) > 0) {
  }
  if (at > 0 && std::fseek(file_, 0, SEEK_END) != 0) fail(strerror(errno));
  bytes_ += static_cast<std::uint64_t>(at);
  std::vector<char> piece(at < end ? 1 << 16 : 0);
  while (at < end) {
    const ssize_t n = pread(descriptor, piece.data(), std::min(piece.size(), left()), at);
    if (n <= 0) fail(n < 0 ? strerror(errno) : "what was spooled for it is gone");
    write({piece.data(), static_cast<std::size_t>(n)});
    at += n;
  }
}

void OutputFile::commit() {
  std::FILE* file = file_;
  file_ = nullptr;
  if (std::fclose(file) != 0) fail(strerror(errno));
  if (working_path_.empty()) return;
  if (rename(working_path_.c_str(), target_.c_str()) != 0) fail(strerror(errno));
  working_path_.clear();
}

}  // namespace ballpark::command
