/* Private to thermal/loads/: how orbital loads see the Earth past the satellite itself. */
#ifndef UMBRA_IRRADIATION_LOADS_IMPL_H
#define UMBRA_IRRADIATION_LOADS_IMPL_H

#include "thermal/loads/loads.h"
#include "thermal/loads/sky_impl.h"

/* One time of a table. */
struct um_irradiation_row {
  float *sun, *incidence, *albedo, *planet, *view_factor; /* [nsurface] */
  float *brightness, *gas;                                /* [nsurface] or NULL */
  float *albedo_moments, *planet_moments; /* [nsurface][UM_ANGULAR_MOMENTS] or NULL */
};
struct um_irradiation_row um_irradiation_row_of(const struct um_irradiation_loads *loads, size_t k);

/* loads_spin_averaged.c: to row k of the table, which starts zeroed, weight times a row of one
 * attitude. */
void um_irradiation_spin_add(const struct um_irradiation_loads *loads, size_t k, double weight,
                             const struct um_irradiation_row *one);
/* Attitude j of row k: the time since the turn began [s] and the weight [1] or [s]. */
void um_irradiation_spin_node(const struct um_irradiation_spin *spin, size_t k, size_t j, double *u,
                              double *weight);

/* A pose with its scene. */
struct um_thermal_scene {
  struct um_geometry_pose *pose;
  struct um_geometry_visibility *visibility;
};

/* The visible cap; every direction also as four within its cell, since cells of the sky and of the
 * cap are of one size and would beat. */
struct um_thermal_cap {
  struct um_environment_cap_point point[UM_EARTH_CAP_POINTS];
  double along[1 + 4][3][UM_EARTH_CAP_POINTS]; /* unit vectors: of a point, of its four */
  uint16_t cell[UM_EARTH_CAP_POINTS][4];       /* of the sky, of the four */
  size_t n;
  bool varies; /* what it emits differs from place to place */
};

/* What of the cap stands before surfaces of one normal; behind the last direction 0 up to a
 * multiple of four. */
struct um_thermal_half {
  size_t n;                            /* directions before it */
  uint16_t point[UM_EARTH_CAP_POINTS]; /* of the cap */
  double cosine[UM_EARTH_CAP_POINTS];
  /* of each cosine times solid angle [sr]; times what is reflected [W/m^2]; times what is emitted
     [W/m^2], where the cap varies */
  double open[UM_EARTH_CAP_POINTS], reflected[UM_EARTH_CAP_POINTS], emitted[UM_EARTH_CAP_POINTS];
  double unit[UM_EARTH_CAP_POINTS];   /* a direction is free by `unit` times a number [1] */
  uint8_t ncell[UM_EARTH_CAP_POINTS]; /* 0 to 4 of the four that are before it too */
  uint16_t cell[UM_EARTH_CAP_POINTS][4];
  double planet, albedo, longwave;                            /* sums of those three */
  bool varies, by_angle;                                      /* by_angle: what follows is there */
  double polynomial[UM_ANGULAR_MOMENTS][UM_EARTH_CAP_POINTS]; /* P_1 to P_5 there [1] */
  double moment_albedo[UM_ANGULAR_MOMENTS], moment_planet[UM_ANGULAR_MOMENTS]; /* sums over all */
};

/* Fill `along` from the points; cell [UM_IRRADIATION_CUBE_CELLS]: of the sky, then of the four too;
 * NULL: not. */
void um_irradiation_cap_spread(struct um_thermal_cap *cap, const uint16_t *cell);
/* The half of a cap before a unit normal; four: those were filled, and numbers are sums of bytes,
 * otherwise shares; by_angle: with polynomials. */
void um_irradiation_cap_halve(const struct um_thermal_cap *cap, struct um_vec3 normal, bool four,
                              bool by_angle, struct um_thermal_half *out);
/* Its polynomials, once all else is there. */
void um_irradiation_half_by_angle(struct um_thermal_half *half);
/* The numbers by which the directions of the half are free before surfaces of one normal side by
 * side, 0 beside them; blocks of such. */
struct um_thermal_block {
  double of[UM_EARTH_CAP_POINTS][UM_IRRADIATION_LANES];
};
struct um_thermal_free {
  struct um_thermal_block block[UM_IRRADIATION_BLOCKS];
};
/* By the sky of a rigid body: of the surfaces of a class that are not open, those from `first` on,
 * a multiple of what is looked at at once (um_irradiation_sky_blocks). */
void um_irradiation_look_at_sky(const struct um_irradiation_sky *sky, size_t class, size_t first,
                                const struct um_thermal_half *half, struct um_thermal_free *out);
/* Of one surface, of the unit normal of which a half was made, by rays each from a point of the
 * facet of its own; out holds 0 in that lane before. */
void um_irradiation_look_by_rays(const struct um_geometry_mesh *mesh,
                                 const struct um_thermal_scene *scene, size_t surface,
                                 const struct um_thermal_cap *cap,
                                 const struct um_thermal_half *half, size_t lane,
                                 struct um_thermal_block *out);

/* Free shares [1] of the cap: of what the Earth reflects, of what it emits, and of its solid angle
 * times cosine; 1 where nothing of it lies before the surface. */
struct um_thermal_shares {
  double albedo, planet, view_factor;
  /* by_angle: how far the moments of what is free are from those shares of the whole half's, over
     E_0 of the whole half [1] */
  double moved_albedo[UM_ANGULAR_MOMENTS], moved_planet[UM_ANGULAR_MOMENTS];
};
void um_irradiation_cap_shares(const struct um_thermal_half *half,
                               const struct um_thermal_block *free_of,
                               struct um_thermal_shares out[UM_IRRADIATION_LANES]);
/* loads_angles.c: moved_albedo and moved_planet of shares whose others are there; moments of what
 * is free, as `moment_albedo` and `moment_planet` of the half are of all. */
void um_irradiation_shares_by_angle(const struct um_thermal_half *half,
                                    const double albedo[UM_ANGULAR_MOMENTS],
                                    const double planet[UM_ANGULAR_MOMENTS],
                                    struct um_thermal_shares *shares);
/* Moments of a surface from those of an unobstructed plate: to[UM_ANGULAR_MOMENTS] [W/m^2]. */
void um_irradiation_moments_set(const double whole[UM_ANGULAR_MOMENTS], double load, double share,
                                const double moved[UM_ANGULAR_MOMENTS], float *to);

/* loads_gas.c: what the atmosphere brings before each surface at one time, gas[nsurface], which
 * starts zeroed; fraction [nsurface] is scratch. */
void um_irradiation_gas_trace(const struct um_environment *environment,
                              const struct um_environment_sample *sample,
                              const struct um_geometry_mesh *mesh,
                              const struct um_thermal_scene *scene, int nsample, double *fraction,
                              float *gas);

#endif
