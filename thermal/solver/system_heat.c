/* Heat made inside at an instant.
 *
 * Power histories: node i gets w_i P(t), P linear or constant between the rows around t, 0 outside.
 * Where P jumps the integration stops. A linear history whose rows are evenly spaced is met by
 * steps of at most two intervals, and where the spacing changes it stops too.
 *
 * Thermostats in a run: w_i P while on; the integrator finds the instants of switching. Cycling has
 * no steady state, and its orbit map jumps whenever a switching passes the orbit's end. So steady
 * and periodic systems take the mean power: with T_m the middle of the band and W a tenth of it,
 *
 *   P(T) = P / (1 + exp(4 (T - T_m) / W)),   dP/dT = -4/W P(T) (1 - P(T)/P),
 *
 * full well below the middle and nothing well above. A cycling node's mean temperature is the
 * middle of the band to second order in band over time constant, and its mean power what that
 * takes; a heater too weak is on all the time in both. */
#include <math.h>
#include <string.h>

#include "thermal/solver/system_group.h"

#define AT_ONCE       1e-6 /* [s] rows this near a stop are passed there */
#define UNEVEN        2.0  /* intervals whose ratio is larger are a change of spacing */
#define LARGEST_BLOCK 4096 /* entries that a thermostat adds to the Jacobian, or one column */

/* Which nodes of its sensor have the slope. Nodes that are heated together move together. */
static enum um_status slope_build(struct um_thermal_system *system,
                                  struct um_thermal_system_thermostat *own,
                                  const struct um_thermal_network_thermostat *t)
{
  double weight = 0.0;
  own->every = 1;
  if (system->kind == UM_SYSTEM_PERIODIC)
    while (own->every < t->sensor.n && t->at.n * (t->sensor.n / own->every) > LARGEST_BLOCK)
      own->every++;
  for (size_t j = 0; j < t->sensor.n; j += own->every) weight += t->sensor.weight[j];
  own->share = own->every > 1 && weight > 0.0 ? 1.0 / weight : 1.0;
  size_t sensed = (t->sensor.n + own->every - 1) / own->every;
  return um_core_allocate(system->context, t->at.n * sensed, sizeof(size_t), &own->slot);
}

enum um_status um_thermal_system_heat_build(struct um_thermal_system *system)
{
  struct um_context *context = system->context;
  const struct um_thermal_network *network = system->network;
  system->softness = 1.0;
  if (network->nsource + network->nthermostat == 0) return UM_OK;
  UM_TRY(um_core_allocate(context, system->n, sizeof(double), &system->made));
  UM_TRY(um_core_allocate(context, network->nsource, sizeof *system->source, &system->source));
  UM_TRY(um_core_allocate(context, network->nthermostat, sizeof *system->thermostat,
                          &system->thermostat));
  system->nsource = network->nsource;
  system->nthermostat = network->nthermostat;
  for (size_t k = 0; k < system->nsource; k++) {
    system->source[k].source = &network->source[k];
    system->source[k].high = network->source[k].nrow;
  }
  for (size_t k = 0; k < system->nthermostat; k++) {
    const struct um_thermal_network_thermostat *t = &network->thermostat[k];
    system->thermostat[k].thermostat = t;
    if (system->kind == UM_SYSTEM_RUN) continue;
    UM_TRY(slope_build(system, &system->thermostat[k], t));
  }
  return UM_OK;
}

void um_thermal_system_heat_destroy(struct um_thermal_system *system)
{
  for (size_t k = 0; k < system->nthermostat; k++)
    um_core_free(system->context, system->thermostat[k].slot);
  UM_FREE(system->context, system->thermostat, system->source, system->made);
}

/* t [s] from `from`: the difference of two late times keeps its digits. */
static double history_power(const struct um_thermal_network_source *source, size_t passed,
                            double from, double t)
{
  if (passed == 0 || passed == source->nrow) return 0.0;
  size_t k = passed - 1;
  if (source->stepwise) return source->power[k];
  double width = source->t[k + 1] - source->t[k];
  double u = width > 0.0 ? (t - (source->t[k] - from)) / width : 0.0;
  u = u < 0.0 ? 0.0 : u > 1.0 ? 1.0 : u;
  return (1.0 - u) * source->power[k] + u * source->power[k + 1];
}

double um_thermal_source_power(const struct um_thermal_network_source *source, double t)
{
  size_t passed = 0;
  while (passed < source->nrow && source->t[passed] <= t) passed++;
  return history_power(source, passed, 0.0, t);
}

void um_thermal_system_heat_window(struct um_thermal_system *system, double begin, double end)
{
  for (size_t k = 0; k < system->nsource; k++) {
    struct um_thermal_system_source *own = &system->source[k];
    const struct um_thermal_network_source *source = own->source;
    size_t low = 0;
    while (low < source->nrow && source->t[low] - system->from <= begin + AT_ONCE) low++;
    size_t high = low;
    while (high < source->nrow && source->t[high] - system->from < end - AT_ONCE) high++;
    own->low = own->passed = low;
    own->high = high;
  }
}

/* Is row k of a history one at which the integration stops? *spacing: interval of the even stretch
 * that is being passed. */
static bool is_stop(const struct um_thermal_network_source *source, size_t k, double *spacing)
{
  const double *t = source->t, *power = source->power;
  size_t last = source->nrow - 1;
  if (source->stepwise) {
    double before = k > 0 ? power[k - 1] : 0.0, after = k < last ? power[k] : 0.0;
    return before != after;
  }
  double next = k < last ? t[k + 1] - t[k] : 0.0;
  bool even = k > 0 && k < last && next <= UNEVEN * *spacing && next * UNEVEN >= *spacing;
  if (even) return false;
  *spacing = next;
  return true;
}

