/* Cases of heat: variants of a scenario held against limits of temperature. */
#ifndef UMBRA_VARIANT_CASES_H
#define UMBRA_VARIANT_CASES_H

#include "model/build/model.h"

/* How the temperatures of a case are found. */
enum um_variant_analysis {
  UM_ANALYSIS_TRANSIENT,  /* extremes over the instants of the scenario */
  UM_ANALYSIS_ORBIT_MEAN, /* balance under the mean heat of an orbit */
  UM_ANALYSIS_STEADY      /* balance under the heat of the first observation */
};
const char *um_variant_analysis_name(enum um_variant_analysis analysis);

/* A place in a case [K]. Bounds and margins are NaN where there is none; uncertainty: of what is
 * computed, NaN without a limit; margins: lowest - uncertainty - minimum and maximum - uncertainty
 * - highest. */
struct um_variant_case_place {
  char *name;
  double mean, lowest, highest; /* over nodes and instants; mean by area, or by capacity inside */
  double minimum, maximum, uncertainty;
  double margin_low, margin_high;
};
struct um_variant_case {
  char *name;
  enum um_variant_analysis analysis;
  struct um_variant_case_place *place; /* [nplace] */
  size_t nplace;
};
struct um_variant_cases {
  char *scenario; /* its name */
  struct um_variant_case *item;
  size_t count;
};

/* Compute every case of a scenario, "nominal" where it names none. Changes of the options go before
 * those of a case. UM_ERR_INPUT with the line of the case whose changes are refused. The caller
 * destroys. */
enum um_status um_variant_cases_create(struct um_context *context, const char *path,
                                       const struct um_model_options *options,
                                       struct um_variant_cases **out);
void um_variant_cases_destroy(struct um_context *context, struct um_variant_cases **cases);

/* Least of the two margins [K]; NaN where there is no limit. */
static inline double um_variant_case_margin(const struct um_variant_case_place *place)
{
  double low = place->margin_low, high = place->margin_high;
  return low < high || high != high ? low : high;
}

/* Is a limit exceeded, its uncertainty counted against the margin? The rule of table, JSON, picture
 * and exit status. */
static inline bool um_variant_case_exceeded(const struct um_variant_case_place *place)
{
  return um_variant_case_margin(place) < 0.0;
}

#endif
