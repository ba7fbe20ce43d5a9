/* Coordinates along which a discrepancy is correlated, in lengths over which it is alike:
 *
 *   time     t / scale, scales from 15 s by fours up to the span
 *   orbit    angle from the Sun's noon in the plane of the orbit, on a circle
 *   aspect   directions to Sun and observer in axes of the body, on two spheres */
#include "evidence/diagnosis/discrepancy_impl.h"

#include <math.h>

#include "evidence/diagnosis/policy.h"

static const struct um_environment_sample *sample_of(const struct um_sensitivity_forward *f,
                                                     size_t j)
{
  const struct um_model_tables *tables = f->base.tables;
  size_t k = f->plan->observation[f->observations.row[j]];
  return &tables->sample[k * tables->nsub + tables->nsub / 2];
}

static enum um_status add(struct um_context *context, const char *name, size_t ndimension,
                          const double *z, struct um_diagnosis_discrepancy *out)
{
  struct um_inference_correlation **to = &out->kind[out->family.nkind];
  UM_TRY(um_inference_correlation_create(context, name, out->family.nobservation,
                                         out->family.channel, out->family.nchannel, ndimension, z,
                                         to));
  if (*to != NULL) out->family.nkind++; /* too short a scale is noise */
  return UM_OK;
}

/* Time over scales; z: [nobservation]. */
static enum um_status add_time(struct um_context *context, const struct um_sensitivity_forward *f,
                               double *z, struct um_diagnosis_discrepancy *out)
{
  static const struct {
    double scale; /* [s] */
    const char *name;
  } scales[] = {{15.0, "time over 15 s"},       {60.0, "time over a minute"},
                {240.0, "time over 4 minutes"}, {960.0, "time over a quarter of an hour"},
                {3840.0, "time over an hour"},  {15360.0, "time over 4 hours"},
                {61440.0, "time over 17 hours"}};
  const double *t = f->observations.t;
  double first = INFINITY, last = -INFINITY;
  for (size_t j = 0; j < f->observations.count; j++) {
    first = fmin(first, t[j]);
    last = fmax(last, t[j]);
  }
  for (size_t i = 0; i < sizeof scales / sizeof *scales; i++) {
    if (i > 0 && scales[i].scale > last - first) break;
    for (size_t j = 0; j < f->observations.count; j++) z[j] = (t[j] - first) / scales[i].scale;
    UM_TRY(add(context, scales[i].name, 1, z, out));
  }
  return UM_OK;
}

static void put(struct um_vec3 v, double length, double z[3])
{
  z[0] = v.x / length;
  z[1] = v.y / length;
  z[2] = v.z / length;
}

/* z: [nobservation][6] */
static enum um_status add_places(struct um_context *context, const struct um_sensitivity_forward *f,
                                 double *z, struct um_diagnosis_discrepancy *out)
{
  size_t n = f->observations.count;
  for (size_t j = 0; j < n; j++) {
    const struct um_environment_sample *s = sample_of(f, j);
    struct um_vec3 normal = um_vec3_unit(um_vec3_cross(s->r, s->v));
    struct um_vec3 noon =
        um_vec3_unit(um_vec3_sub(s->sun, um_vec3_scale(normal, um_vec3_dot(s->sun, normal))));
    double angle = atan2(um_vec3_dot(s->r, um_vec3_cross(normal, noon)), um_vec3_dot(s->r, noon));
    z[2 * j] = cos(angle) / UM_DIAGNOSIS_ALIKE_IN_ORBIT;
    z[2 * j + 1] = sin(angle) / UM_DIAGNOSIS_ALIKE_IN_ORBIT;
  }
  UM_TRY(add(context, "the phase of the orbit", 2, z, out));
  for (size_t j = 0; j < n; j++) {
    const struct um_environment_sample *s = sample_of(f, j);
    put(um_quat_apply(s->q, s->sun), UM_DIAGNOSIS_ALIKE_IN_ASPECT, z + 6 * j);
    put(um_quat_apply(s->q, s->to_observer), UM_DIAGNOSIS_ALIKE_IN_ASPECT, z + 6 * j + 3);
  }
  return add(context, "the aspect of the body", 6, z, out);
}

/* Half of what is too large to be one (policy.h), in sigma: of temperatures in kelvin, of light as
 * a share of it, and of sigma at least. out: [nchannel] */
static void find_usual(const struct um_sensitivity_forward *f, double *out)
{
  const struct um_sensitivity_observations *o = &f->observations;
  for (size_t c = 0; c < f->measurements->nchannel; c++) {
    bool heat = f->measurements->channel[c].quantity == UM_QUANTITY_TEMPERATURE;
    double sum = 0.0, n = 0.0;
    for (size_t j = 0; j < o->count; j++) {
      if (o->channel[j] != c) continue;
      double most =
          heat ? UM_DIAGNOSIS_LARGE_TEMPERATURE : UM_DIAGNOSIS_LARGE_LIGHT * fabs(o->measured[j]);
      sum += pow(most / o->sigma[j], 2);
      n += 1.0;
    }
    out[c] = 0.5 * fmax(UM_DIAGNOSIS_LARGE_SIGMAS, n > 0.0 ? sqrt(sum / n) : 0.0);
  }
}

enum um_status um_diagnosis_discrepancy_create(struct um_context *context,
                                               const struct um_sensitivity_forward *forward,
                                               struct um_diagnosis_discrepancy *out)
{
  enum um_status status;
  double *z = NULL;
  *out = (struct um_diagnosis_discrepancy){.family = {.nobservation = forward->observations.count,
                                                      .nchannel = forward->measurements->nchannel,
                                                      .channel = forward->observations.channel}};
  out->family.kind = out->kind;
  UM_CHECK(um_core_allocate(context, out->family.nchannel, sizeof *out->usual, &out->usual));
  find_usual(forward, out->usual);
  out->family.usual = out->usual;
  UM_CHECK(um_core_allocate(context, 6 * forward->observations.count, sizeof *z, &z));
  UM_CHECK(add_time(context, forward, z, out));
  UM_CHECK(add_places(context, forward, z, out));
done:
  um_core_free(context, z);
  if (status != UM_OK) um_diagnosis_discrepancy_release(context, out);
  return status;
}

void um_diagnosis_discrepancy_release(struct um_context *context,
                                      struct um_diagnosis_discrepancy *discrepancy)
{
  for (size_t i = 0; i < UM_DIAGNOSIS_KINDS_MAX; i++)
    um_inference_correlation_destroy(context, &discrepancy->kind[i]);
  um_core_free(context, discrepancy->usual);
  *discrepancy = (struct um_diagnosis_discrepancy){0};
}
