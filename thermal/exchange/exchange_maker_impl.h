/* An exchange while it is made. Private to thermal/exchange/exchange*.c. */
#ifndef UMBRA_THERMAL_EXCHANGE_MAKER_IMPL_H
#define UMBRA_THERMAL_EXCHANGE_MAKER_IMPL_H

#include "geometry/view_factor_table.h"
#include "thermal/exchange/reflections_impl.h"
#include "thermal/loads/mirrored.h"
#include "thermal/network/surface_reflectance_group.h"

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
  const double *lobe_solar, *lobe_infrared;       /* [class of the table's mirrors] share of what is
                                                     reflected that mirrors send on; NULL: none */
  const struct um_irradiation_mirrored *mirrored; /* loads by way of mirrors; NULL: none */
  /* of the band in hand, mirrors aside: what is absorbed and scattered, as shares of 1 - rho */
  double *absorbed;    /* [npatch] absorptance or emittance / (1 - rho) [1] */
  double *reflectance; /* [npatch] 1 - absorbed [1] */
  double *mirror;      /* [npatch] rho [1] */
  double *of_class;    /* [class of the table's mirrors] rho [1] */
  double *open;        /* [npatch] (1 - rho) A [m^2] */
  struct um_thermal_reflections *reflections;        /* B of pose, or room, and band in hand */
  struct um_geometry_view_factors *mirrored_factors; /* that it borrows; NULL: the table's */
  size_t first, n;                                   /* patches in hand */
  struct um_thermal_exchange *out;
};

/* Storage that both bands need; out has its patches. Freed by destroy, after a failure too. */
enum um_status um_thermal_exchange_maker_create(struct um_thermal_exchange_maker *m);
void um_thermal_exchange_maker_destroy(struct um_thermal_exchange_maker *m);
/* Emittances for the satellite's own infrared, of_surface[nsurface] and of patches. */
void um_thermal_exchange_take_emittances(struct um_thermal_exchange_maker *m, double *of_surface);
/* B of view factors whose patches stand from `first` on, which are then in hand: no mirrors. */
enum um_status um_thermal_exchange_make_reflections(struct um_thermal_exchange_maker *m,
                                                    const struct um_geometry_view_factors *factors,
                                                    size_t first, const double *absorbed);
/* B of the outside in a pose, whose patches are then in hand, with mirrors that have these lobes
 * [class], NULL: none; absorbed [npatch] of what falls in. */
enum um_status um_thermal_exchange_make_pose(struct um_thermal_exchange_maker *m, size_t pose,
                                             const double *absorbed, const double *lobe);
/* Total exchange areas in a pose, whose B is then in hand; of the rooms. */
enum um_status um_thermal_exchange_make_infrared(struct um_thermal_exchange_maker *m, size_t pose);
enum um_status um_thermal_exchange_make_inside(struct um_thermal_exchange_maker *m);
/* Of B in hand: eps B eps behind the rows that `between` and `strong` have, without what is small;
 * exchange_keep.c. */
enum um_status um_thermal_exchange_keep(struct um_thermal_exchange_maker *m,
                                        struct um_thermal_between *between,
                                        struct um_thermal_between *strong);
/* What the pose in hand adds to that load of all rows, out [ntime][npatch]: what arrives by way of
 * mirrors and reflections; exchange_reflect.c. */
enum um_status um_thermal_exchange_reflect(struct um_thermal_exchange_maker *m, size_t pose,
                                           enum um_thermal_load load, double *out);
void um_thermal_between_clear(struct um_context *context, struct um_thermal_between *between,
                              size_t npose);

#endif
