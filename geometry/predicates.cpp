// Source      Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates", 1997: his
//             first error bound (in the header), then exact expansions without his intermediate stages.
#include "geometry/predicates.hpp"

#include <algorithm>
#include <array>

namespace oxturn {
namespace {

/// A sum of doubles without rounding, as a list of components of increasing magnitude that do not overlap.
class Expansion {
 public:
  void add_product(double a, double b, double sign) {
    const double p = a * b;
    add(sign * std::fma(a, b, -p));
    add(sign * p);
  }
  int sign() const {
    for (int i = size_; i-- > 0;)
      if (part_[static_cast<std::size_t>(i)] != 0) return part_[static_cast<std::size_t>(i)] > 0 ? 1 : -1;
    return 0;
  }

 private:
  void add(double x) {
    int kept = 0;
    for (int i = 0; i < size_; ++i) {  // two-sum of x and each component: the low word stays, the high word is carried
      const double a = part_[static_cast<std::size_t>(i)];
      const double sum = a + x;
      const double virt = sum - a;
      const double low = (a - (sum - virt)) + (x - virt);
      x = sum;
      if (low != 0) part_[static_cast<std::size_t>(kept++)] = low;
    }
    if (x != 0) part_[static_cast<std::size_t>(kept++)] = x;
    size_ = kept;
  }
  std::array<double, 12> part_{};
  int size_ = 0;
};

int exact_orientation(const Point& a, const Point& b, const Point& c) {
  Expansion sum;  // ax by - ay bx + bx cy - by cx + cx ay - cy ax
  sum.add_product(a.x(), b.y(), 1);
  sum.add_product(a.y(), b.x(), -1);
  sum.add_product(b.x(), c.y(), 1);
  sum.add_product(b.y(), c.x(), -1);
  sum.add_product(c.x(), a.y(), 1);
  sum.add_product(c.y(), a.x(), -1);
  return sum.sign();
}

bool in_box(const Point& p, const Point& a, const Point& b) {
  return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) && std::min(a.y(), b.y()) <= p.y() &&
         p.y() <= std::max(a.y(), b.y());
}

}  // namespace

int orientation_unfiltered(const Point& a, const Point& b, const Point& c) {
  if (a == b || b == c || a == c) return 0;
  if (a.x() == b.x() && b.x() == c.x()) return 0;
  if (a.y() == b.y() && b.y() == c.y()) return 0;
  return exact_orientation(a, b, c);
}

bool on_segment(const Point& p, const Point& a, const Point& b) { return in_box(p, a, b) && orientation(a, b, p) == 0; }

Crossing crossing(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (std::max(a.x(), b.x()) < std::min(c.x(), d.x()) || std::max(c.x(), d.x()) < std::min(a.x(), b.x()) ||
      std::max(a.y(), b.y()) < std::min(c.y(), d.y()) || std::max(c.y(), d.y()) < std::min(a.y(), b.y()))
    return Crossing::none;
  const int abc = orientation(a, b, c), abd = orientation(a, b, d);
  if (abc * abd > 0) return Crossing::none;
  const int cda = orientation(c, d, a), cdb = orientation(c, d, b);
  if (cda * cdb > 0) return Crossing::none;
  if (abc * abd < 0 && cda * cdb < 0) return Crossing::proper;
  if (abc == 0 && abd == 0 && cda == 0 && cdb == 0) {  // on one line, or a point on it
    const auto [low1, high1] = before(b, a) ? std::pair(b, a) : std::pair(a, b);
    const auto [low2, high2] = before(d, c) ? std::pair(d, c) : std::pair(c, d);
    const Point low = before(low1, low2) ? low2 : low1, high = before(high1, high2) ? high1 : high2;
    return low == high ? Crossing::touch : before(low, high) ? Crossing::overlap : Crossing::none;
  }
  const bool touch = (abc == 0 && in_box(c, a, b)) || (abd == 0 && in_box(d, a, b)) || (cda == 0 && in_box(a, c, d)) ||
                     (cdb == 0 && in_box(b, c, d));
  return touch ? Crossing::touch : Crossing::none;
}

}  // namespace oxturn
