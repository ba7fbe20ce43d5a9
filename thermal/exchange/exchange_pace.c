/* Two threads take half of the tens of microseconds that one takes for a product, where they have
 * cores of their own; where other programs keep a core, they wait for each other a hundred times as
 * long. So both are tried, TRIAL products each, and what was faster is kept for a while, longer
 * each time that one thread was; a product far slower than it should be ends the threads at once.
 */
#include "thermal/exchange/exchange_pace_group.h"

#include <omp.h>

#include "thermal/exchange/exchange_group.h"

#define TRIAL      8
#define FIRST_HOLD 256u   /* products until the next trial */
#define LAST_HOLD  65536u /* the most of them */
#define LATE       8.0    /* times what one thread takes */
#define WORTH      16384  /* entries: fewer take less time than threads need to meet */

static void settle(struct um_thermal_pace *pace, bool together)
{
  pace->together = together;
  pace->trial = 0;
  pace->left = pace->hold;
  if (!together && pace->hold < LAST_HOLD) pace->hold *= 2;
}

void um_thermal_pace_apply(struct um_thermal_pace *pace, const struct um_thermal_exchange *exchange,
                           const struct um_thermal_between *between,
                           const struct um_thermal_mix *mix, const double *x, double *heat)
{
  size_t nentry = 0;
  for (size_t k = 0; k < mix->n; k++) nentry += between[mix->pose[k]].begin[exchange->noutside];
  if (pace->threads < 2 || nentry < WORTH || omp_in_parallel()) {
    um_thermal_exchange_apply(exchange, between, mix, 1, x, heat);
    return;
  }
  bool trying = pace->left == 0;
  bool together = trying ? pace->trial >= TRIAL : pace->together;
  double began = omp_get_wtime();
  um_thermal_exchange_apply(exchange, between, mix, together ? pace->threads : 1, x, heat);
  double each = (omp_get_wtime() - began) / (double)nentry; /* products differ in size */
  if (!trying) {
    pace->left--;
    if (together && each > LATE * pace->alone) settle(pace, false);
    return;
  }
  if (pace->hold == 0) pace->hold = FIRST_HOLD;
  if (pace->trial == 0) pace->alone = pace->shared = 0.0;
  *(together ? &pace->shared : &pace->alone) += each / TRIAL;
  pace->trial++;
  if (pace->shared > LATE * pace->alone)
    settle(pace, false);
  else if (pace->trial == 2 * TRIAL)
    settle(pace, pace->shared < pace->alone);
}
