#include "maps/formats/tether_moments.hpp"

#include <algorithm>

#include "maps/followed_path.hpp"

namespace oxturn {
namespace {

/// Metres driven where the tether is longest.
double longest_after(const Problem& problem, const Polyline& way) {
  TautTether string = tether_at_start(problem);
  double most = string.length(), driven = 0, where = 0;
  const auto lengthen = [&](double length, double path_m) {
    if (length <= most) return;
    most = length;
    where = path_m;
  };
  for (const Point& to : way) {
    const Point from = string.robot();
    string.drive(to, [&](const TautTether::Swing& swing) {
      lengthen(swing.before + distance(swing.pivot, swing.to), driven + distance(from, swing.to));
    });
    driven += distance(from, to);
    lengthen(string.length(), driven);
  }
  return where;
}

}  // namespace

std::vector<TetherMoment> tether_moments(const Problem& problem, const Path& path, int count) {
  const Polyline way = followed_path(problem, path, EdgeIndex(problem.map().free)).points;
  const double total = length(way);
  std::vector<TetherMoment> moments;
  if (!(total > 0) || count <= 0) return moments;
  for (int k = 1; k <= count; ++k) moments.push_back({{}, 0, total * k / count, false});
  // Often the longest is at the end: then it is one of those, but for rounding.
  const double longest = longest_after(problem, way);
  const auto near = std::find_if(moments.begin(), moments.end(),
                                 [&](const TetherMoment& m) { return std::abs(m.path_m - longest) <= 1e-9 * total; });
  if (near != moments.end())
    near->longest = true;
  else
    moments.push_back({{}, 0, longest, true});
  std::stable_sort(moments.begin(), moments.end(),
                   [](const TetherMoment& a, const TetherMoment& b) { return a.path_m < b.path_m; });

  TautTether string = tether_at_start(problem);
  double driven = 0;
  std::size_t next = 0;
  const auto keep = [&] {
    moments[next].line = string.polyline();
    moments[next].length = string.length();
    ++next;
  };
  for (const Point& to : way) {
    const Point from = string.robot();
    const double metres = distance(from, to);
    while (next < moments.size() && moments[next].path_m < driven + metres) {
      string.drive(lerp(from, to, std::clamp((moments[next].path_m - driven) / metres, 0.0, 1.0)));
      keep();
    }
    string.drive(to);
    driven += metres;
  }
  while (next < moments.size()) keep();
  return moments;
}

}  // namespace oxturn
