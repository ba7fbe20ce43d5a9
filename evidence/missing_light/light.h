/* A residual that no effect of the catalogue explains, as a correction of light: a smooth curve
 * along one coordinate that multiplies the light of a material, or of all, or is light of its own.
 */
#ifndef UMBRA_MISSING_LIGHT_LIGHT_H
#define UMBRA_MISSING_LIGHT_LIGHT_H

#include "effects/curve.h"
#include "effects/view.h"
#include "evidence/sensitivity/forward.h"

#define UM_MISSING_LIGHT_NUMBERS 8 /* of all bands together: parameters of an effect */

enum um_missing_light_kind {
  UM_LIGHT_FACTOR,     /* the light of the place times 1 + curve [1] */
  UM_LIGHT_INTENSITY,  /* light that the satellite sends, curve [W/sr] */
  UM_LIGHT_IRRADIANCE, /* light that is not the satellite's, curve [W/m^2] */
  UM_LIGHT_KINDS
};
/* "factor", "intensity", "irradiance" */
const char *um_missing_light_kind_name(enum um_missing_light_kind kind);
/* "phase_deg"; with its unit */
const char *um_missing_light_coordinate_name(enum um_effect_coordinate coordinate);

/* What could be in its place. */
struct um_missing_light_alternative {
  enum um_missing_light_kind kind;
  const char *material; /* NULL: all light; borrowed from the forward's model */
  enum um_effect_coordinate coordinate;
  double behind; /* BIC [1] */
};
#define UM_MISSING_LIGHT_ALTERNATIVES 6

struct um_missing_light {
  bool any; /* something was fitted: there is light, and a coordinate that varies */
  enum um_missing_light_kind kind;
  const char
      *material; /* whose light a factor is of; NULL: all; borrowed from the forward's model */
  enum um_effect_coordinate coordinate;
  struct um_effect_curve curve; /* a, b in the coordinate's unit; of time t_tai */
  double from, to;              /* of the coordinate where it was observed */
  size_t nband;
  const char *band[UM_MISSING_LIGHT_NUMBERS]; /* [nband] that it acts on; borrowed likewise */
  bool grey; /* all bands by the same curve: value [curve.n]; else [nband][curve.n] */
  double value[UM_MISSING_LIGHT_NUMBERS], sigma[UM_MISSING_LIGHT_NUMBERS];
  size_t nvalue;                  /* of them */
  size_t nparameter;              /* with what else was chosen, for BIC */
  double chi2_before, chi2_after; /* after the nuisances */
  double scale; /* reduced chi-square that is left, at least 1; sigma and BIC are by it */
  double worth; /* BIC that it is worth, by scale; above 0: better with it */
  size_t tried;
  /* it is worth UM_MISSING_LIGHT_EVIDENCE for all that were tried, and leaves little but noise */
  bool found;
  size_t nalternative;
  struct um_missing_light_alternative alternative[UM_MISSING_LIGHT_ALTERNATIVES];
};

/* Arguments as of um_missing_heat_unexplained_create; value and nuisance are those of the fit of
 * these additions. Light is linear in what is looked for, so all curves are tried by least squares
 * and no run is needed but that of the scenario with the additions. Errors of that run; where no
 * light was measured, or none of it varies, out->any is false. */
enum um_status um_missing_light_find(struct um_context *context,
                                     struct um_sensitivity_forward *forward,
                                     const struct um_model_addition *addition, size_t naddition,
                                     const double *value, const double *nuisance, size_t nnuisance,
                                     struct um_missing_light *out);

#define UM_MISSING_LIGHT_TEXT 480
/* "the light of white_paint in vis goes with the phase angle: from -0.20 +- 0.01 at 20 deg to ..."
 */
void um_missing_light_text(const struct um_missing_light *light, char out[UM_MISSING_LIGHT_TEXT]);

#endif
