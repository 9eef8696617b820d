#include "metrics/crossing_detector.hpp"

#include <algorithm>

#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

constexpr double kSame = 1e-6;  // of a drive: one point, computed in two ways, differs by less

Box box_of(const Point& a, const Point& b) {
  Box box;
  box.add(a);
  box.add(b);
  return box;
}

/// On which side of the line from `from` to `to` a point of the line lies after the shift by (e, e^2): the sign of
/// cross(to - from, (e, e^2)). 0 only if the points are equal.
int side_of_shift(const Point& from, const Point& to) {
  if (from.y() != to.y()) return to.y() > from.y() ? -1 : 1;
  return to.x() > from.x() ? 1 : to.x() < from.x() ? -1 : 0;
}

/// Does the shifted drive from a to b cross the segment cd?
bool crosses_shifted(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto side_of_segment = [&](const Point& p) {  // of the shifted point p, seen along cd
    const int exact = orientation(c, d, p);
    return exact != 0 ? exact : side_of_shift(c, d);
  };
  const auto side_of_drive = [&](const Point& p) {  // of p, seen along the shifted drive
    const int exact = orientation(a, b, p);
    return exact != 0 ? exact : -side_of_shift(a, b);
  };
  return side_of_segment(a) != side_of_segment(b) && side_of_drive(c) != side_of_drive(d);
}

}  // namespace

std::vector<Point> CrossingDetector::crossings(const TautTether& tether, const Point& to) {
  const Point &a = tether.robot(), &b = to;
  if (a == b) return {};
  follow(tether);
  std::vector<Candidate> found;
  std::vector<std::size_t> touched;
  for (const std::size_t i : segments_near(box_of(a, b))) {
    const Point &c = points_[i], &d = points_[i + 1];
    const Crossing how = crossing(a, b, c, d);
    if (how == Crossing::proper) {
      const double t = std::clamp(cross(c - a, d - c) / cross(b - a, d - c), 0.0, 1.0);
      found.push_back({lerp(a, b, t), i, false, t});
    } else if (how != Crossing::none) {
      touched.push_back(i);
    }
  }
  follow_contacts(touched, a, b, found);
  std::erase_if(found, [&](const Candidate& c) { return distance(c.at, tether.anchor()) <= rounding_; });

  std::stable_sort(found.begin(), found.end(),
                   [](const Candidate& p, const Candidate& q) { return p.along < q.along; });
  std::vector<Point> result;
  std::vector<const Candidate*> kept;
  for (const Candidate& candidate : found) {
    bool known = false;
    for (std::size_t k = kept.size(); k-- > 0 && !known && candidate.along - kept[k]->along < kSame;)
      known = same(*kept[k], candidate);
    if (known) continue;
    kept.push_back(&candidate);
    result.push_back(candidate.at);
  }
  return result;
}

/// Takes over the tether's bends as they are now.
void CrossingDetector::follow(const TautTether& tether) {
  if (points_.empty()) points_.push_back(tether.anchor());
  const std::vector<TautTether::Bend>& bends = tether.bends();
  points_.resize(std::min({points_.size(), 1 + tether.kept(), 1 + bends.size()}), tether.anchor());
  std::size_t per_box = 1;  // segments
  for (std::vector<Box>& level : boxes_) {
    per_box *= kFan;
    level.resize((points_.size() - 1 + per_box - 1) / per_box);
  }
  while (points_.size() <= bends.size()) {
    std::size_t block = points_.size() - 1;
    points_.push_back(bends[block].at);
    for (std::vector<Box>& level : boxes_) {
      block /= kFan;
      if (block == level.size()) level.emplace_back();
      level[block].add(points_.end()[-2]);
      level[block].add(points_.back());
    }
  }
}

/// The segments whose boxes overlap the box of the drive, ascending.
std::vector<std::size_t> CrossingDetector::segments_near(const Box& drive) const {
  std::vector<std::size_t> near;
  add_near(drive, kLevels - 1, 0, boxes_.back().size(), near);
  return near;
}

