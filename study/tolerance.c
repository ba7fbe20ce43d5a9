/* Tolerances of the points' heat. A factor on the scenario's own saves most of an integration; what
 * it costs in accuracy is measured, not guessed: at the upper ends of all ranges a point is
 * computed both ways. What they do to the scenario as it stands is taken off every point (point.c),
 * so that little is left of it. */
#include <math.h>

#include "study/study_impl.h"

/* Of the asked error that tolerances may use up at the place where they are measured. A surrogate
 * takes what is left of them from point to point for structure, and wants more points for it than
 * tighter tolerances cost; its held-out points then agree within half of the asked error. */
#define SHARE           0.5
#define SHARE_SURROGATE 0.3

/* Of what is taken off a point, left elsewhere than where it is measured. */
#define SHARE_LEFT 0.2

/* Looser ones do not pay: steps of an integration are then as long as loads are smooth over. */
static const struct um_variant_tolerance choices[] = {{12.0, 0.05},
                                                      {6.0, 0.02},
                                                      {3.0, UM_MODEL_PERIODIC_TOLERANCE},
                                                      {1.0, UM_MODEL_PERIODIC_TOLERANCE}};
#define CHOICES (sizeof choices / sizeof choices[0])

/* Upper ends of all that leaves the geometry as it is. *n 0: there is none. */
static enum um_status corner_open(struct um_context *context, const struct um_study *study,
                                  struct um_variant *out)
{
  enum um_status status;
  struct um_study_way *way = NULL;
  double *value = NULL, least;
  size_t n = 0;
  UM_CHECK(um_core_allocate(context, study->nway, sizeof *way, &way));
  UM_CHECK(um_core_allocate(context, study->nway, sizeof *value, &value));
  for (size_t i = 0; i < study->nway; i++) {
    if (study->moves_geometry[i]) continue;
    way[n] = study->way[i];
    um_uncertainty_distribution_ends(&way[n].distribution, &least, &value[n]);
    n++;
  }
  UM_CHECK(um_study_open(context, study, way, n, value, out));
done:
  um_core_free(context, way);
  um_core_free(context, value);
  return status;
}

/* Does anything need heat of its own? */
static bool any_heat(const struct um_study *study)
{
  for (size_t i = 0; i < study->nway; i++)
    if (study->moves_heat[i]) return true;
  return false;
}

static bool good_enough(const struct um_study *study)
{
  double share = study->file->mode == UM_STUDY_SURROGATE ? SHARE_SURROGATE : SHARE;
  for (size_t q = 0; q < study->noutput; q++)
    if (!(study->measured[q] <= share * um_study_asked(study, q))) return false;
  return true;
}

/* What the tolerances chosen leave of a variant whose values with the scenario's own are
 * own[nvalue]; value [nvalue] is scratch. */
static enum um_status measure(struct um_context *context, struct um_study *study,
                              struct um_variant *variant, const double *own, double *value)
{
  UM_TRY(um_study_looseness(context, study));
  UM_TRY(um_study_values(context, study, variant, false, value));
  um_study_differences(study, value, own, study->measured);
  for (size_t q = 0; q < study->noutput; q++)
    study->measured[q] += SHARE_LEFT * study->taken_off[q];
  return UM_OK;
}

enum um_status um_study_tolerance(struct um_context *context, struct um_study *study)
{
  enum um_status status = UM_OK;
  struct um_variant corner = {0};
  double *value = NULL, *own;
  study->tolerance = choices[0];
  if (!any_heat(study)) return UM_OK;
  UM_CHECK(um_core_allocate(context, 2 * study->nvalue, sizeof *value, &value));
  own = value + study->nvalue;
  UM_CHECK(corner_open(context, study, &corner));
  /* what two parameters do together may need another geometry though neither does alone */
  if (corner.precomputed != study->base.precomputed) {
    study->tolerance = choices[CHOICES - 1];
    goto done;
  }
  UM_CHECK(um_study_values(context, study, &corner, true, own));
  for (size_t i = 0; i < CHOICES; i++) {
    study->tolerance = choices[i];
    status = measure(context, study, &corner, own, value);
    if (status == UM_ERR_NUMERIC && i + 1 < CHOICES) { /* too loose to find a state that repeats */
      um_core_message_clear(context);
      continue;
    }
    UM_CHECK(status);
    if (good_enough(study)) break;
  }
done:
  um_variant_close(context, &corner);
  um_core_free(context, value);
  return status;
}
