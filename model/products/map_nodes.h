/* What a reflectivity map holds: the nodes of a grid, those that refinement added, and the cells
 * between them. */
#ifndef UMBRA_MODEL_MAP_NODES_H
#define UMBRA_MODEL_MAP_NODES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What is to be mapped. */
struct um_model_map_grid {
  double step;               /* of latitude and longitude, a part of 90 deg [rad] */
  const double *phase_angle; /* [nphase] 0 to below pi, ascending [rad] */
  size_t nphase;
  size_t nplane; /* planes of Sun and observer about p, over half a turn; at gamma 0 one serves */
  double tolerance; /* of the larger of value and mean, to which cells are refined [1]; 0: none */
};

/* A cell of one plane, between four rows of `value`: south-west, south-east, north-west,
 * north-east. A cell that is split is its two halves. */
struct um_model_map_cell {
  uint32_t corner[4];
  uint32_t half;    /* the southern or western one, the other follows; 0: not split */
  bool along;       /* split in longitude, else in latitude */
  bool logarithmic; /* between its corners log(value + floor) is linear, else the value */
};
/* A node that refinement added. */
struct um_model_map_added {
  double latitude, longitude; /* [rad] */
  uint32_t phase, plane;      /* plane: of that phase angle */
};

/* Nodes: latitude i at -pi/2 + i step, both poles; longitude j at -pi + j step, all round; plane k
 * at k pi / nplane: exchanging Sun and observer turns it by pi and changes nothing, the
 * reflectance being reciprocal. */
struct um_model_map {
  double step; /* [rad] */
  double turn; /* that the planes of a phase angle share: pi, or 2 pi of what is not reciprocal */
  size_t nlatitude, nlongitude, nphase, nband;
  double *phase_angle; /* [nphase] [rad] */
  size_t *nplane;      /* [nphase] */
  size_t *first;       /* [nphase] plane of that phase angle among all */
  size_t planes;       /* of all phase angles together */
  size_t nnode;        /* planes nlatitude nlongitude of the grid, and those that were added */
  double *value;       /* [nnode][nband], first [planes][nlatitude][nlongitude] [m^2/sr] */
  double *error;       /* the same shape: standard error [m^2/sr] */
  double tolerance;    /* [1] */
  struct um_model_map_added *added; /* [nnode less those of the grid] */
  /* [ncell] first [planes][nlatitude - 1][nlongitude]; NULL: nothing is refined */
  struct um_model_map_cell *cell;
  size_t ncell;
  double *floor;     /* [nphase][nband] [m^2/sr] */
  size_t unfinished; /* cells that are off by more and were not split: too small, or too many */
};

/* Mean over directions and planes of a phase angle, by what is looked up [m^2/sr]. */
double um_model_map_mean(const struct um_model_map *map, size_t phase, size_t band);

#endif
