/// Publishes a path while it is being built, whenever it has grown by a quarter: all that is published is at most five
/// times as long as the path.
///
///   GrownPath grown(context);
///   for (...) { path.drive(...); grown.offer(path.path()); }
#pragma once

#include "algorithms/context.hpp"
#include "geometry/point_count.hpp"

namespace oxturn {

class GrownPath {
 public:
  explicit GrownPath(Context& context) : context_(context) {}
  /// O(legs), and the path's length when it is published.
  void offer(const Path& path) { offer(path, point_count(path.legs)); }
  /// The same, `points` counted by the caller.
  void offer(const Path& path, std::size_t points) {
    if (points == 0 || static_cast<double>(points) < kGrownEnough * static_cast<double>(published_)) return;
    published_ = points;
    context_.publish(path);
  }

 private:
  static constexpr double kGrownEnough = 1.25;
  Context& context_;
  std::size_t published_ = 0;  // points
};

}  // namespace oxturn
