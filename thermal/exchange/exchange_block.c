/* Products with rows of exchange areas. Of many patches that see most of the others the rows do not
 * fit into the processor, and reading them is what takes time: 12 bytes an entry. There, blocks of
 * neighbouring columns stand in single precision, 4.5 bytes a column, zeros included. Both rows of
 * a pair have the same number still, and what rounding leaves of a row's sum is the patch's with
 * itself: no heat is lost, and a room of one temperature stays so. */
#include <string.h>

#include "base/core/wide.h"
#include "thermal/exchange/exchange_group.h"
#include "thermal/exchange/exchange_maker_impl.h"

#define BLOCK UM_THERMAL_BLOCK
#define LOT   UM_THERMAL_LOT
#define MANY  ((size_t)1 << 19) /* entries: 6 MB */
#define ENTRY 12                /* bytes */
#define BYTES (BLOCK * sizeof(float) + sizeof(uint32_t))

/* First column of the block that column q is in: the last of n columns is a whole one, too. */
static uint32_t block_of(size_t n, size_t q)
{
  size_t at = q - q % BLOCK;
  return (uint32_t)(at + BLOCK <= n ? at : n - BLOCK);
}

/* Blocks of row p into `to`, or with to->value NULL only their number. */
static size_t row_fill(const struct um_thermal_between *between, size_t n, size_t p,
                       struct um_thermal_between *to)
{
  size_t block = to->first[p], rows = block;
  double own = 0.0;
  for (size_t e = between->begin[p]; e < between->begin[p + 1]; e++) {
    size_t q = between->other[e];
    uint32_t at = block_of(n, q);
    if (block == rows || to->at[block - 1] != at) to->at[block++] = at;
    if (to->value == NULL) continue;
    float value = q != p ? (float)between->area[e] : 0.0f;
    to->value[(block - 1) * BLOCK + q - at] = value;
    own += between->area[e] - (double)value;
  }
  if (to->value != NULL) to->own[p] = own;
  return block;
}

enum um_status um_thermal_between_block(struct um_context *context, size_t n,
                                        struct um_thermal_between *between)
{
  enum um_status status = UM_OK;
  struct um_thermal_between to = {0};
  size_t nentry = between->begin[n];
  if (n < BLOCK || nentry < MANY) return UM_OK;
  UM_CHECK(um_core_allocate(context, n + 1, sizeof *to.first, &to.first));
  UM_CHECK(um_core_allocate(context, nentry, sizeof *to.at, &to.at));
  for (size_t p = 0; p < n; p++) to.first[p + 1] = row_fill(between, n, p, &to);
  size_t nblock = to.first[n];
  if (2 * nblock * BYTES > nentry * ENTRY) goto done;
  UM_CHECK(um_core_reallocate(context, nblock, sizeof *to.at, &to.at));
  UM_CHECK(um_core_allocate(context, nblock * BLOCK, sizeof *to.value, &to.value));
  UM_CHECK(um_core_allocate(context, n, sizeof *to.own, &to.own));
  for (size_t p = 0; p < n; p++) row_fill(between, n, p, &to);
  between->first = to.first;
  between->at = to.at;
  between->value = to.value;
  between->own = to.own;
  to = (struct um_thermal_between){0};
done:
  um_thermal_between_clear(context, &to, 1);
  return status;
}

static double entries(const struct um_thermal_between *between, size_t p, const double *x)
{
  double part[4] = {0.0, 0.0, 0.0, 0.0}; /* one strand would wait for itself */
  size_t e = between->begin[p], end = between->begin[p + 1];
  for (; e + 4 <= end; e += 4)
    for (size_t s = 0; s < 4; s++) part[s] += between->area[e + s] * x[between->other[e + s]];
  for (; e < end; e++) part[0] += between->area[e] * x[between->other[e]];
  return part[0] + part[1] + part[2] + part[3];
}

/* out[BLOCK]: of the columns of all blocks. */
UM_WIDE_VECTORS static void blocks(const uint32_t *at, const float *value, size_t n,
                                   const double *x, double *out)
{
  double sum[BLOCK] = {0.0};
  for (size_t b = 0; b < n; b++) {
    const double *of = x + at[b];
    for (size_t s = 0; s < BLOCK; s++) sum[s] += (double)value[b * BLOCK + s] * of[s];
  }
  memcpy(out, sum, sizeof sum);
}

double um_thermal_between_row(const struct um_thermal_between *between, size_t p, const double *x)
{
  double sum[BLOCK];
  if (between->first == NULL) return entries(between, p, x);
  size_t first = between->first[p];
  blocks(between->at + first, between->value + first * BLOCK, between->first[p + 1] - first, x,
         sum);
  return between->own[p] * x[p] +
         (((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7])));
}

/* out += the entries' area times x. */
UM_WIDE_VECTORS static void entries_lot(const uint32_t *other, const double *area, size_t n,
                                        double weight, const double (*x)[LOT], double *out)
{
  double sum[LOT] = {0.0};
  for (size_t e = 0; e < n; e++) {
    const double *of = x[other[e]];
    for (size_t k = 0; k < LOT; k++) sum[k] += area[e] * of[k];
  }
  for (size_t k = 0; k < LOT; k++) out[k] += weight * sum[k];
}

UM_WIDE_VECTORS static void blocks_lot(const uint32_t *at, const float *value, size_t n,
                                       double weight, const double (*x)[LOT], double *out)
{
  double sum[LOT] = {0.0};
  for (size_t b = 0; b < n; b++)
    for (size_t s = 0; s < BLOCK; s++) {
      double area = (double)value[b * BLOCK + s];
      const double *of = x[at[b] + s];
      for (size_t k = 0; k < LOT; k++) sum[k] += area * of[k];
    }
  for (size_t k = 0; k < LOT; k++) out[k] += weight * sum[k];
}

void um_thermal_between_row_lot(const struct um_thermal_between *between, size_t p, double weight,
                                const double (*x)[LOT], double *out)
{
  if (between->first == NULL) {
    size_t begin = between->begin[p];
    entries_lot(between->other + begin, between->area + begin, between->begin[p + 1] - begin,
                weight, x, out);
    return;
  }
  size_t first = between->first[p];
  for (size_t k = 0; k < LOT; k++) out[k] += weight * between->own[p] * x[p][k];
  blocks_lot(between->at + first, between->value + first * BLOCK, between->first[p + 1] - first,
             weight, x, out);
}
