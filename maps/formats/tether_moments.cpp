#include "maps/formats/tether_moments.hpp"

#include <algorithm>

#include "maps/followed_path.hpp"

namespace oxturn {
namespace {

constexpr double kSame = 1e-9;  // of the path's length: moments nearer than this are one

/// Metres driven until the tether is longest.
double longest_after(const Problem& problem, const Polyline& path) {
  TautTether tether = tether_at_start(problem);
  double most = tether.length(), driven = 0, after = 0;
  const auto note = [&](double length, double path_m) {
    if (length <= most) return;
    most = length;
    after = path_m;
  };
  for (const Point& to : path) {
    const Point from = tether.robot();
    tether.drive(to, [&](const TautTether::Swing& swing) {
      note(swing.before + distance(swing.pivot, swing.to), driven + distance(from, swing.to));
    });
    driven += distance(from, to);
    note(tether.length(), driven);
  }
  return after;
}

/// The moments in driving order, without their tethers.
std::vector<TetherMoment> chosen_moments(double total, int count, double longest) {
  std::vector<TetherMoment> moments;
  for (int k = 1; k <= count; ++k) moments.push_back({{}, 0, total * k / count, false});
  // Often the tether is longest at the end, which is one of these but for rounding.
  const auto same = std::find_if(moments.begin(), moments.end(),
                                 [&](const TetherMoment& m) { return std::abs(m.path_m - longest) <= kSame * total; });
  if (same != moments.end())
    same->longest = true;
  else
    moments.push_back({{}, 0, longest, true});
  std::stable_sort(moments.begin(), moments.end(),
                   [](const TetherMoment& a, const TetherMoment& b) { return a.path_m < b.path_m; });
  return moments;
}

}  // namespace

std::vector<TetherMoment> tether_moments(const Problem& problem, const Path& path, int count) {
  const Polyline points = followed_path(problem, path, EdgeIndex(problem.map().free)).points;
  const double total = length(points);
  if (!(total > 0) || count <= 0) return {};
  std::vector<TetherMoment> moments = chosen_moments(total, count, longest_after(problem, points));
  TautTether tether = tether_at_start(problem);
  double driven = 0;
  auto next = moments.begin();
  const auto keep = [&] {
    next->line = tether.polyline();
    next->length = tether.length();
    ++next;
  };
  for (const Point& to : points) {
    const Point from = tether.robot();
    const double metres = distance(from, to);
    while (next != moments.end() && next->path_m < driven + metres) {
      tether.drive(lerp(from, to, std::clamp((next->path_m - driven) / metres, 0.0, 1.0)));
      keep();
    }
    tether.drive(to);
    driven += metres;
  }
  while (next != moments.end()) keep();
  return moments;
}

}  // namespace oxturn
