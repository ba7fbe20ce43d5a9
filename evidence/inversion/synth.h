/* Measurements made from a model: what it says, with Gaussian noise in linear flux. */
#ifndef UMBRA_COMPARE_SYNTH_H
#define UMBRA_COMPARE_SYNTH_H

#include <stdint.h>

#include "evidence/inversion/refine.h"
#include "model/build/model.h"

struct um_compare_synth {
  double relative; /* of the truth [1], >= 0 */
  double floor;    /* of the band's largest truth [1], >= 0; not both 0 */
  uint64_t seed;
  const char *const *place; /* [nplace] whose temperatures are measured too; names as in
                               um_compare_plan_create; NULL when nplace is 0 */
  size_t nplace;
  bool grey_body; /* characteristic temperature and infrared cross-section are measured too */
  double temperature_sigma; /* [K] > 0 when nplace > 0 */
};

/* What can be said of the options before anything is computed. UM_ERR_INPUT as below. */
enum um_status um_compare_synth_check(struct um_context *context, const struct um_model *model,
                                      const struct um_compare_synth *options);

/* At every observation of the geometry tables, for every band above the horizon,
 *   value = E + sigma g,  sigma^2 = (relative E)^2 + (floor max E)^2,  g unit normal,
 * the count rate of every sensor likewise, and the temperature of every place with
 * temperature_sigma; with grey_body characteristic temperature and infrared cross-section, with the
 * sigma that bands with that noise give them (um_model_grey_body_error), drawn apart though those
 * of one fit are correlated. Sigma is of the truth, as the noise is. Each channel draws from a
 * generator of its own (Mersenne twister, Matsumoto & Nishimura 1998; ziggurat, Marsaglia & Tsang
 * 2000) that depends on the seed and the channel alone: the same seed gives the same noise whatever
 * else is measured. exposure_s is written where the scenario has one.
 *
 * path: what the set is called in messages. UM_ERR_INPUT: noise out of range, a sigma of 0, an
 * unknown place, grey_body with fewer than three thermal bands, or nothing to measure (no observer
 * or never above the horizon, and no places). UM_ERR_MEMORY. The caller destroys. */
enum um_status um_compare_synth_create(struct um_context *context, const struct um_model *model,
                                       const struct um_model_tables *tables,
                                       const struct um_model_result *result,
                                       const struct um_compare_synth *options, const char *path,
                                       struct um_compare_measurements **out);

/* All of it: the model of a scenario with changes (NULL: none), run with as many samples as leave
 * the noise what it is stated to be, and measured. Errors as above, and those of um_model_create,
 * um_model_precompute and um_compare_refine. The caller destroys. */
enum um_status um_compare_synth_run(struct um_context *context, const char *scenario,
                                    const struct um_model_options *changes,
                                    const struct um_compare_synth *options, const char *path,
                                    struct um_compare_measurements **out);

/* um_compare_share_of for um_compare_refine: the model's own sampling error beside the noise that
 * is to be added, which alone is stated as sigma; user: the options. */
um_compare_share_of um_compare_synth_share;

#endif
