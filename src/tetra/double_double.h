// Numbers of about 106 bits as unevaluated sums of two doubles (Dekker, "A floating-point technique
// for extending the available precision", 1971). For the few places where a sliver cancels all 53.
#pragma once

#include <cmath>

namespace arris {

// hi + lo, |lo| at most half a unit in the last place of hi.
struct DoubleDouble {
  double hi = 0, lo = 0;

  // a + b without rounding (Knuth).
  static DoubleDouble sum(double a, double b) {
    const double s = a + b, part = s - a;
    return {s, (a - (s - part)) + (b - part)};
  }
  // The same for |a| >= |b|.
  static DoubleDouble quick_sum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }

  friend DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble s = sum(a.hi, b.hi), t = sum(a.lo, b.lo);
    const DoubleDouble u = quick_sum(s.hi, s.lo + t.hi);
    return quick_sum(u.hi, u.lo + t.lo);
  }
  friend DoubleDouble operator-(DoubleDouble a) { return {-a.hi, -a.lo}; }
  friend DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }
  friend DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const double p = a.hi * b.hi, rest = std::fma(a.hi, b.hi, -p);
    return quick_sum(p, rest + (a.hi * b.lo + a.lo * b.hi));
  }
};

}  // namespace arris
