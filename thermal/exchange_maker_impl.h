/* An exchange while it is made. Private to thermal/exchange.c and exchange_between.c. */
#ifndef UMBRA_THERMAL_EXCHANGE_MAKER_IMPL_H
#define UMBRA_THERMAL_EXCHANGE_MAKER_IMPL_H

#include "geometry/view_factor_table.h"
#include "irradiation/loads.h"

struct um_thermal_aging;
struct um_thermal_between;
struct um_thermal_exchange;
struct um_thermal_network;

struct um_thermal_exchange_maker {
  struct um_context *context;
  const struct um_thermal_network *network;
  const struct um_irradiation_loads *loads;
  const struct um_geometry_view_factor_table *table;
  const struct um_thermal_aging *aging; /* of which the first row counts; NULL: nothing ages */
  const double *arriving; /* [nsurface] temperature of what arrives [K]; NULL: optics as stated */
  double *emittance;      /* [npatch] for the satellite's own infrared [1] */
  double *planet;         /* [npatch] for the Earth's [1] */
  double *absorptance;    /* [npatch] for sunlight [1] */
  double *reflectance;    /* [npatch] of the band in hand [1] */
  double *b;              /* [n][n] of pose, or room, and band in hand [m^2] */
  size_t first, n;        /* patches in hand */
  struct um_thermal_exchange *out;
};

/* Storage that both bands need; out has its patches. Freed by destroy, after a failure too. */
enum um_status um_thermal_exchange_maker_create(struct um_thermal_exchange_maker *m);
void um_thermal_exchange_maker_destroy(struct um_thermal_exchange_maker *m);
/* Emittances for the satellite's own infrared, of_surface[nsurface] and of patches. */
void um_thermal_exchange_take_emittances(struct um_thermal_exchange_maker *m, double *of_surface);
/* B of view factors whose patches stand from `first` on, which are then in hand. */
enum um_status um_thermal_exchange_make_reflections(struct um_thermal_exchange_maker *m,
                                                    const struct um_geometry_view_factors *factors,
                                                    size_t first, const double *absorbed);
/* Total exchange areas in a pose, whose B is then in hand; of the rooms. */
enum um_status um_thermal_exchange_make_infrared(struct um_thermal_exchange_maker *m, size_t pose);
enum um_status um_thermal_exchange_make_inside(struct um_thermal_exchange_maker *m);
void um_thermal_between_clear(struct um_context *context, struct um_thermal_between *between,
                              size_t npose);

#endif
