#include "bench/wire.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "geometry/trace.hpp"
#include "maps/drawing_file.hpp"

namespace oxturn::wire {

namespace {

constexpr std::size_t kHeader = 1 + sizeof(std::uint64_t);
constexpr int kPipeBytes = 1 << 20;

static_assert(sizeof(Point) == 2 * sizeof(double));

bool write_all(int fd, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t put_now = ::write(fd, data, size);
    if (put_now < 0) {
      if (errno == EINTR) continue;
      return false;
    }
    data += put_now;
    size -= static_cast<std::size_t>(put_now);
  }
  return true;
}

bool send_header(int fd, char type, std::uint64_t size) {
  char header[kHeader];
  header[0] = type;
  std::memcpy(header + 1, &size, sizeof size);
  return write_all(fd, header, sizeof header);
}

/// Collects short pieces, so that a path of many legs takes few calls. After a failure nothing is written any more.
class Collected {
 public:
  explicit Collected(int fd) : fd_(fd) {}
  void put(const void* data, std::size_t size) {
    if (size == 0) return;
    if (size > buffer_.size() - used_) flush();
    if (size > buffer_.size()) {
      open_ = open_ && write_all(fd_, static_cast<const char*>(data), size);
      return;
    }
    std::memcpy(buffer_.data() + used_, data, size);
    used_ += size;
  }
  /// Has all been written?
  bool flush() {
    open_ = open_ && write_all(fd_, buffer_.data(), used_);
    used_ = 0;
    return open_;
  }

 private:
  int fd_;
  bool open_ = true;
  std::size_t used_ = 0;
  std::array<char, 1 << 16> buffer_;
};

void put_points(std::string& out, const Polyline& points) {
  put(out, static_cast<std::uint64_t>(points.size()));
  out.append(reinterpret_cast<const char*>(points.data()), points.size() * sizeof(Point));
}

Polyline take_points(std::string_view& in) {
  const auto count = take<std::uint64_t>(in);
  if (count > in.size() / sizeof(Point)) throw std::runtime_error("fewer points than announced");
  Polyline points(count);
  take_bytes(in, points.data(), count * sizeof(Point));
  return points;
}

}  // namespace

void Descriptor::close() {
  if (number_ >= 0) ::close(number_);
  number_ = -1;
}

