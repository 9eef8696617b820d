#include "base/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "base/throw_invalid.hpp"

namespace oxturn {
namespace {

constexpr off_t kLargestFile = off_t{4} << 30;

struct Descriptor {
  explicit Descriptor(int n) : number(n) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
  int number;
};

/// Throws std::invalid_argument; `name` is that of the file in quotes, or "standard input".
std::string read_all(int in, const std::string& name) {
  std::string content;
  char buffer[1 << 16];
  for (;;) {
    const ssize_t got = ::read(in, buffer, sizeof buffer);
    if (got == 0) return content;
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw_invalid("cannot read {}: {}", name, std::strerror(errno));
    if (static_cast<off_t>(content.size()) + got > kLargestFile)
      throw_invalid("cannot read {}: it has more than {} bytes, which are the most that are read", name, kLargestFile);
    content.append(buffer, static_cast<std::size_t>(got));
  }
}

/// Returns the error's number, or 0.
int write_all(int out, const std::string& content) {
  for (std::size_t done = 0; done < content.size();) {
    const ssize_t put = ::write(out, content.data() + done, content.size() - done);
    if (put >= 0)
      done += static_cast<std::size_t>(put);
    else if (errno != EINTR)
      return errno;
  }
  return 0;
}

void write_standard_output(const std::string& content) {
  std::fflush(stdout);  // in order, after what was printed before
  if (const int error = write_all(STDOUT_FILENO, content); error != 0)
    throw std::runtime_error(fmt::format("cannot write to standard output: {}", std::strerror(error)));
}

}  // namespace

std::string read_file(const std::string& file) {
  if (file == kStandardStream) return read_all(STDIN_FILENO, "standard input");
  struct stat about {};
  if (::stat(file.c_str(), &about) != 0) {
    if (errno == ENOENT || errno == ENOTDIR) throw_invalid("no such file: '{}'", file);
    throw_invalid("cannot read '{}': {}", file, std::strerror(errno));
  }
  if (S_ISDIR(about.st_mode)) throw_invalid("cannot read '{}': it is a folder", file);
  // Devices and pipes may never end.
  if (!S_ISREG(about.st_mode) && file != "/dev/stdin")
    throw_invalid("cannot read '{}': it is not a regular file", file);
  if (about.st_size > kLargestFile)
    throw_invalid("cannot read '{}': it has {} bytes, at most {} are read", file, about.st_size, kLargestFile);
  const Descriptor in(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (in.number < 0) throw_invalid("cannot read '{}': {}", file, std::strerror(errno));
  return read_all(in.number, fmt::format("'{}'", file));
}

void write_file(const std::string& file, const std::string& content) {
  if (file == kStandardStream) return write_standard_output(content);
  const auto fail = [&](int error) {
    throw std::runtime_error(fmt::format("cannot write '{}': {}", file, std::strerror(error)));
  };
  struct stat about {};
  const bool exists = ::stat(file.c_str(), &about) == 0;
  if (exists && S_ISDIR(about.st_mode)) fail(EISDIR);
  const bool direct = exists && !S_ISREG(about.st_mode);  // a device or pipe
  static std::atomic<unsigned> serial{0};
  const std::string target =
      direct ? file : fmt::format("{}.{}-{}.tmp", file, ::getpid(), serial.fetch_add(1, std::memory_order_relaxed));
  int error = 0;
  {
    Descriptor out(
        ::open(target.c_str(), direct ? O_WRONLY | O_CLOEXEC : O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (out.number < 0) fail(errno);
    error = write_all(out.number, content);
    const int closed = ::close(out.number);
    out.number = -1;
    if (closed != 0 && error == 0) error = errno;  // a full disk may be reported only here
  }
  if (!direct && error == 0 && ::rename(target.c_str(), file.c_str()) != 0) error = errno;
  if (error != 0) {
    if (!direct) ::unlink(target.c_str());
    fail(error);
  }
}

}  // namespace oxturn
