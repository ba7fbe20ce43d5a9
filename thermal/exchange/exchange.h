/* Radiation between the surfaces of a satellite, over patches of them (geometry/patches.h), in two
 * bands: sunlight, reflected diffusely with 1 - absorptance, and infrared, emitted with the
 * emittance and reflected with 1 - emittance. All orders of reflection.
 *
 * Radiosity, per area of a patch:  J = e + r H,  H = F J + E,  E what falls in from outside, e own
 * emission, r reflectance, F view factors. So what arrives over that from outside, of own emission
 * and of reflected light, is
 *
 *   H - E = A^-1 B (e + r E),   B = S (1 - r A^-1 S)^-1,   S = A F exchange areas,
 *
 * with a symmetric B. Of emission e = eps sigma T^4, eps_p B_pq eps_q sigma T_q^4 is absorbed: the
 * radiative conductances of Gebhart (1961) and Hottel's total exchange areas. Where the emittance
 * goes with temperature, or surfaces age, what is emitted does at every instant; what is absorbed
 * of it and reflected is taken with one number a patch, as the network states it or, once
 * temperatures are known, at the temperature of what arrives (um_thermal_exchange_renew). The
 * Earth's infrared is absorbed and reflected with what laws say of its spectrum. A patch emits with
 * the mean of T^4 over its area and receives evenly.
 *
 * Mirrors reflect rho_s of what falls in along the mirrored ray and the rest, 1 - rho_s less what
 * they absorb, evenly. Exchange areas of mirrored paths S' (geometry/mirror_paths.h), whose rows
 * add up to (1 - rho_s) A, stand in place of S, (1 - rho_s) A of A, eps / (1 - rho_s) of eps: the
 * equations above for J / (1 - rho_s). The two bands have rho_s of their own. E then is all that
 * falls in before it is scattered: loads by way of mirrors too. Of sunlight that is the share of
 * each mirrored ray that arrives (thermal/loads/mirrored.h); of the Earth, what a patch's own rays
 * see of it behind mirrors. */
#ifndef UMBRA_THERMAL_EXCHANGE_H
#define UMBRA_THERMAL_EXCHANGE_H

#include "geometry/view_factor_table.h"
#include "thermal/loads/mirrored.h"
#include "thermal/network/network.h"

struct um_thermal_exchange;

struct um_thermal_aging;

/* What mirrors of a table do, by class: the share of what they reflect that goes on as from a
 * mirror [1], the rest is scattered. A class has one mirror's reflectance, its share of what its
 * patches reflect in the mean, and no more than the patch that reflects least. */
struct um_thermal_lobes {
  const double *solar, *infrared; /* [table->mirrors->nclass] */
};

struct um_thermal_exchange_options {
  bool infrared; /* emission between surfaces, and infrared of the Earth that they reflect */
  bool solar;    /* sunlight, direct and from the Earth, that they reflect to each other */
  /* surfaces that age, borrowed, NULL: none. What patches absorb of each other, and reflect twice
   * or more, is taken at its first row, what they reflect first of a load at the row of that load.
   */
  const struct um_thermal_aging *aging;
  const struct um_thermal_lobes *lobes;           /* borrowed, NULL: all reflection is diffuse */
  const struct um_irradiation_mirrored *mirrored; /* of the same loads, patches and mirrors,
                                                     borrowed; NULL: loads are scattered first */
  const struct um_thermal_exchange *like; /* take the temperatures of the last renewal from there,
                                             borrowed, same patches; NULL: optics as stated */
  bool like_sunlight; /* and what is reflected of sunlight: loads, patches, mirrors and aging are
                         those of `like`, and the networks are um_thermal_network_solar_equal */
};

/* Exchange of a network whose surfaces are those of the table, with the optics that they have now;
 * its own emission is to go everywhere (`blocked` 0) where infrared is on. loads: those that are
 * reflected, NULL: none; their times are those of the table, which has 1 where nothing moves. *out
 * is NULL where no surface sees another, or nothing is on. UM_ERR_INPUT: sizes that do not agree;
 * UM_ERR_NUMERIC: a room without a way out whose walls absorb nothing. The caller destroys. Tests:
 * thermal/exchange/exchange, thermal/exchange_reference. */
enum um_status um_thermal_exchange_create(struct um_context *context,
                                          const struct um_thermal_network *network,
                                          const struct um_irradiation_loads *loads,
                                          const struct um_geometry_view_factor_table *table,
                                          const struct um_thermal_exchange_options *options,
                                          struct um_thermal_exchange **out);
void um_thermal_exchange_destroy(struct um_context *context, struct um_thermal_exchange **exchange);

/* The same with the nodes at temperature[nnode] [K], view factors and reflected loads kept: what a
 * patch absorbs and reflects of others is then its emittance at the temperature of what arrives,
 *
 *   T_p,in^4 = sum_q (eps B eps)_pq T_q^4 / sum_q (eps B eps)_pq,
 *
 * one number a patch, so that B stays symmetric and a room of one temperature is in balance. What
 * is emitted goes with the emitter's own temperature anyhow. *change: largest relative change of an
 * emittance [1]; nothing is remade where it does not exceed `tolerance`. exchange NULL or without
 * infrared: nothing to do. table, network, aging as at its creation. UM_ERR_NUMERIC as there,
 * UM_ERR_MEMORY: the exchange is then only to be destroyed. */
enum um_status um_thermal_exchange_renew(struct um_context *context,
                                         const struct um_thermal_network *network,
                                         const struct um_geometry_view_factor_table *table,
                                         const struct um_thermal_aging *aging,
                                         const double *temperature, double tolerance,
                                         struct um_thermal_exchange *exchange, double *change);

/* Total exchange area eps_p B_pq eps_q between patches in a pose of the table [m^2]; NaN where
 * infrared is off. */
double um_thermal_exchange_area(const struct um_thermal_exchange *exchange, size_t pose, size_t p,
                                size_t q);

/* The same of patch p with all others: n of them, ascending, itself among them; borrowed. Infrared
 * is on. */
struct um_thermal_exchange_row {
  size_t n;
  const uint32_t *other; /* [n] */
  const double *area;    /* [n] [m^2] */
};
struct um_thermal_exchange_row um_thermal_exchange_row(const struct um_thermal_exchange *exchange,
                                                       size_t pose, size_t p);

#endif
