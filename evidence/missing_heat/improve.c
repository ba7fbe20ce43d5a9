/* What is known of the courses of heat, by sampling. The posterior of a course, with the power
 * taken out and flat in its energy, is
 *
 *   p(course) ~ exp(chi2 / 2 scale) L sigma_P,   L the energy at 1 W,
 *
 * and is sampled by an ensemble of walkers that stretch towards and away from one another (Goodman
 * & Weare 2010, Comm. App. Math. Comp. Sci. 5:65). The same walkers that only take what improves
 * chi-square end at its maximum. Shapes are weighed by BIC,
 *
 *   BIC = -chi2 / scale + k ln n  (Schwarz 1978),   weight ~ exp(-BIC / 2),
 *
 * and start and energy scatter over all shapes about those of the best. Where what is left is more
 * than noise, scale is its reduced chi-square. */
#include <math.h>
#include <string.h>

#include "base/core/sampling.h"
#include "evidence/missing_heat/fit_impl.h"
#include "evidence/missing_heat/policy.h"

struct walker {
  double x[UM_MISSING_HEAT_NUMBERS];
  struct um_thermal_course course;
  struct um_missing_heat_weighed weighed;
  double log; /* of the posterior */
};

struct ensemble {
  const struct um_missing_heat_bins *bins;
  enum um_thermal_course_shape shape;
  size_t n; /* numbers */
  double scale;
  uint64_t drawn;
  struct walker walker[UM_MISSING_HEAT_WALKERS], best;
};

/* Sums over samples of what is away from a reference. */
struct moments {
  double count, start[2], last[2], period[2], energy[2], spread;
};

static double draw(struct ensemble *e)
{
  return um_core_hash_uniform(um_core_hash((uint64_t)e->shape, e->drawn++));
}

static bool weigh(const struct ensemble *e, struct walker *w)
{
  w->course = um_missing_heat_course_of(e->shape, w->x);
  if (!um_missing_heat_course_allowed(e->bins, &w->course)) return false;
  w->weighed = um_missing_heat_bins_weigh(e->bins, &w->course);
  w->log = 0.5 * w->weighed.chi2 / e->scale + log(w->weighed.length * w->weighed.sigma);
  return w->weighed.chi2 > 0.0 && isfinite(w->log);
}

/* Walkers about a course, within an interval or two of the search. False: it explains nothing. */
static bool begin(struct ensemble *e, const struct um_thermal_course *course)
{
  double interval =
      (e->bins->edge[e->bins->nbin] - e->bins->edge[0]) / (double)UM_MISSING_HEAT_BINS_MAX;
  const double width[UM_MISSING_HEAT_NUMBERS] = {interval,
                                                 e->shape == UM_HEAT_PULSE ? interval : 0.1, 0.02};
  um_missing_heat_numbers_of(course, e->best.x);
  if (!weigh(e, &e->best)) return false;
  for (size_t i = 0; i < UM_MISSING_HEAT_WALKERS; i++) {
    struct walker *w = &e->walker[i];
    bool put = false;
    for (double within = 1.0; !put && within > 1e-3; within *= 0.7) {
      for (size_t k = 0; k < e->n; k++)
        w->x[k] = e->best.x[k] + within * width[k] * (2.0 * draw(e) - 1.0);
      put = weigh(e, w);
    }
    if (!put) *w = e->best;
  }
  return true;
}

/* A walker towards or away from another. */
static void stretch(struct ensemble *e, size_t at, bool only_better)
{
  size_t other = (size_t)(draw(e) * (UM_MISSING_HEAT_WALKERS - 1));
  struct walker *w = &e->walker[at], next;
  double u = draw(e) + 1.0, z = 0.5 * u * u; /* from 1/2 to 2 */
  if (other >= at) other++;
  for (size_t k = 0; k < e->n; k++)
    next.x[k] = e->walker[other].x[k] + z * (w->x[k] - e->walker[other].x[k]);
  double level = log(draw(e));
  if (!weigh(e, &next)) return;
  if (next.weighed.chi2 > e->best.weighed.chi2) e->best = next;
  bool taken = only_better ? next.weighed.chi2 > w->weighed.chi2
                           : level < ((double)e->n - 1.0) * log(z) + next.log - w->log;
  if (taken) *w = next;
}

static void step(struct ensemble *e, bool only_better)
{
  for (size_t i = 0; i < UM_MISSING_HEAT_WALKERS; i++) stretch(e, i, only_better);
}

/* Walkers that were left in a worse valley join others. */
static void gather(struct ensemble *e)
{
  for (size_t i = 0; i < UM_MISSING_HEAT_WALKERS; i++) {
    struct walker *w = &e->walker[i];
    const struct walker *other = &e->best;
    if (e->best.weighed.chi2 - w->weighed.chi2 < UM_MISSING_HEAT_ASTRAY * e->scale) continue;
    for (int k = 0; k < 20; k++) {
      other = &e->walker[(size_t)(draw(e) * UM_MISSING_HEAT_WALKERS)];
      if (e->best.weighed.chi2 - other->weighed.chi2 < UM_MISSING_HEAT_ASTRAY * e->scale) break;
      other = &e->best;
    }
    *w = *other;
  }
}

