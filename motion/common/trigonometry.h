// Sine, cosine and the angle of a vector, the same bits on every machine: only basic arithmetic,
// no library functions.
//
// Polynomials and the split of pi/2 are those of fdlibm, whose error stays below 1 ulp.
// Tested by tests/motion/trigonometry_test.cc.
#pragma once

namespace oncard::motion {

inline constexpr double kPi = 3.14159265358979323846;

struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

/// Of an angle in radians, |angle| <= 1000; error at most 2 ulp.
SineCosine SineAndCosine(double angle);

/// The angle of (x, y) in (-pi, pi], radians; 0 for (0, 0). Error at most 2 ulp.
double AngleOf(double y, double x);

}  // namespace oncard::motion
