/// The least value of a function of one variable that has one minimum in an interval.
///
///   const double t = golden_section([&](double x) { return cost(x); }, 0, 1, 1e-6);
///
/// Source      Kiefer 1953. O(log((high - low) / width)) calls. Not installed.
#pragma once

namespace oxturn {

/// Where it is, to `width`.
template <class Function>
double golden_section(const Function& f, double low, double high, double width) {
  constexpr double kRatio = 0.61803398874989485;
  double a = high - kRatio * (high - low), b = low + kRatio * (high - low);
  double at_a = f(a), at_b = f(b);
  while (high - low > width) {
    if (at_a <= at_b) {
      high = b, b = a, at_b = at_a;
      a = high - kRatio * (high - low), at_a = f(a);
    } else {
      low = a, a = b, at_a = at_b;
      b = low + kRatio * (high - low), at_b = f(b);
    }
  }
  return at_a <= at_b ? a : b;
}

}  // namespace oxturn