static void add(double off, double sums[2])
{
  sums[0] += off;
  sums[1] += off * off;
}

static void take(const struct ensemble *e, const struct walker *about, struct moments *m)
{
  double energy = about->weighed.power * about->weighed.length;
  for (size_t i = 0; i < UM_MISSING_HEAT_WALKERS; i++) {
    const struct walker *w = &e->walker[i];
    double sigma = w->weighed.sigma * w->weighed.length;
    m->count += 1.0;
    add(w->course.start - about->course.start, m->start);
    add(w->course.last - about->course.last, m->last);
    add(w->course.period - about->course.period, m->period);
    add(w->weighed.power * w->weighed.length - energy, m->energy);
    m->spread += sigma * sigma * e->scale;
  }
}

/* Root of the mean square about `off` from the reference. */
static double about(const double sums[2], double count, double off)
{
  return sqrt(fmax(0.0, sums[1] / count - 2.0 * off * sums[0] / count + off * off));
}

static void improve(struct ensemble *e, struct um_missing_heat_fit *fit)
{
  struct moments m = {0};
  if (!begin(e, &fit->course)) return;
  for (int k = 0; k < UM_MISSING_HEAT_SETTLING; k++) {
    step(e, false);
    if (k % 50 == 49) gather(e);
  }
  struct walker reference = e->best;
  for (int k = 0; k < UM_MISSING_HEAT_SAMPLES; k++) {
    step(e, false);
    take(e, &reference, &m);
  }
  for (int k = 0; k < UM_MISSING_HEAT_CLIMB; k++) step(e, true);
  const struct um_thermal_course *b = &e->best.course, *r = &reference.course;
  fit->course = *b;
  fit->chi2 = e->best.weighed.chi2;
  fit->power = e->best.weighed.power;
  fit->energy = fit->power * e->best.weighed.length;
  fit->start_sigma = about(m.start, m.count, b->start - r->start);
  fit->last_sigma = e->n > 1 ? about(m.last, m.count, b->last - r->last) : NAN;
  fit->period_sigma = e->n > 2 ? about(m.period, m.count, b->period - r->period) : NAN;
  fit->energy_sigma = hypot(
      about(m.energy, m.count, fit->energy - reference.weighed.power * reference.weighed.length),
      sqrt(m.spread / m.count));
}

/* The best shape, and what the others add to its sigmas. */
static void choose(const struct um_missing_heat_bins *bins, struct um_missing_heat_choice *c)
{
  double sum = 0.0, start2 = 0.0, energy2 = 0.0;
  c->shape = UM_HEAT_STEP;
  for (int s = 0; s < UM_HEAT_SHAPES; s++) {
    double k = (double)um_thermal_course_parameters((enum um_thermal_course_shape)s);
    c->of[s].bic = -c->of[s].chi2 / c->scale + k * log((double)bins->nobservation);
    if (c->of[s].bic < c->of[c->shape].bic) c->shape = (enum um_thermal_course_shape)s;
  }
  const struct um_missing_heat_fit *best = &c->of[c->shape];
  for (int s = 0; s < UM_HEAT_SHAPES; s++) {
    const struct um_missing_heat_fit *f = &c->of[s];
    double weight = exp(-0.5 * (f->bic - best->bic));
    double late = f->course.start - best->course.start, more = f->energy - best->energy;
    if (!(f->chi2 > 0.0)) continue;
    sum += weight;
    start2 += weight * (f->start_sigma * f->start_sigma + late * late);
    energy2 += weight * (f->energy_sigma * f->energy_sigma + more * more);
  }
  c->start_sigma = sqrt(start2 / sum);
  c->energy_sigma = sqrt(energy2 / sum);
}

void um_missing_heat_improve(const struct um_missing_heat_bins *bins,
                             struct um_missing_heat_choice *choice)
{
  double most = 0.0;
  for (int s = 0; s < UM_HEAT_SHAPES; s++) {
    struct um_missing_heat_weighed w = um_missing_heat_bins_weigh(bins, &choice->of[s].course);
    most = fmax(most, w.chi2);
  }
  double dof = fmax(1.0, (double)bins->nleft - UM_MISSING_HEAT_NUMBERS);
  choice->scale = fmax(1.0, (bins->square - most) / dof);
  for (int s = 0; s < UM_HEAT_SHAPES; s++) {
    struct ensemble e = {.bins = bins,
                         .shape = (enum um_thermal_course_shape)s,
                         .n = um_missing_heat_numbers((enum um_thermal_course_shape)s),
                         .scale = choice->scale};
    choice->of[s].chi2 = 0.0;
    improve(&e, &choice->of[s]);
  }
  choose(bins, choice);
}
