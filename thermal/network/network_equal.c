/* Two networks compared number for number; names are not compared. */
#include <string.h>

#include "thermal/network/network_group.h"

static bool numbers_equal(const double *a, const double *b, size_t n)
{
  for (size_t i = 0; i < n; i++)
    if (a[i] != b[i]) return false;
  return true;
}

static bool spreads_equal(const struct um_thermal_spread *a, const struct um_thermal_spread *b)
{
  return a->n == b->n && memcmp(a->node, b->node, a->n * sizeof *a->node) == 0 &&
         numbers_equal(a->weight, b->weight, a->n);
}

static bool heat_equal(const struct um_thermal_network *a, const struct um_thermal_network *b)
{
  if (a->nsource != b->nsource || a->nthermostat != b->nthermostat) return false;
  for (size_t k = 0; k < a->nsource; k++) {
    const struct um_thermal_network_source *x = &a->source[k], *y = &b->source[k];
    if (x->nrow != y->nrow || x->stepwise != y->stepwise || !spreads_equal(&x->at, &y->at) ||
        !numbers_equal(x->t, y->t, x->nrow) || !numbers_equal(x->power, y->power, x->nrow))
      return false;
  }
  for (size_t k = 0; k < a->nthermostat; k++) {
    const struct um_thermal_network_thermostat *x = &a->thermostat[k], *y = &b->thermostat[k];
    if (x->power != y->power || x->on != y->on || x->off != y->off || x->start != y->start ||
        x->phase != y->phase || !spreads_equal(&x->at, &y->at) ||
        !spreads_equal(&x->sensor, &y->sensor))
      return false;
  }
  return true;
}

static bool links_equal(const struct um_thermal_link *a, const struct um_thermal_link *b, size_t n)
{
  for (size_t k = 0; k < n; k++)
    if (a[k].a != b[k].a || a[k].b != b[k].b || a[k].value != b[k].value || a[k].law != b[k].law)
      return false;
  return true;
}

static bool laws_equal(const struct um_thermal_surface_law *a,
                       const struct um_thermal_surface_law *b)
{
  if (a == b || a == NULL || b == NULL) return a == b;
  return a->albedo == b->albedo && a->planet == b->planet && a->by_angle == b->by_angle &&
         numbers_equal(a->albedo_angle, b->albedo_angle, UM_ANGULAR_MOMENTS) &&
         numbers_equal(a->planet_angle, b->planet_angle, UM_ANGULAR_MOMENTS) &&
         numbers_equal(a->absorptance, b->absorptance, UM_THERMAL_LAW_ANGLES) &&
         numbers_equal(a->emittance, b->emittance, UM_THERMAL_LAW_TEMPERATURES);
}

static bool surfaces_equal(const struct um_thermal_surface *a, const struct um_thermal_surface *b)
{
  for (int k = 0; k < 3; k++)
    if (a->node[k] != b->node[k] || a->weight[k] != b->weight[k]) return false;
  return a->area == b->area && a->absorptance == b->absorptance && a->emittance == b->emittance &&
         a->extraction == b->extraction && a->blocked == b->blocked && a->inside == b->inside &&
         laws_equal(a->law, b->law);
}

bool um_thermal_network_equal(const struct um_thermal_network *a,
                              const struct um_thermal_network *b)
{
  if (a->nnode != b->nnode || a->nconductor != b->nconductor || a->nradiator != b->nradiator ||
      a->nsurface != b->nsurface)
    return false;
  for (size_t i = 0; i < a->nnode; i++) {
    const struct um_thermal_network_node *x = &a->node[i], *y = &b->node[i];
    if (x->kind != y->kind || x->capacity != y->capacity || x->temperature != y->temperature ||
        x->power != y->power)
      return false;
  }
  if (!links_equal(a->conductor, b->conductor, a->nconductor) ||
      !links_equal(a->radiator, b->radiator, a->nradiator))
    return false;
  for (size_t s = 0; s < a->nsurface; s++) {
    if (a->attached[s] != b->attached[s]) return false;
    if (a->attached[s] && !surfaces_equal(&a->surface[s], &b->surface[s])) return false;
  }
  return um_thermal_network_laws_equal(a, b) && heat_equal(a, b);
}

bool um_thermal_network_optics_equal(const struct um_thermal_network *a,
                                     const struct um_thermal_network *b)
{
  if (a->nsurface != b->nsurface) return false;
  for (size_t s = 0; s < a->nsurface; s++) {
    const struct um_thermal_surface *x = &a->surface[s], *y = &b->surface[s];
    if (a->attached[s] != b->attached[s]) return false;
    if (a->attached[s] && !(x->area == y->area && x->emittance == y->emittance &&
                            x->absorptance == y->absorptance && laws_equal(x->law, y->law)))
      return false;
  }
  return true;
}

static bool solar_laws_equal(const struct um_thermal_surface_law *a,
                             const struct um_thermal_surface_law *b)
{
  if (a == b || a == NULL || b == NULL) return a == b;
  return a->albedo == b->albedo && a->by_angle == b->by_angle &&
         numbers_equal(a->albedo_angle, b->albedo_angle, UM_ANGULAR_MOMENTS) &&
         numbers_equal(a->absorptance, b->absorptance, UM_THERMAL_LAW_ANGLES);
}

bool um_thermal_surface_sunlight_equal(const struct um_thermal_surface *a,
                                       const struct um_thermal_surface *b)
{
  return a->absorptance == b->absorptance && a->extraction == b->extraction &&
         solar_laws_equal(a->law, b->law);
}

bool um_thermal_surface_loads_equal(const struct um_thermal_surface *a,
                                    const struct um_thermal_surface *b)
{
  return um_thermal_surface_sunlight_equal(a, b) && a->emittance == b->emittance &&
         (a->law == b->law || a->law == NULL ||
          (a->law->planet == b->law->planet &&
           numbers_equal(a->law->planet_angle, b->law->planet_angle, UM_ANGULAR_MOMENTS)));
}

bool um_thermal_network_solar_equal(const struct um_thermal_network *a,
                                    const struct um_thermal_network *b)
{
  if (a->nsurface != b->nsurface) return false;
  for (size_t s = 0; s < a->nsurface; s++) {
    const struct um_thermal_surface *x = &a->surface[s], *y = &b->surface[s];
    if (a->attached[s] != b->attached[s]) return false;
    if (a->attached[s] && !(x->area == y->area && x->absorptance == y->absorptance &&
                            solar_laws_equal(x->law, y->law)))
      return false;
  }
  return true;
}

bool um_thermal_network_structure_equal(const struct um_thermal_network *a,
                                        const struct um_thermal_network *b)
{
  if (a->nnode != b->nnode || a->nthermostat != b->nthermostat || a->nsource != b->nsource)
    return false;
  for (size_t i = 0; i < a->nnode; i++)
    if (a->node[i].kind != b->node[i].kind) return false;
  for (size_t k = 0; k < a->nsource; k++) {
    const struct um_thermal_network_source *x = &a->source[k], *y = &b->source[k];
    if (x->nrow != y->nrow || x->stepwise != y->stepwise || !numbers_equal(x->t, y->t, x->nrow))
      return false;
  }
  return true;
}
