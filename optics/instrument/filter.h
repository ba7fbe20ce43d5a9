/* Transmission curves of filters, and any other response between 0 and 1 by wavelength (quantum
 * efficiency, throughput): read from CSV, averaged over bins. */
#ifndef UMBRA_INSTRUMENT_FILTER_H
#define UMBRA_INSTRUMENT_FILTER_H

#include <stddef.h>

#include "base/core/context.h"

/* Piecewise linear between its rows, zero outside them. */
struct um_instrument_filter {
  size_t n;             /* rows, 2 or more */
  double *wavelength;   /* [n] ascending [m] */
  double *transmission; /* [n] 0..1, per photon [1] */
};

/* CSV with columns wavelength_um or wavelength_nm, and transmission. UM_ERR_INPUT with file, line
 * and what is accepted: fewer than two rows, wavelengths that do not ascend or lie outside 0.1 to
 * 100 um, a transmission below 0, above 1 or missing, none of 1e-12 or more. UM_ERR_IO,
 * UM_ERR_MEMORY. The caller destroys. */
enum um_status um_instrument_filter_read(struct um_context *context, const char *path,
                                         struct um_instrument_filter **out);
/* The same by its name in the program's own folder ("johnson_v"); UM_ERR_INPUT with the names that
 * are accepted. */
enum um_status um_instrument_filter_find(struct um_context *context, const char *name,
                                         struct um_instrument_filter **out);
void um_instrument_filter_destroy(struct um_context *context, struct um_instrument_filter **filter);

/* Mean transmission between two wavelengths, from < to [m]; zero outside the curve. */
double um_instrument_filter_mean(const struct um_instrument_filter *filter, double from, double to);
/* Pivot wavelength, sqrt(int T lambda / int T/lambda) [m] (Tokunaga & Vacca 2005, PASP 117:421):
 * E_nu = E_lambda lambda_p^2/c for means over photons. */
double um_instrument_filter_pivot(const struct um_instrument_filter *filter);

/* Names in the program's own folder, ascending; the caller frees with um_core_listing_free. */
enum um_status um_instrument_filter_names(struct um_context *context, char ***names, size_t *count);

#endif
