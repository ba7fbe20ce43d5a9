/* How far two explanations are apart in a band or place, against the noise of a measurement.
 * Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_APART_IMPL_H
#define UMBRA_DIAGNOSIS_APART_IMPL_H

#include "evidence/sensitivity/forward.h"

/* Relative sigma of a band's observations, or sigma of a place's [K], of the measurement alone; a
 * usual one where none was measured. */
double um_diagnosis_sigma_of(const struct um_sensitivity_forward *forward, bool temperature,
                             const char *of);
/* Time from one value of a band or place to the next, median of those measured; the scenario's
 * time.step_s where fewer than two were [s]. Errors: UM_ERR_MEMORY. */
enum um_status um_diagnosis_cadence_of(struct um_context *context,
                                       const struct um_sensitivity_forward *forward,
                                       bool temperature, const char *of, double *out);

/* Noise of a band in a run. */
struct um_diagnosis_band_noise {
  double relative; /* [1] */
  double floor;    /* [W/m^2] */
};
struct um_diagnosis_band_noise
um_diagnosis_noise_of_band(const struct um_sensitivity_forward *forward,
                           const struct um_model_result *result, size_t band, const char *name);
/* Expected chi-square between two runs by one value of a band at observation k; NaN where one has
 * none. *sigma: of the value [W/m^2]. */
double um_diagnosis_apart(const struct um_diagnosis_band_noise *noise,
                          const struct um_model_result *a, const struct um_model_result *b,
                          size_t band, size_t k, double *sigma);

#endif
