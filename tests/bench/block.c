/* Mesh, network and CalculiX's input of the block that cools. */
#include "tests/bench/block.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/core/constants.h"
#include "thermal/network/builder_impl.h"

#define MOVED 0.15 /* of a cell, either way */

/* In [-1, 1], a function of k alone (Knuth's multiplicative hash). */
static double scatter(size_t k)
{
  return (double)((uint32_t)(k * 2654435761u) >> 8) / (double)(1u << 23) - 1.0;
}

static void vertices_make(struct block *b, size_t nx, size_t ny, size_t nz, double h)
{
  for (size_t z = 0; z <= nz; z++)
    for (size_t y = 0; y <= ny; y++)
      for (size_t x = 0; x <= nx; x++) {
        size_t v = (z * (ny + 1) + y) * (nx + 1) + x;
        bool inner = x > 0 && y > 0 && z > 0 && x < nx && y < ny && z < nz;
        double m = inner ? MOVED : 0.0;
        b->vertex[v] =
            um_vec3(h * ((double)x + m * scatter(3 * v)), h * ((double)y + m * scatter(3 * v + 1)),
                    h * ((double)z + m * scatter(3 * v + 2)));
      }
}

/* Six tetrahedra of a cube about its diagonal, one for each order of the axes. */
static void tetrahedra_make(struct block *b, size_t nx, size_t ny, size_t nz)
{
  static const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
  const size_t stride[3] = {1, nx + 1, (nx + 1) * (ny + 1)};
  for (size_t z = 0; z < nz; z++)
    for (size_t y = 0; y < ny; y++)
      for (size_t x = 0; x < nx; x++)
        for (int o = 0; o < 6; o++) {
          size_t v[4] = {x + y * stride[1] + z * stride[2], 0, 0, 0};
          for (int c = 1; c < 4; c++) v[c] = v[c - 1] + stride[order[o][c - 1]];
          uint32_t *t = b->tetrahedron[b->ntetrahedron++];
          bool odd = o >= 3; /* the other hand */
          t[0] = (uint32_t)v[0];
          t[1] = (uint32_t)v[1];
          t[2] = (uint32_t)(odd ? v[3] : v[2]);
          t[3] = (uint32_t)(odd ? v[2] : v[3]);
        }
}

static bool on_border(const struct um_vec3 *v[3], const double size[3])
{
  for (int axis = 0; axis < 3; axis++)
    for (int side = 0; side < 2; side++) {
      bool all = true;
      for (int c = 0; c < 3; c++) {
        const double x[3] = {v[c]->x, v[c]->y, v[c]->z};
        all = all && fabs(x[axis] - side * size[axis]) < 1e-9;
      }
      if (all) return true;
    }
  return false;
}

void block_create(const struct bench *bench, size_t cells, struct block *b)
{
  size_t nx = 4 * cells, ny = 2 * cells, nz = cells;
  *b = (struct block){.nvertex = (nx + 1) * (ny + 1) * (nz + 1)};
  b->vertex = bench_allocate(bench, b->nvertex, sizeof *b->vertex);
  b->tetrahedron = bench_allocate(bench, 6 * nx * ny * nz, sizeof *b->tetrahedron);
  b->face = bench_allocate(bench, 4 * (nx * ny + ny * nz + nz * nx), sizeof *b->face);
  vertices_make(b, nx, ny, nz, 0.25 / (double)cells);
  tetrahedra_make(b, nx, ny, nz);
  const double size[3] = {1.0, 0.5, 0.25};
  for (uint32_t t = 0; t < b->ntetrahedron; t++)
    for (uint32_t apex = 0; apex < 4; apex++) {
      const struct um_vec3 *v[3];
      for (uint32_t c = 0, at = 0; c < 4; c++)
        if (c != apex) v[at++] = &b->vertex[b->tetrahedron[t][c]];
      if (!on_border(v, size)) continue;
      b->face[b->nface][0] = t;
      b->face[b->nface++][1] = apex;
    }
}

