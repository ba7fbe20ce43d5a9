/* Private to the rooms of thermal/: exchange between patches as numbers. */
#ifndef UMBRA_THERMAL_EXCHANGE_GROUP_H
#define UMBRA_THERMAL_EXCHANGE_GROUP_H

#include "thermal/exchange/exchange.h"

#define UM_THERMAL_NO_PATCH UINT32_MAX

/* What surfaces reflect to each other of a load, per patch. */
struct um_thermal_reflected {
  double *sun;    /* [ntime][npatch] of the free share times cosine [1]; NULL: off */
  double *albedo; /* [ntime][npatch] [W/m^2]; NULL: off */
  double *planet; /* [ntime][npatch] [W/m^2]; NULL: off */
};

/* Total exchange areas eps_p B_pq eps_q of one pose [m^2], in rows; what is small is left with the
 * patch that sends it, see exchange.c. */
struct um_thermal_between {
  size_t *begin;   /* [npatch + 1], of the outside [noutside + 1] */
  uint32_t *other; /* [nentry] */
  double *area;    /* [nentry] [m^2] */
  /* the same for products, where rows are long and full: blocks of columns in single precision, and
     what that leaves out of the sum of a row; exchange_block.c */
  size_t *first; /* [npatch + 1] blocks of a row; NULL: none */
  uint32_t *at;  /* [nblock] first column */
  float *value;  /* [nblock][UM_THERMAL_BLOCK] [m^2] */
  double *own;   /* [npatch] of a patch with itself [m^2] */
};
#define UM_THERMAL_BLOCK 8
#define UM_THERMAL_LOT   8 /* products that are made side by side */

/* Blocks of rows [0, n), which see each other alone, where these are read faster than entries. */
enum um_status um_thermal_between_block(struct um_context *context, size_t n,
                                        struct um_thermal_between *between);
/* Sum over row p. */
double um_thermal_between_row(const struct um_thermal_between *between, size_t p, const double *x);
/* out[UM_THERMAL_LOT] += weight times the same, of as many x. */
void um_thermal_between_row_lot(const struct um_thermal_between *between, size_t p, double weight,
                                const double (*x)[UM_THERMAL_LOT], double *out);

struct um_thermal_exchange {
  size_t nsurface, npatch, npose;
  size_t noutside;   /* patches of the outside; those of rooms follow */
  uint32_t *patch;   /* [nsurface] or UM_THERMAL_NO_PATCH */
  double *area;      /* [npatch] [m^2] */
  double *emittance; /* [nsurface] that `between` is made with; 0 where not attached [1] */
  double *arriving;  /* [nsurface] temperature that these are taken at: of what arrives, where
                        nothing does the surface's own [K]; NULL: they are as stated */
  double *lobe;      /* [class of the table's mirrors] share of reflected infrared that goes on as
                        from a mirror [1]; NULL: none */
  struct um_thermal_between *between; /* [npose + 1]: of the outside in each pose, then of all
                                         rooms; NULL: infrared is off */
  struct um_thermal_between *strong;  /* [npose + 1] the larger ones, for Newton's matrix */
  size_t ntime, ncorner;
  double *t;                             /* [ntime] [s]; used where there is more than one pose */
  uint32_t *corner;                      /* [ntime][ncorner] */
  double *weight;                        /* [ntime][ncorner] */
  struct um_thermal_reflected reflected; /* ntime of the loads */
};

/* Poses at an instant. */
#define UM_THERMAL_MIX 20
struct um_thermal_mix {
  size_t n;
  uint32_t pose[UM_THERMAL_MIX];
  double weight[UM_THERMAL_MIX];
};
void um_thermal_exchange_mix(const struct um_thermal_exchange *exchange, double t,
                             struct um_thermal_mix *mix);
/* heat[npatch] = sum_q (eps B eps)_pq sigma x_q [W] for x[npatch] [K^4]; between: a member of the
 * exchange. The same bits for any number of threads. */
void um_thermal_exchange_apply(const struct um_thermal_exchange *exchange,
                               const struct um_thermal_between *between,
                               const struct um_thermal_mix *mix, int threads, const double *x,
                               double *heat);
/* The same of UM_THERMAL_LOT x side by side, by one thread. */
void um_thermal_exchange_apply_lot(const struct um_thermal_exchange *exchange,
                                   const struct um_thermal_between *between,
                                   const struct um_thermal_mix *mix,
                                   const double (*x)[UM_THERMAL_LOT],
                                   double (*heat)[UM_THERMAL_LOT]);
/* arriving[nsurface] [K]: the fourth power is the mean of what a surface's patch receives of the
 * satellite's own infrared, by total exchange area, reflections and itself included, nodes at
 * temperature[nnode]; over the poses. The surface's own where nothing is received. UM_ERR_MEMORY.
 */
enum um_status um_thermal_exchange_arriving(struct um_context *context,
                                            const struct um_thermal_exchange *exchange,
                                            const struct um_thermal_network *network,
                                            const double *temperature, double *arriving);
/* A reflected load on surface s at a row; 0 without. table: a member of `reflected`. */
static inline double um_thermal_reflected_at(const struct um_thermal_exchange *exchange,
                                             const double *table, size_t row, size_t s)
{
  if (table == NULL || exchange->patch[s] == UM_THERMAL_NO_PATCH) return 0.0;
  return table[row * exchange->npatch + exchange->patch[s]];
}

#endif
