#include "metrics/convex.hpp"

#include <algorithm>

namespace oxturn {

Convex box_of(const Extent& e) {
  Convex c;
  c.add(e.centre + Vec{-e.half.x, -e.half.y});
  c.add(e.centre + Vec{e.half.x, -e.half.y});
  c.add(e.centre + Vec{e.half.x, e.half.y});
  c.add(e.centre + Vec{-e.half.x, e.half.y});
  return c;
}

Vec middle_of(const Convex& c) {
  Vec sum{0, 0};
  for (std::size_t i = 0; i < c.size; ++i) sum = sum + c.at[i];
  return (1.0 / static_cast<double>(c.size)) * sum;
}

double area(const Convex& c) {
  double twice = 0;
  for (std::size_t i = 2; i < c.size; ++i) twice += cross(c.at[i - 1] - c.at[0], c.at[i] - c.at[0]);
  return twice > 0 ? twice / 2 : 0;
}

double area(const std::vector<Convex>& pieces) {
  double sum = 0;
  for (const Convex& c : pieces) sum += area(c);
  return sum;
}

namespace {

double beyond(const HalfPlane& h, Vec p) { return dot(h.normal, p) - h.reach; }

enum class Side { inside, outside, both };

/// Both parts in one pass, computed only if the line cuts; `outside` may be null.
Side split(const Convex& c, const HalfPlane& h, Convex& inside, Convex* outside) {
  std::array<double, Convex::kMost> off;
  bool any_in = false, any_out = false;
  for (std::size_t i = 0; i < c.size; ++i) {
    off[i] = beyond(h, c.at[i]);
    (off[i] > kSlack ? any_out : any_in) = true;
  }
  if (!any_out) return Side::inside;
  if (!any_in) return Side::outside;
  inside.size = 0;
  if (outside != nullptr) outside->size = 0;
  std::size_t last = c.size - 1;
  for (std::size_t i = 0; i < c.size; last = i++) {
    const double s = off[last], t = off[i];
    const Vec p = c.at[last], q = c.at[i];
    if ((s > kSlack) != (t > kSlack)) {
      const double f = s / (s - t);  // outside [0, 1] by the slack at most
      const Vec x = f <= 0 ? p : f >= 1 ? q : p + f * (q - p);
      inside.add(x);
      if (outside != nullptr) outside->add(x);
    }
    if (t > kSlack) {
      if (outside != nullptr) outside->add(q);
    } else {
      inside.add(q);
    }
  }
  return Side::both;
}

/// Appends c \ (intersection of cut[from...]) to `out`.
void subtract_from(const Convex& c, const std::vector<HalfPlane>& cut, std::size_t from, std::vector<Convex>& out) {
  Convex one, two, outside;
  const Convex* rest = &c;
  for (std::size_t k = from; k < cut.size(); ++k) {
    if (rest->size > Convex::kWide) {
      const auto [left, right] = halves(*rest);
      subtract_from(left, cut, k, out);
      subtract_from(right, cut, k, out);
      return;
    }
    Convex& inside = rest == &one ? two : one;
    const Side side = split(*rest, cut[k], inside, &outside);
    if (side == Side::inside) continue;
    if (side == Side::outside) {
      out.push_back(*rest);
      return;
    }
    if (outside.size >= 3) out.push_back(outside);
    if (inside.size < 3) return;
    rest = &inside;
  }
}

}  // namespace

std::pair<Convex, Convex> halves(const Convex& c) {
  std::pair<Convex, Convex> result;
  const std::size_t half = c.size / 2;
  for (std::size_t i = 0; i <= half; ++i) result.first.add(c.at[i]);
  for (std::size_t i = half; i < c.size; ++i) result.second.add(c.at[i]);
  result.second.add(c.at[0]);
  return result;
}

Extent extent_of(std::span<const Convex> pieces) {
  Vec low{1, 1}, high{-1, -1};
  for (const Convex& c : pieces) {
    for (std::size_t i = 0; i < c.size; ++i) {
      low = {std::min(low.x, c.at[i].x), std::min(low.y, c.at[i].y)};
      high = {std::max(high.x, c.at[i].x), std::max(high.y, c.at[i].y)};
    }
  }
  return {0.5 * (low + high), 0.5 * (high - low)};
}

const Convex* clip(const Convex& c, const HalfPlane& h, Convex& cut) {
  switch (split(c, h, cut, nullptr)) {
    case Side::inside:
      return &c;
    case Side::outside:
      return nullptr;
    case Side::both:
      break;
  }
  return cut.size < 3 ? nullptr : &cut;
}

void divide(const Convex& c, const HalfPlane& h, std::vector<Convex>& out) {
  Convex inside, outside;
  if (split(c, h, inside, &outside) != Side::both) {
    out.push_back(c);
    return;
  }
  for (const Convex* part : {&inside, &outside})
    if (part->size >= 3) out.push_back(*part);
}

bool subtract(const Convex& c, const std::vector<HalfPlane>& cut, std::vector<Convex>& out,
              std::vector<HalfPlane>& crossing) {
  crossing.clear();
  for (const HalfPlane& h : cut) {
    double least = beyond(h, c.at[0]), most = least;
    for (std::size_t i = 1; i < c.size; ++i) {
      const double off = beyond(h, c.at[i]);
      least = std::min(least, off);
      most = std::max(most, off);
    }
    if (least >= -kSlack) return false;
    if (most > kSlack) crossing.push_back(h);
  }
  subtract_from(c, crossing, 0, out);
  return true;
}

}  // namespace oxturn
