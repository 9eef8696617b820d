#include "algorithms/drawing/stroke_copies.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace oxturn {
namespace {

bool less(const Point& a, const Point& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); }

/// Whether the stroke's points, read from its last to its first, come before those read forwards.
bool reads_backwards(const DrawingElement& e) {
  if (e.closed) return false;
  const Polyline& line = e.legs.front().points;
  for (std::size_t i = 0, j = line.size(); i < line.size(); ++i) {
    --j;
    if (line[i] != line[j]) return less(line[j], line[i]);
  }
  return false;
}

/// A stroke as it is compared.
struct Reading {
  const DrawingElement* stroke;
  bool backwards;

  friend bool operator<(const Reading& a, const Reading& b) {
    if (a.stroke->closed != b.stroke->closed) return b.stroke->closed;
    const Polyline &p = a.stroke->legs.front().points, &q = b.stroke->legs.front().points;
    if (p.size() != q.size()) return p.size() < q.size();
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Point &s = p[a.backwards ? p.size() - 1 - i : i], &t = q[b.backwards ? q.size() - 1 - i : i];
      if (s != t) return less(s, t);
    }
    return a.stroke->entries < b.stroke->entries;
  }
};

}  // namespace

std::vector<std::vector<StrokeCopy>> stroke_copies(const std::vector<DrawingElement>& elements) {
  std::vector<std::vector<StrokeCopy>> groups;
  std::map<Reading, std::size_t> group_of;
  std::vector<bool> first_backwards;  // by group
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const DrawingElement& e = elements[k];
    const bool alone = e.is_fill() || e.legs.size() != 1 || e.one_way;
    const bool backwards = !alone && reads_backwards(e);
    std::size_t group = groups.size();
    if (!alone) group = group_of.insert({{&e, backwards}, group}).first->second;
    if (group == groups.size()) {
      groups.emplace_back();
      first_backwards.push_back(backwards);
    }
    groups[group].push_back({k, backwards != first_backwards[group]});
  }
  return groups;
}

}  // namespace oxturn