/// Of the boxes from .. until - 1 of a level.
void CrossingDetector::add_near(const Box& drive, std::size_t level, std::size_t from, std::size_t until,
                                std::vector<std::size_t>& near) const {
  for (std::size_t i = from; i < until; ++i) {
    if (!boxes_[level][i].overlaps(drive)) continue;
    const std::size_t count = level == 0 ? points_.size() - 1 : boxes_[level - 1].size();
    const std::size_t first = i * kFan, last = std::min(first + kFan, count);
    if (level > 0) {
      add_near(drive, level - 1, first, last, near);
      continue;
    }
    for (std::size_t k = first; k < last; ++k)
      if (box_of(points_[k], points_[k + 1]).overlaps(drive)) near.push_back(k);
  }
}

/// Groups the touched segments into contacts, and adds a crossing for each contact that ends on the other side.
void CrossingDetector::follow_contacts(const std::vector<std::size_t>& touched, const Point& a, const Point& b,
                                       std::vector<Candidate>& found) {
  std::vector<Contact> still;  // at b
  for (std::size_t k = 0; k < touched.size();) {
    Contact contact{touched[k], touched[k], false, true};
    for (++k; k < touched.size() && touched[k] == contact.last + 1 && on_segment(points_[touched[k]], a, b); ++k)
      contact.last = touched[k];
    const Candidate leaves = extend(contact, a, b);
    const auto touches = [&](const Point& p) {
      for (std::size_t i = contact.first; i <= contact.last; ++i)
        if (on_segment(p, points_[i], points_[i + 1])) return true;
      return false;
    };
    if (touches(a)) contact.counts = inherit(contact) && contact.counts;
    if (touches(b))
      still.push_back(contact);
    else if (contact.odd && contact.counts)
      found.push_back(leaves);
  }
  contacts_ = std::move(still);
}

/// Follows a contact along the drive. Returns where the drive leaves the contact's segments.
CrossingDetector::Candidate CrossingDetector::extend(Contact& contact, const Point& a, const Point& b) const {
  Candidate leaves{a, 0, true, 0};
  for (std::size_t i = contact.first; i <= contact.last; ++i) {
    contact.odd = contact.odd != crosses_shifted(a, b, points_[i], points_[i + 1]);
    for (const std::size_t end : {i, i + 1}) {
      if (!on_segment(points_[end], a, b)) continue;
      if (end == 0 || end + 1 == points_.size()) contact.counts = false;
      const double along = (points_[end] - a).dot(b - a) / (b - a).squaredNorm();
      if (along > leaves.along) leaves = {points_[end], 0, true, along};
    }
  }
  return leaves;
}

/// Continues the contacts of earlier drives with the same segments; false if there is none.
bool CrossingDetector::inherit(Contact& contact) const {
  bool any = false;
  for (const Contact& before : contacts_) {
    if (before.last < contact.first || before.first > contact.last) continue;
    any = true;
    contact.odd = contact.odd != before.odd;
    contact.counts = contact.counts && before.counts;
  }
  return any;
}

/// Are these the same point of the plane?
bool CrossingDetector::same(const Candidate& p, const Candidate& q) const {
  const auto on_line = [&](std::size_t segment, const Point& x) {
    return orientation(points_[segment], points_[segment + 1], x) == 0;
  };
  if (p.exact && q.exact) return p.at == q.at;
  if (p.exact) return on_line(q.segment, p.at);
  if (q.exact) return on_line(p.segment, q.at);
  const Point &a = points_[p.segment], &b = points_[p.segment + 1], &c = points_[q.segment],
              &d = points_[q.segment + 1];
  if ((a == c && b == d) || (a == d && b == c)) return true;  // most layers: cheaper than exact predicates
  return on_line(p.segment, c) && on_line(p.segment, d);
}

}  // namespace oxturn
