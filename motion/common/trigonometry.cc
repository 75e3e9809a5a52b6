#include "motion/common/trigonometry.h"

#include <cmath>
#include <cstdint>

namespace oncard::motion {
namespace {

/// pi/2 as a sum of three parts; products of the first two with small integers are exact.
constexpr double kHalfPi1 = 1.57079632673412561417e+00;
constexpr double kHalfPi2 = 6.07710050630396597660e-11;
constexpr double kHalfPi3 = 2.02226624879595063154e-21;

/// The difference between pi or pi/2 and its double value.
constexpr double kPiLow = 1.2246467991473531772e-16;
constexpr double kHalfPi = 1.57079632679489655800e+00;
constexpr double kHalfPiLow = 6.12323399573676603587e-17;

/// sin(x + tail) and cos(x + tail) for |x| <= pi/4.
double SinePolynomial(double x, double tail) {
  const double z = x * x;
  const double v = z * x;
  const double r = 8.33333333332248946124e-03 +
                   z * (-1.98412698298579493134e-04 +
                        z * (2.75573137070700676789e-06 +
                             z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
  return x - ((z * (0.5 * tail - v * r) - tail) - v * -1.66666666666666324348e-01);
}

double CosinePolynomial(double x, double tail) {
  const double z = x * x;
  const double r =
      z * (4.16666666666666019037e-02 +
           z * (-1.38888888888741095749e-03 +
                z * (2.48015872894767294178e-05 +
                     z * (-2.75573143513906633035e-07 +
                          z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
  const double half = 0.5 * z;
  const double w = 1 - half;
  return w + (((1 - w) - half) + (z * r - x * tail));
}

/// atan(x) - x for small x.
double ArcTangentPolynomial(double x) {
  constexpr double kCoefficients[] = {
      3.33333333333329318027e-01,  -1.99999999998764832476e-01, 1.42857142725034663711e-01,
      -1.11111104054623557880e-01, 9.09088713343650656196e-02,  -7.69187620504482999495e-02,
      6.66107313738753120669e-02,  -5.83357013379057348645e-02, 4.97687799461593236017e-02,
      -3.65315727442169155270e-02, 1.62858201153657823623e-02};
  const double z = x * x;
  double sum = 0;
  for (int i = 10; i >= 0; --i) sum = sum * z + kCoefficients[i];
  return -x * (z * sum);
}

/// atan of x >= 0.
double ArcTangent(double x) {
  if (x < 0.4375) return x + ArcTangentPolynomial(x);
  double high = kHalfPi;
  double low = kHalfPiLow;
  if (x < 0.6875) {
    high = 4.63647609000806093515e-01;
    low = 2.26987774529616870924e-17;
    x = (2 * x - 1) / (2 + x);
  } else if (x < 1.1875) {
    high = 7.85398163397448278999e-01;
    low = 3.06161699786838301793e-17;
    x = (x - 1) / (x + 1);
  } else if (x < 2.4375) {
    high = 9.82793723247329054082e-01;
    low = 1.39033110312309984516e-17;
    x = (x - 1.5) / (1 + 1.5 * x);
  } else {
    x = -1 / x;
  }
  return high - ((-ArcTangentPolynomial(x) - low) - x);
}

}  // namespace

SineCosine SineAndCosine(double angle) {
  const double quarters = std::floor(angle * (1 / kHalfPi) + 0.5);
  double high = angle - quarters * kHalfPi1;
  const double middle = quarters * kHalfPi2;
  const double reduced = high - middle;
  const double low = quarters * kHalfPi3 - ((high - reduced) - middle);
  high = reduced - low;
  const double tail = (reduced - high) - low;
  const double sine = SinePolynomial(high, tail);
  const double cosine = CosinePolynomial(high, tail);
  switch (static_cast<int64_t>(quarters) & 3) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

double AngleOf(double y, double x) {
  if (y == 0) return x < 0 ? kPi : 0;
  if (x == 0) return y < 0 ? -kHalfPi : kHalfPi;
  const double angle = ArcTangent(std::fabs(y / x));
  const double upper = x > 0 ? angle : kPi - (angle - kPiLow);
  return y < 0 ? -upper : upper;
}

}  // namespace oncard::motion
