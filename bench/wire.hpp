/// Frames on a pipe between a process and its parent: [type u8][length u64][payload], in the machine's own byte order
/// (both ends are one program). Internal to bench/.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "geometry/path.hpp"
#include "geometry/region.hpp"
#include "geometry/trace.hpp"
#include "maps/formats.hpp"

namespace oxturn::wire {

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    if (this != &other) {
      close();
      number_ = other.release();
    }
    return *this;
  }
  ~Descriptor() { close(); }
  int number() const { return number_; }
  bool open() const { return number_ >= 0; }
  void close();
  int release() {
    const int number = number_;
    number_ = -1;
    return number;
  }

 private:
  int number_;
};

struct Pipe {
  Descriptor read, write;
};
/// Close-on-exec, as large as the kernel grants. Throws std::runtime_error.
Pipe make_pipe();

/// Blocks until all is written; false if the other end is closed.
bool send(int fd, char type, std::string_view payload);
/// Writes the path without a copy of it, so that it works near the memory limit too.
bool send_path(int fd, char type, const Path& path);
/// Throws std::runtime_error for bytes that are not a path.
Path path_from(std::string_view payload);

std::string pack(const Trace& trace);
Trace trace_from(std::string_view payload);
std::string pack(const Region& region);
Region region_from(std::string_view payload);
/// Without the robot that the file names: suites have robots of their own.
std::string pack(const MapFile& file);
MapFile map_file_from(std::string_view payload);

/// Plain values one after the other, for short messages.
template <class T>
void put(std::string& out, const T& value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}
void put_text(std::string& out, std::string_view text);
/// Takes from the front; throws std::runtime_error if too little is left.
void take_bytes(std::string_view& in, void* to, std::size_t size);
template <class T>
T take(std::string_view& in) {
  T value;
  take_bytes(in, &value, sizeof value);
  return value;
}
std::string take_text(std::string_view& in);

/// Assembles bytes into frames.
class FrameReader {
 public:
  explicit FrameReader(std::uint64_t longest) : longest_(longest) {}
  enum class State { open, closed };
  /// Reads what is there (blocks if nothing is, unless the descriptor does not) and passes complete frames to `frame`.
  /// Throws std::runtime_error for a frame that is too long.
  State read(int fd, const std::function<void(char type, std::string_view payload)>& frame);
  /// The last frame is incomplete.
  bool cut_off() const { return !buffer_.empty(); }

 private:
  std::uint64_t longest_;
  std::string buffer_;
};

}  // namespace oxturn::wire
