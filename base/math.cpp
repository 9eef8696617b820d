#include "base/math.hpp"

#include <sleef.h>

#include <cmath>

namespace oxturn::math {

double sin(double angle) { return Sleef_cinz_sind1_u35purec(angle); }
double cos(double angle) { return Sleef_cinz_cosd1_u35purec(angle); }
double tan(double angle) { return Sleef_cinz_tand1_u35purec(angle); }
double asin(double x) { return Sleef_cinz_asind1_u35purec(x); }
double acos(double x) { return Sleef_cinz_acosd1_u35purec(x); }
double atan2(double y, double x) { return Sleef_cinz_atan2d1_u35purec(y, x); }
double exp(double x) { return Sleef_cinz_expd1_u10purec(x); }
double log(double x) { return Sleef_cinz_logd1_u35purec(x); }
double log2(double x) { return Sleef_cinz_log2d1_u35purec(x); }
double log10(double x) { return Sleef_cinz_log10d1_u10purec(x); }
double pow(double base, double exponent) { return Sleef_cinz_powd1_u10purec(base, exponent); }
double hypot(double x, double y) { return std::sqrt(x * x + y * y); }

}  // namespace oxturn::math