void block_free(const struct bench *bench, struct block *b)
{
  um_core_free(bench->context, b->vertex);
  um_core_free(bench->context, b->tetrahedron);
  um_core_free(bench->context, b->face);
}

static void radiators_add(const struct bench *bench, const struct block *b,
                          struct um_thermal_network *network)
{
  for (size_t f = 0; f < b->nface; f++) {
    const uint32_t *t = b->tetrahedron[b->face[f][0]];
    uint32_t v[3];
    for (uint32_t c = 0, at = 0; c < 4; c++)
      if (c != b->face[f][1]) v[at++] = t[c];
    struct um_vec3 n = um_vec3_cross(um_vec3_sub(b->vertex[v[1]], b->vertex[v[0]]),
                                     um_vec3_sub(b->vertex[v[2]], b->vertex[v[0]]));
    double share = 0.5 * um_vec3_norm(n) * BLOCK_EMITTANCE / 3.0;
    for (int c = 0; c < 3; c++)
      bench_must(bench, um_thermal_network_radiator_add(network, v[c], UM_THERMAL_SPACE, share));
  }
}

struct um_thermal_network *block_network(const struct bench *bench, const struct block *b)
{
  static const int edge[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  struct um_thermal_network *network = NULL;
  bench_must(bench, um_thermal_network_create(bench->context, &network));
  double *capacity = bench_allocate(bench, b->nvertex, sizeof *capacity);
  for (int pass = 0; pass < 2; pass++) {
    for (size_t e = 0; e < b->ntetrahedron; e++) {
      const uint32_t *v = b->tetrahedron[e];
      struct um_vec3 corner[4];
      double k[6];
      for (int c = 0; c < 4; c++) corner[c] = b->vertex[v[c]];
      double volume = um_thermal_solid_element(corner, BLOCK_CONDUCTIVITY, k);
      for (int c = 0; c < 4 && pass == 0; c++)
        capacity[v[c]] += BLOCK_DENSITY * BLOCK_HEAT * volume / 4.0;
      for (int i = 0; i < 6 && pass == 1; i++)
        bench_must(bench,
                   um_thermal_network_conductor_add(network, v[edge[i][0]], v[edge[i][1]], k[i]));
    }
    uint32_t node;
    for (size_t v = 0; v < b->nvertex && pass == 0; v++)
      bench_must(bench, um_thermal_network_node_add(network, NULL, UM_NODE_DIFFUSIVE, capacity[v],
                                                    BLOCK_START, 0.0, &node));
  }
  radiators_add(bench, b, network);
  um_core_free(bench->context, capacity);
  return network;
}

/* Face k of a C3D4 is the one without corner 4, 3, 1, 2 in CalculiX's count from 1. */
static int face_number(uint32_t apex)
{
  static const int number[4] = {3, 4, 2, 1};
  return number[apex];
}

static bool deck_write(const struct block *b, double largest_change, const char *path)
{
  FILE *file = fopen(path, "w");
  if (file == NULL) return false;
  fputs("*NODE, NSET=NALL\n", file);
  for (size_t v = 0; v < b->nvertex; v++)
    fprintf(file, "%zu, %.12g, %.12g, %.12g\n", v + 1, b->vertex[v].x, b->vertex[v].y,
            b->vertex[v].z);
  fputs("*ELEMENT, TYPE=C3D4, ELSET=EALL\n", file);
  for (size_t e = 0; e < b->ntetrahedron; e++) {
    const uint32_t *t = b->tetrahedron[e];
    fprintf(file, "%zu, %u, %u, %u, %u\n", e + 1, t[0] + 1, t[1] + 1, t[2] + 1, t[3] + 1);
  }
  fprintf(file,
          "*MATERIAL, NAME=M\n*CONDUCTIVITY\n%g\n*DENSITY\n%g\n*SPECIFIC HEAT\n%g\n"
          "*SOLID SECTION, ELSET=EALL, MATERIAL=M\n"
          "*PHYSICAL CONSTANTS, ABSOLUTE ZERO=0, STEFAN BOLTZMANN=%.10g\n"
          "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nNALL, %g\n"
          "*STEP, INC=100000\n*HEAT TRANSFER, DELTMX=%g\n1., %g\n*RADIATE\n",
          BLOCK_CONDUCTIVITY, BLOCK_DENSITY, BLOCK_HEAT, UM_STEFAN_BOLTZMANN, BLOCK_START,
          largest_change, BLOCK_DURATION);
  for (size_t f = 0; f < b->nface; f++)
    fprintf(file, "%u, R%d, %g, %g\n", b->face[f][0] + 1, face_number(b->face[f][1]), BLOCK_SKY,
            BLOCK_EMITTANCE);
  fputs("*NODE PRINT, NSET=NALL, FREQUENCY=100000\nNT\n*END STEP\n", file);
  bool written = ferror(file) == 0;
  return fclose(file) == 0 && written;
}

/* Mean over volume of the temperatures that end the result [K]. */
static double mean_read(const struct block *b, const double *share, const char *path)
{
  FILE *file = fopen(path, "r");
  char line[256];
  double sum = 0.0;
  if (file == NULL) return NAN;
  while (fgets(line, sizeof line, file) != NULL) {
    char *next;
    unsigned long node = strtoul(line, &next, 10);
    char *end;
    double value = strtod(next, &end);
    if (end != next && node >= 1 && node <= b->nvertex) sum += share[node - 1] * value;
    if (strstr(line, "temperatures") != NULL) sum = 0.0;
  }
  fclose(file);
  return sum > 0.0 ? sum : NAN;
}

/* Runs ccx in the folder; false where that is not possible. */
static bool ccx_run(const char *folder)
{
  fflush(stdout);
  pid_t child = fork();
  if (child < 0) return false;
  if (child == 0) {
    setenv("OMP_NUM_THREADS", "1", 1);
    setenv("OPENBLAS_NUM_THREADS", "1", 1);
    if (chdir(folder) != 0 || freopen("log", "w", stdout) == NULL) _exit(126);
    execlp("ccx", "ccx", "-i", "block", (char *)NULL);
    _exit(127);
  }
  int result;
  if (waitpid(child, &result, 0) != child) return false;
  if (WIFEXITED(result) && WEXITSTATUS(result) == 127)
    puts("CalculiX (ccx) is not installed: nothing is held against it");
  return WIFEXITED(result) && WEXITSTATUS(result) == 0;
}

struct block_peer block_calculix(const struct bench *bench, const struct block *b,
                                 double largest_change)
{
  static const char *const files[] = {"block.inp", "block.dat", "block.frd",   "block.sta",
                                      "block.cvg", "block.12d", "spooles.out", "log"};
  struct block_peer peer = {NAN, NAN};
  char folder[BENCH_FOLDER], path[BENCH_FOLDER + 16];
  double *share = bench_allocate(bench, b->nvertex, sizeof *share), total = 0.0, k[6];
  for (size_t e = 0; e < b->ntetrahedron; e++) {
    struct um_vec3 corner[4];
    for (int c = 0; c < 4; c++) corner[c] = b->vertex[b->tetrahedron[e][c]];
    double volume = um_thermal_solid_element(corner, 1.0, k);
    for (int c = 0; c < 4; c++) share[b->tetrahedron[e][c]] += volume / 4.0;
    total += volume;
  }
  for (size_t v = 0; v < b->nvertex; v++) share[v] /= total;
  bench_folder(folder);
  snprintf(path, sizeof path, "%s/block.inp", folder);
  double begin = bench_wall();
  if (deck_write(b, largest_change, path) && ccx_run(folder)) {
    peer.seconds = bench_wall() - begin;
    snprintf(path, sizeof path, "%s/block.dat", folder);
    peer.mean = mean_read(b, share, path);
  }
  for (size_t f = 0; f < sizeof files / sizeof files[0]; f++) {
    snprintf(path, sizeof path, "%s/%s", folder, files[f]);
    remove(path);
  }
  rmdir(folder);
  um_core_free(bench->context, share);
  return peer;
}
