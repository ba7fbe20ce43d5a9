/* Two threads take half of the tens of microseconds that one takes for a product, where they have
 * cores of their own; where other programs keep a core, they wait for each other a hundred times as
 * long. So both are tried, TRIAL products each, and what was faster is kept for a while, longer
 * each time that one thread was; a product far slower than it should be ends the threads at once.
 */
#include "thermal/exchange/thread_tuning_group.h"

#include <omp.h>

#include "thermal/exchange/exchange_group.h"

#define TRIAL      8
#define FIRST_HOLD 256u   /* products until the next trial */
#define LAST_HOLD  65536u /* the most of them */
#define LATE       8.0    /* times what one thread takes */
#define WORTH      16384  /* entries: fewer take less time than threads need to meet */

static void settle(struct um_thermal_thread_tuning *tuning, bool together)
{
  tuning->together = together;
  tuning->trial = 0;
  tuning->left = tuning->hold;
  if (!together && tuning->hold < LAST_HOLD) tuning->hold *= 2;
}

void um_thermal_thread_tuning_apply(struct um_thermal_thread_tuning *tuning,
                                    const struct um_thermal_exchange *exchange,
                                    const struct um_thermal_between *between,
                                    const struct um_thermal_mix *mix, const double *x, double *heat)
{
  size_t nentry = 0;
  for (size_t k = 0; k < mix->n; k++) nentry += between[mix->pose[k]].begin[exchange->noutside];
  if (tuning->threads < 2 || nentry < WORTH || omp_in_parallel()) {
    um_thermal_exchange_apply(exchange, between, mix, 1, x, heat);
    return;
  }
  bool trying = tuning->left == 0;
  bool together = trying ? tuning->trial >= TRIAL : tuning->together;
  double began = omp_get_wtime();
  um_thermal_exchange_apply(exchange, between, mix, together ? tuning->threads : 1, x, heat);
  double each = (omp_get_wtime() - began) / (double)nentry; /* products differ in size */
  if (!trying) {
    tuning->left--;
    if (together && each > LATE * tuning->alone) settle(tuning, false);
    return;
  }
  if (tuning->hold == 0) tuning->hold = FIRST_HOLD;
  if (tuning->trial == 0) tuning->alone = tuning->shared = 0.0;
  *(together ? &tuning->shared : &tuning->alone) += each / TRIAL;
  tuning->trial++;
  if (tuning->shared > LATE * tuning->alone)
    settle(tuning, false);
  else if (tuning->trial == 2 * TRIAL)
    settle(tuning, tuning->shared < tuning->alone);
}
