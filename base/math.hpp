/// Mathematical functions that give the same bits on every machine.
///
///   const double x = math::cos(heading);
///
/// The C library's functions do not: it takes the version that is fastest on the processor at hand, with fused
/// multiplication and addition or without, and their last bits differ; so do those of other libraries. A planner turns
/// the last bit of an angle into another path sooner or later. Sums, products, quotients and square roots are the same
/// everywhere by IEEE 754, as is std::remainder.
///
/// These functions are the deterministic ones of SLEEF, which use nothing else. Errors: at most 3.5 ulp, at most 2 in
/// 100,000 arguments from -7 to 7. Angles in radians. Times in ns, those of glibc 2.36 in brackets:
/// sin 15 (17), cos 9 (16), tan 23 (18), atan2 13 (13), acos 9 (14), asin 8 (14), log 8 (5), exp 17 (5), log10 17 (7),
/// pow 94 (13).
#pragma once

namespace oxturn::math {

double sin(double angle);
double cos(double angle);
double tan(double angle);
double asin(double x);
double acos(double x);
double atan2(double y, double x);
double exp(double x);
double log(double x);
double log2(double x);
double log10(double x);
double pow(double base, double exponent);
/// sqrt(x^2 + y^2), of numbers whose squares are neither infinite nor 0.
double hypot(double x, double y);

}  // namespace oxturn::math
