#include "base/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
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

}  // namespace

std::string read_file(const std::string& file) {
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
  std::string content;
  char buffer[1 << 16];
  for (;;) {
    const ssize_t got = ::read(in.number, buffer, sizeof buffer);
    if (got == 0) return content;
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw_invalid("cannot read '{}': {}", file, std::strerror(errno));
    content.append(buffer, static_cast<std::size_t>(got));
  }
}

void write_file(const std::string& file, const std::string& content) {
  const auto fail = [&](int error) {
    throw std::runtime_error(fmt::format("cannot write '{}': {}", file, std::strerror(error)));
  };
  struct stat about {};
  const bool exists = ::stat(file.c_str(), &about) == 0;
  if (exists && S_ISDIR(about.st_mode)) fail(EISDIR);
  const bool direct = exists && !S_ISREG(about.st_mode);  // a device or pipe, such as /dev/stdout
  static std::atomic<unsigned> serial{0};
  const std::string target =
      direct ? file : fmt::format("{}.{}-{}.tmp", file, ::getpid(), serial.fetch_add(1, std::memory_order_relaxed));
  int error = 0;
  {
    Descriptor out(
        ::open(target.c_str(), direct ? O_WRONLY | O_CLOEXEC : O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (out.number < 0) fail(errno);
    for (std::size_t done = 0; done < content.size() && error == 0;) {
      const ssize_t put = ::write(out.number, content.data() + done, content.size() - done);
      if (put >= 0)
        done += static_cast<std::size_t>(put);
      else if (errno != EINTR)
        error = errno;
    }
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
