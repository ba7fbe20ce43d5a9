/* The place and the width of a bump or an edge, and the length of a fall, which the search took
 * from a grid: steps that are halved where none is better. */
#include "evidence/missing_light/search_impl.h"

#include <math.h>

#include "evidence/missing_light/policy.h"

#define STEPS 40 /* HAND: a place to a thousandth of its range */

void um_missing_light_refine(struct um_missing_light_search *s, struct um_missing_light_attempt *a)
{
  double from, to;
  bool falls = a->curve.kind == UM_CURVE_FALL;
  if (a->curve.kind != UM_CURVE_BUMP && a->curve.kind != UM_CURVE_EDGE && !falls) return;
  if (!um_missing_light_range(s->o, a->coordinate, &from, &to)) return;
  double place = (to - from) / UM_MISSING_LIGHT_PLACES, ratio = 1.4;
  for (int i = 0; i < STEPS; i++) {
    bool better = false;
    for (int k = falls ? 2 : 0; k < 4; k++) {
      struct um_missing_light_attempt other = *a;
      if (k < 2) other.curve.a += k == 0 ? place : -place;
      if (k >= 2) other.curve.b *= k == 2 ? ratio : 1.0 / ratio;
      if (fabs(other.curve.b) > (falls ? 1.0 : UM_MISSING_LIGHT_WIDEST) * (to - from)) continue;
      if (fabs(other.curve.b) < 1e-3 * (to - from)) continue;
      if (other.curve.a < from || other.curve.a > to) continue;
      um_missing_light_fit(s, &other);
      if (!(other.chi2 > a->chi2)) continue;
      *a = other;
      better = true;
    }
    if (better) continue;
    place *= 0.5;
    ratio = sqrt(ratio);
  }
}