size_t um_thermal_system_heat_stops(const struct um_thermal_system *system, double *stop)
{
  size_t count = 0;
  for (size_t s = 0; s < system->nsource; s++) {
    const struct um_thermal_network_source *source = system->source[s].source;
    double spacing = 0.0;
    for (size_t k = 0; k < source->nrow; k++) {
      if (!is_stop(source, k, &spacing)) continue;
      if (stop != NULL) stop[count] = source->t[k] - system->from;
      count++;
    }
  }
  return count;
}

double um_thermal_system_heat_interval(const struct um_thermal_system *system)
{
  double shortest = INFINITY;
  for (size_t s = 0; s < system->nsource; s++) {
    const struct um_thermal_system_source *own = &system->source[s];
    const double *t = own->source->t;
    if (own->source->stepwise || own->high == own->low) continue; /* no row inside */
    for (size_t k = own->low; k <= own->high; k++)
      if (k > 0 && k < own->source->nrow && t[k] > t[k - 1])
        shortest = fmin(shortest, t[k] - t[k - 1]);
  }
  return shortest;
}

double um_thermal_thermostat_sensor(const struct um_thermal_network_thermostat *thermostat,
                                    const double *temperature)
{
  double sum = 0.0;
  for (size_t j = 0; j < thermostat->sensor.n; j++)
    sum += thermostat->sensor.weight[j] * temperature[thermostat->sensor.node[j]];
  return sum;
}

/* Mean power and its slope at the sensor's temperature t. */
static void mean_power(const struct um_thermal_system *system,
                       struct um_thermal_system_thermostat *own, double t)
{
  const struct um_thermal_network_thermostat *thermostat = own->thermostat;
  double width = UM_THERMAL_TRANSITION * system->softness * (thermostat->off - thermostat->on);
  double x = 4.0 * (t - 0.5 * (thermostat->on + thermostat->off)) / width;
  double share = 1.0 / (1.0 + exp(x)); /* exp overflows to a share of 0 */
  own->power = thermostat->power * share;
  own->slope = -4.0 / width * own->power * (1.0 - share);
}

static void spread_add(const struct um_thermal_spread *at, double power, double *made)
{
  for (size_t i = 0; i < at->n; i++) made[at->node[i]] += at->weight[i] * power;
}

void um_thermal_system_heat_make(struct um_thermal_system *system, double t)
{
  memset(system->made, 0, system->n * sizeof *system->made);
  for (size_t k = 0; k < system->nsource; k++) {
    struct um_thermal_system_source *own = &system->source[k];
    const double *row = own->source->t;
    size_t passed = own->passed;
    while (passed > own->low && t < row[passed - 1] - system->from) passed--;
    while (passed < own->high && t >= row[passed] - system->from) passed++;
    own->passed = passed;
    spread_add(&own->source->at, history_power(own->source, passed, system->from, t), system->made);
  }
  for (size_t k = 0; k < system->nthermostat; k++) {
    struct um_thermal_system_thermostat *own = &system->thermostat[k];
    if (system->kind == UM_SYSTEM_RUN)
      own->power = own->on ? own->thermostat->power : 0.0;
    else
      mean_power(system, own, um_thermal_thermostat_sensor(own->thermostat, system->temperature));
    spread_add(&own->thermostat->at, own->power, system->made);
  }
}

static bool begins_on(const struct um_thermal_network_thermostat *thermostat, double t)
{
  bool inside = t > thermostat->on && t < thermostat->off;
  if (inside && thermostat->start != UM_THERMOSTAT_BY_SENSOR)
    return thermostat->start == UM_THERMOSTAT_ON;
  return t < 0.5 * (thermostat->on + thermostat->off);
}

/* Half of a cycle goes up through the band, on, and half comes down. It has switched where it
 * stands at a threshold. A place above the band, in the sun, left its last cycle anywhere in it,
 * and floats lower by what it lacked then; a whole width above the band that is forgotten. */
static void phase_set(struct um_thermal_system *system, struct um_thermal_system_thermostat *own,
                      double t)
{
  const struct um_thermal_network_thermostat *thermostat = own->thermostat;
  double band = thermostat->off - thermostat->on, above = fmax(0.0, t - thermostat->off);
  double phase = thermostat->phase < 1.0 ? thermostat->phase : 0.0;
  double lacks = 1.0 - 2.0 * (phase < 0.5 ? phase : 1.0 - phase); /* of the band */
  double wanted = thermostat->off + above - band * lacks * fmax(0.0, 1.0 - above / band);
  own->on = phase < 0.5 && wanted < thermostat->off;
  for (size_t j = 0; j < thermostat->sensor.n; j++)
    if (thermostat->sensor.weight[j] > 0.0)
      system->temperature[thermostat->sensor.node[j]] += wanted - t;
}

void um_thermal_system_thermostats_set(struct um_thermal_system *system, bool start)
{
  for (size_t k = 0; k < system->nthermostat; k++) {
    struct um_thermal_system_thermostat *own = &system->thermostat[k];
    const struct um_thermal_network_thermostat *thermostat = own->thermostat;
    double t = um_thermal_thermostat_sensor(thermostat, system->temperature);
    if (start && system->kind == UM_SYSTEM_RUN && t > thermostat->on && thermostat->phase > 0.0)
      phase_set(system, own, t);
    else if (start)
      own->on = begins_on(thermostat, t);
    else if (own->on ? t >= thermostat->off : t <= thermostat->on)
      own->on = !own->on;
  }
}