Pipe make_pipe() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    throw std::runtime_error(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
  for (int& end : ends) {
    if (end > 2) continue;  // whoever started us had closed the standard streams, whose numbers mean something else
    const int moved = ::fcntl(end, F_DUPFD_CLOEXEC, 3);
    ::close(end);
    if (moved < 0) throw std::runtime_error(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
    end = moved;
  }
  ::fcntl(ends[1], F_SETPIPE_SZ, kPipeBytes);  // only speed: the default works as well
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

bool send(int fd, char type, std::string_view payload) {
  if (payload.size() > 4096)
    return send_header(fd, type, payload.size()) && write_all(fd, payload.data(), payload.size());
  char together[kHeader + 4096];  // one call for a short message
  const std::uint64_t size = payload.size();
  together[0] = type;
  std::memcpy(together + 1, &size, sizeof size);
  std::memcpy(together + kHeader, payload.data(), payload.size());
  return write_all(fd, together, kHeader + payload.size());
}

bool send_path(int fd, char type, const Path& path) {
  std::uint64_t size = sizeof(std::uint64_t);
  for (const Leg& leg : path.legs)
    size += 1 + sizeof(double) + sizeof(std::uint64_t) + leg.points.size() * sizeof(Point);
  if (!send_header(fd, type, size)) return false;
  Collected out(fd);
  const std::uint64_t legs = path.legs.size();
  out.put(&legs, sizeof legs);
  for (const Leg& leg : path.legs) {
    const char kind = static_cast<char>((leg.tool ? 1 : 0) + (leg.gear == Gear::reverse ? 2 : 0));
    const std::uint64_t count = leg.points.size();
    out.put(&kind, 1);
    out.put(&leg.width, sizeof leg.width);
    out.put(&count, sizeof count);
    out.put(leg.points.data(), count * sizeof(Point));
  }
  return out.flush();
}

Path path_from(std::string_view in) {
  Path path;
  const auto legs = take<std::uint64_t>(in);
  if (legs > in.size()) throw std::runtime_error("fewer legs than announced");
  path.legs.reserve(legs);
  for (std::uint64_t i = 0; i < legs; ++i) {
    const char kind = take<char>(in);
    const auto width = take<double>(in);
    path.legs.push_back({(kind & 1) != 0, take_points(in), (kind & 2) != 0 ? Gear::reverse : Gear::forward, width});
  }
  if (!in.empty()) throw std::runtime_error("bytes after the last leg");
  return path;
}

std::string pack(const Trace& trace) {
  std::string out;
  put_text(out, trace.name);
  put(out, static_cast<std::uint64_t>(trace.lines.size()));
  for (const Polyline& line : trace.lines) put_points(out, line);
  return out;
}

Trace trace_from(std::string_view in) {
  Trace trace{take_text(in), {}};
  for (auto left = take<std::uint64_t>(in); left > 0; --left) trace.lines.push_back(take_points(in));
  return trace;
}

namespace {

/// How many bytes put_region() adds.
std::size_t size_of(const Region& region) {
  std::size_t counts = 1;
  for (const Polygon& polygon : region.polygons) counts += 2 + polygon.holes.size();
  return counts * sizeof(std::uint64_t) + vertex_count(region) * sizeof(Point);
}

void put_region(std::string& out, const Region& region) {
  out.reserve(out.size() + size_of(region));
  put(out, static_cast<std::uint64_t>(region.polygons.size()));
  for (const Polygon& polygon : region.polygons) {
    put_points(out, polygon.outer);
    put(out, static_cast<std::uint64_t>(polygon.holes.size()));
    for (const Ring& hole : polygon.holes) put_points(out, hole);
  }
}

Region take_region(std::string_view& in) {
  Region region;
  auto polygons = take<std::uint64_t>(in);
  if (polygons > in.size() / (2 * sizeof(std::uint64_t)))  // what an empty polygon takes
    throw std::runtime_error("fewer polygons than announced");
  region.polygons.reserve(polygons);
  for (; polygons > 0; --polygons) {
    Polygon polygon;
    polygon.outer = take_points(in);
    for (auto holes = take<std::uint64_t>(in); holes > 0; --holes) polygon.holes.push_back(take_points(in));
    region.polygons.push_back(std::move(polygon));
  }
  return region;
}

void put_point(std::string& out, const std::optional<Point>& p) { put_points(out, p ? Polyline{*p} : Polyline{}); }

std::optional<Point> take_point(std::string_view& in) {
  const Polyline points = take_points(in);
  return points.empty() ? std::nullopt : std::optional<Point>(points[0]);
}

}  // namespace

std::string pack(const Region& region) {
  std::string out;
  put_region(out, region);
  return out;
}

Region region_from(std::string_view in) { return take_region(in); }

std::string pack(const MapFile& file) {
  std::string out;
  for (const std::string& text : {file.map.name, file.map.family, file.map.source}) put_text(out, text);
  put_region(out, file.map.free);
  put_region(out, file.map.target_area.value_or(Region{}));
  put_point(out, file.start);
  put_point(out, file.anchor);
  put_text(out, file.map.drawing ? to_geojson(*file.map.drawing) : "");
  for (const std::string& remark : file.remarks) put_text(out, remark);
  return out;
}

MapFile map_file_from(std::string_view in) {
  MapFile file;
  for (std::string* text : {&file.map.name, &file.map.family, &file.map.source}) *text = take_text(in);
  file.map.free = take_region(in);
  if (Region target = take_region(in); !target.empty()) file.map.target_area = std::move(target);
  file.start = take_point(in);
  file.anchor = take_point(in);
  if (const std::string drawing = take_text(in); !drawing.empty())
    file.map.drawing = std::make_shared<const Drawing>(drawing_from_geojson(drawing, "a worker's message"));
  while (!in.empty()) file.remarks.push_back(take_text(in));
  return file;
}

void put_text(std::string& out, std::string_view text) {
  put(out, static_cast<std::uint64_t>(text.size()));
  out.append(text);
}

void take_bytes(std::string_view& in, void* to, std::size_t size) {
  if (in.size() < size) throw std::runtime_error("a message that ends too early");
  if (size > 0) std::memcpy(to, in.data(), size);
  in.remove_prefix(size);
}

std::string take_text(std::string_view& in) {
  const auto size = take<std::uint64_t>(in);
  if (size > in.size()) throw std::runtime_error("a text that ends too early");
  std::string text(in.substr(0, size));
  in.remove_prefix(size);
  return text;
}

FrameReader::State FrameReader::read(int fd, const std::function<void(char, std::string_view)>& frame) {
  thread_local std::vector<char> chunk(kPipeBytes);
  const ssize_t got = ::read(fd, chunk.data(), chunk.size());
  if (got < 0) {
    if (errno == EINTR || errno == EAGAIN) return State::open;
    throw std::runtime_error(fmt::format("cannot read from a pipe: {}", std::strerror(errno)));
  }
  if (got == 0) return State::closed;
  buffer_.append(chunk.data(), static_cast<std::size_t>(got));
  std::size_t done = 0;
  while (buffer_.size() - done >= kHeader) {
    std::uint64_t size = 0;
    std::memcpy(&size, buffer_.data() + done + 1, sizeof size);
    if (size > longest_)
      throw std::runtime_error(fmt::format("a message of {} bytes, more than the limit of {}", size, longest_));
    if (const std::size_t whole = done + kHeader + size; buffer_.size() < whole) {
      buffer_.reserve(whole);  // not by doubling: a path may be a large part of the memory
      break;
    }
    frame(buffer_[done], std::string_view(buffer_).substr(done + kHeader, size));
    done += kHeader + size;
  }
  buffer_.erase(0, done);
  return State::open;
}

}  // namespace oxturn::wire
