/// Predicates for Boost's Voronoi diagram of lattice segments, several times faster than its own. Private to geometry.
///
///   boost::polygon::voronoi_builder<std::int32_t, VoronoiNumbers, VoronoiPredicates> builder;
///
/// Boost computes the circle of three sites in double, with a bound of the error, and where 64 rounding errors
/// are exceeded again with integers of 2048 bits. Two things spare nearly all of the latter: circles are computed about
/// a point of theirs, not about the lattice's origin (on large maps little is left of differences between large
/// numbers), and long double is tried between the two, with the same bound. The diagram is the same; its vertices
/// differ by rounding.
#pragma once

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

namespace oxturn {

using VoronoiNumbers = boost::polygon::detail::voronoi_ctype_traits<std::int32_t>;

/// The first attempt is made in double,
struct FastNumbers : VoronoiNumbers {};

/// the second one in long double.
struct WideNumbers : VoronoiNumbers {
  struct Converter {
    template <class T>
    long double operator()(const T& number) const {
      return static_cast<long double>(number);
    }
    template <std::size_t N>
    long double operator()(const boost::polygon::detail::extended_int<N>& number) const {
      return number.d();
    }
    long double operator()(const efpt_type& number) const { return number.d(); }
  };
  using fpt_type = long double;
  using to_fpt_converter_type = Converter;
};

}  // namespace oxturn

namespace boost::polygon::detail {

/// A number with a bound of its relative error, which is counted in units of long double and told in units of double.
template <>
class robust_fpt<long double> {
 public:
  robust_fpt() = default;
  explicit robust_fpt(long double value, long double error = 0) : value_(value), error_(error) {}
  long double fpv() const { return value_; }
  long double ulp() const { return error_ * kUnit; }
  bool has_pos_value() const { return value_ > 0; }
  bool has_neg_value() const { return value_ < 0; }
  bool has_zero_value() const { return value_ == 0; }

  robust_fpt operator-() const { return robust_fpt(-value_, error_); }
  robust_fpt operator+(const robust_fpt& that) const {
    const long double sum = value_ + that.value_;
    const bool cancels = (value_ < 0 && that.value_ > 0) || (value_ > 0 && that.value_ < 0);
    const long double error =
        cancels ? std::abs((value_ * error_ - that.value_ * that.error_) / sum) : std::max(error_, that.error_);
    return robust_fpt(sum, error + 1);
  }
  robust_fpt operator-(const robust_fpt& that) const { return *this + -that; }
  robust_fpt operator*(const robust_fpt& that) const {
    return robust_fpt(value_ * that.value_, error_ + that.error_ + 1);
  }
  robust_fpt operator/(const robust_fpt& that) const {
    return robust_fpt(value_ / that.value_, error_ + that.error_ + 1);
  }
  robust_fpt& operator+=(const robust_fpt& that) { return *this = *this + that; }
  robust_fpt& operator-=(const robust_fpt& that) { return *this = *this - that; }
  robust_fpt& operator*=(const robust_fpt& that) { return *this = *this * that; }
  robust_fpt& operator/=(const robust_fpt& that) { return *this = *this / that; }
  robust_fpt sqrt() const { return robust_fpt(std::sqrt(value_), error_ / 2 + 1); }

 private:
  static constexpr long double kUnit =
      std::numeric_limits<long double>::epsilon() / static_cast<long double>(std::numeric_limits<double>::epsilon());
  long double value_ = 0, error_ = 0;
};

/// What the first attempt leaves undecided.
template <>
template <typename Site, typename Circle>
class voronoi_predicates<oxturn::FastNumbers>::mp_circle_formation_functor {
 public:
  void ppp(const Site& a, const Site& b, const Site& c, Circle& circle, bool, bool, bool) {
    wide_.ppp(a, b, c, circle);
  }
  void pps(const Site& a, const Site& b, const Site& c, int index, Circle& circle, bool, bool, bool) {
    wide_.pps(a, b, c, index, circle);
  }
  void pss(const Site& a, const Site& b, const Site& c, int index, Circle& circle, bool, bool, bool) {
    wide_.pss(a, b, c, index, circle);
  }
  void sss(const Site& a, const Site& b, const Site& c, Circle& circle, bool, bool, bool) {
    wide_.sss(a, b, c, circle);
  }

 private:
  typename voronoi_predicates<oxturn::WideNumbers>::template lazy_circle_formation_functor<Site, Circle> wide_;
};

}  // namespace boost::polygon::detail

namespace oxturn {

struct VoronoiPredicates : boost::polygon::detail::voronoi_predicates<VoronoiNumbers> {
  /// Boost sorts events by where the sweep line meets them, with a tolerance relative to the distance from the
  /// lattice's origin. A circle about a point of its own has an error of up to 2^-17 of a quantum wherever it is. So
  /// what differs by no more is made equal: a circle that touches a vertical edge near the origin came before the edge.
  static constexpr double kFraction = 65536;

  /// Of events at the same time Boost takes circles first. But a circle about a vertical edge's lower end, from above
  /// it, reaches the edge by less than the tolerance, and Boost would build a vertex that the edge cuts off: two edges
  /// that face each other and end a quantum apart.
  template <class Site, class Circle>
  class event_comparison_predicate
      : public boost::polygon::detail::voronoi_predicates<VoronoiNumbers>::event_comparison_predicate<Site, Circle> {
    using Base = typename boost::polygon::detail::voronoi_predicates<
        VoronoiNumbers>::template event_comparison_predicate<Site, Circle>;

   public:
    using Base::operator();
    bool operator()(const Site& site, const Circle& circle) const {
      if (Base::operator()(site, circle)) return true;
      if (!site.is_segment() || site.x0() != site.x1() || Base::operator()(circle, site)) return false;
      return circle.y() > std::min(site.y0(), site.y1()) && circle.y() < std::max(site.y0(), site.y1());
    }
  };

  template <class Site, class Circle>
  class circle_formation_predicate {
   public:
    bool operator()(const Site& a, const Site& b, const Site& c, Circle& circle) {
      const std::int32_t x = b.x(), y = b.y();
      const auto moved = [&](const Site& s) {
        const Site straight(s.x0() - x, s.y0() - y, s.x1() - x, s.y1() - y);
        Site site = s.is_inverse() ? Site(straight.point1(), straight.point0()).inverse() : straight;
        return site.sorted_index(s.sorted_index());
      };
      if (!at_origin_(moved(a), moved(b), moved(c), circle)) return false;
      circle.x(circle.x() + x);
      circle.y(circle.y() + y);
      circle.lower_x(std::nearbyint((circle.lower_x() + x) * kFraction) / kFraction);
      return true;
    }

   private:
    using Fast = boost::polygon::detail::voronoi_predicates<FastNumbers>;
    typename Fast::template circle_formation_predicate<Site, Circle> at_origin_;
  };
};

}  // namespace oxturn
