#include "metrics/tether_crossings.hpp"

#include <algorithm>

#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

constexpr double kRounding = 1e-6;  // of a drive's length: one place, computed in two ways, is nearer than that

/// Side of a vector v on which (e, e^2) lies: sign of cross(v, (e, e^2)). Not 0 unless v is.
int side_of_shift(const Point& from, const Point& to) {
  if (from.y() != to.y()) return to.y() > from.y() ? -1 : 1;
  return to.x() > from.x() ? 1 : to.x() < from.x() ? -1 : 0;
}

/// Does the shifted way from a to b cross the segment cd?
bool crosses_shifted(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto side_of_way = [&](const Point& p) {  // of the shifted p, seen along cd
    const int exact = orientation(c, d, p);
    return exact != 0 ? exact : side_of_shift(c, d);
  };
  const auto side_of_string = [&](const Point& p) {  // of p, seen along the shifted way
    const int exact = orientation(a, b, p);
    return exact != 0 ? exact : -side_of_shift(a, b);
  };
  return side_of_way(a) != side_of_way(b) && side_of_string(c) != side_of_string(d);
}

}  // namespace

std::vector<Point> OwnLine::crossed(const TautTether& string, const Point& to) {
  const Point &a = string.robot(), &b = to;
  if (a == b) return {};
  follow(string);
  std::vector<Location> places;
  std::vector<std::size_t> near, touched;
  Box way;
  way.add(a);
  way.add(b);
  find_near(way, kLevels - 1, 0, boxes_.back().size(), near);
  for (const std::size_t i : near) {
    const Point &c = corners_[i], &d = corners_[i + 1];
    const Crossing how = crossing(a, b, c, d);
    if (how == Crossing::proper) {
      const double t = std::clamp(cross(c - a, d - c) / cross(b - a, d - c), 0.0, 1.0);
      places.push_back({lerp(a, b, t), i, false, t});
    } else if (how != Crossing::none) {
      touched.push_back(i);
    }
  }
  if (touched.empty())
    contacts_.clear();
  else
    meet_contacts(touched, a, b, places);

  std::stable_sort(places.begin(), places.end(), [](const Location& p, const Location& q) { return p.along < q.along; });
  std::vector<Point> result;
  std::vector<const Location*> kept;
  for (const Location& place : places) {
    bool known = false;
    for (std::size_t k = kept.size(); k-- > 0 && !known && place.along - kept[k]->along < kRounding;)
      known = same(*kept[k], place);
    if (known) continue;
    kept.push_back(&place);
    result.push_back(place.at);
  }
  return result;
}

void OwnLine::follow(const TautTether& string) {
  if (corners_.empty()) corners_.push_back(string.anchor());
  const std::vector<TautTether::Bend>& bends = string.bends();
  corners_.resize(std::min({corners_.size(), 1 + string.kept(), 1 + bends.size()}), string.anchor());
  std::size_t held = 1;  // segments in a box
  for (std::vector<Box>& level : boxes_) {
    held *= kFan;
    level.resize((corners_.size() - 1 + held - 1) / held);
  }
  while (corners_.size() <= bends.size()) {
    std::size_t block = corners_.size() - 1;
    corners_.push_back(bends[block].at);
    for (std::vector<Box>& level : boxes_) {
      block /= kFan;
      if (block == level.size()) level.emplace_back();
      level[block].add(corners_.end()[-2]);
      level[block].add(corners_.back());
    }
  }
}

void OwnLine::find_near(const Box& way, std::size_t level, std::size_t from, std::size_t until,
                        std::vector<std::size_t>& near) const {
  for (std::size_t i = from; i < until; ++i) {
    if (!boxes_[level][i].overlaps(way)) continue;
    const std::size_t count = level == 0 ? corners_.size() - 1 : boxes_[level - 1].size();
    const std::size_t first = i * kFan, last = std::min(first + kFan, count);
    if (level > 0) {
      find_near(way, level - 1, first, last, near);
      continue;
    }
    for (std::size_t k = first; k < last; ++k) {
      const Point &c = corners_[k], &d = corners_[k + 1];
      const bool apart = (c.x() < way.low.x() && d.x() < way.low.x()) ||
                         (c.x() > way.high.x() && d.x() > way.high.x()) ||
                         (c.y() < way.low.y() && d.y() < way.low.y()) || (c.y() > way.high.y() && d.y() > way.high.y());
      if (!apart) near.push_back(k);
    }
  }
}

void OwnLine::meet_contacts(const std::vector<std::size_t>& touched, const Point& a, const Point& b,
                            std::vector<Location>& places) {
  const auto on_way = [&](std::size_t corner) { return on_segment(corners_[corner], a, b); };
  std::vector<Contact> still;
  for (std::size_t k = 0; k < touched.size();) {
    Contact now{touched[k], touched[k], false, true};
    for (++k; k < touched.size() && touched[k] == now.last + 1 && on_way(touched[k]); ++k) now.last = touched[k];
    bool at_a = false, at_b = false;
    Location leaves{a, 0, true, 0};
    for (std::size_t i = now.first; i <= now.last; ++i) {
      const Point &c = corners_[i], &d = corners_[i + 1];
      now.odd = now.odd != crosses_shifted(a, b, c, d);
      at_a = at_a || on_segment(a, c, d);
      at_b = at_b || on_segment(b, c, d);
      for (const std::size_t corner : {i, i + 1}) {
        if (!on_way(corner)) continue;
        if (corner == 0 || corner + 1 == corners_.size()) now.counts = false;
        const double along = (corners_[corner] - a).dot(b - a) / (b - a).squaredNorm();
        if (along > leaves.along) leaves = {corners_[corner], 0, true, along};
      }
    }
    if (at_a) {
      bool came = false;
      for (const Contact& before : contacts_) {
        if (before.last < now.first || before.first > now.last) continue;
        came = true;
        now.odd = now.odd != before.odd;
        now.counts = now.counts && before.counts;
      }
      now.counts = now.counts && came;
    }
    if (at_b)
      still.push_back(now);
    else if (now.odd && now.counts)
      places.push_back(leaves);
  }
  contacts_ = std::move(still);
}

bool OwnLine::same(const Location& p, const Location& q) const {
  const auto on_line = [&](std::size_t line, const Point& x) {
    return orientation(corners_[line], corners_[line + 1], x) == 0;
  };
  if (p.exact && q.exact) return p.at == q.at;
  if (p.exact) return on_line(q.line, p.at);
  if (q.exact) return on_line(p.line, q.at);
  const Point &a = corners_[p.line], &b = corners_[p.line + 1], &c = corners_[q.line], &d = corners_[q.line + 1];
  if ((a == c && b == d) || (a == d && b == c)) return true;  // most layers: cheaper than exact predicates
  return on_line(p.line, c) && on_line(p.line, d);
}

}  // namespace oxturn
