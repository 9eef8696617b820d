/// Integrals by 12-point Gauss-Legendre quadrature: exact to rounding for a smooth integrand on a short interval.
///
///   const double length = integral([&](double t) { return velocity_at(curve, t).norm(); }, 0, 1);
///
/// Not installed.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

namespace oxturn {

template <class Function>
auto integral(const Function& f, double a, double b) {
  constexpr std::array<double, 6> kNodes = {0.1252334085114689, 0.3678314989981802, 0.5873179542866175,
                                            0.7699026741943047, 0.9041172563704749, 0.9815606342467192};
  constexpr std::array<double, 6> kWeights = {0.2491470458134028, 0.2334925365383548, 0.2031674267230659,
                                              0.1600783285433462, 0.1069393259953184, 0.0471753363865118};
  const double middle = (a + b) / 2, half = (b - a) / 2;
  using Value = std::decay_t<decltype(f(a))>;
  Value sum = kWeights[0] * (f(middle - half * kNodes[0]) + f(middle + half * kNodes[0]));
  for (std::size_t i = 1; i < kNodes.size(); ++i)
    sum += kWeights[i] * (f(middle - half * kNodes[i]) + f(middle + half * kNodes[i]));
  return Value(half * sum);
}

}  // namespace oxturn
