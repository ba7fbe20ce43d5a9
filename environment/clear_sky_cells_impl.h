/* What clear air takes of light, by wavelength. Private to environment/. */
#ifndef UMBRA_ENVIRONMENT_CLEAR_SKY_CELLS_IMPL_H
#define UMBRA_ENVIRONMENT_CLEAR_SKY_CELLS_IMPL_H

/* Cells of 1 nm from 0.562 to 1.1 um; below there are no lines. k_w, k_u (clear_sky.c). */
#define UM_VISIBLE_FROM  0.562e-6 /* [m] */
#define UM_VISIBLE_STEP  0.001e-6 /* [m] */
#define UM_VISIBLE_CELLS 538
struct um_environment_visible_cell {
  double water, uniform;
};
extern const struct um_environment_visible_cell um_environment_visible_cells[UM_VISIBLE_CELLS];

/* Every 5 1/cm from 700 1/cm, linear between: k_u, k_w, k_c, k_o, d. */
#define UM_INFRARED_FIRST 70000.0 /* [1/m] */
#define UM_INFRARED_STEP  500.0   /* [1/m] */
#define UM_INFRARED_NODES 146
struct um_environment_infrared_node {
  double uniform, water, continuum, ozone; /* [1] */
  double cooling;                          /* [K] */
};
extern const struct um_environment_infrared_node um_environment_infrared_nodes[UM_INFRARED_NODES];
/* At a wavenumber [1/m]; the ends hold beyond them. */
struct um_environment_infrared_node um_environment_infrared_at(double wavenumber);

#endif
