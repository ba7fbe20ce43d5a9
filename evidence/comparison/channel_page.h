/* A channel of measurements on a page: data beside models, and what they leave. */
#ifndef UMBRA_COMPARE_CHANNEL_PAGE_H
#define UMBRA_COMPARE_CHANNEL_PAGE_H

#include "base/page/writer.h"
#include "evidence/measurements/set.h"

#define UM_COMPARE_PAGE_MODELS 2

/* Values of one model at the observations of a channel. */
struct um_compare_page_model {
  const char *name, *role; /* "before", "before" */
  const double *value;     /* [count] in the quantity's unit */
  const double *residual;  /* [count] measured - model in sigma, or in the residual's unit */
};
struct um_compare_page_channel {
  const struct um_compare_channel *channel;
  size_t count;
  const double *time;          /* [count] seconds since 1970, UTC, not decreasing */
  const double *value, *sigma; /* [count] measured, in the quantity's unit; NaN: no sigma */
  bool weighted;               /* residuals are in sigma */
  struct um_compare_page_model model[UM_COMPARE_PAGE_MODELS];
  size_t nmodel;
};
/* A figure of two panels. id: of the channel's number, so that a page may have many. UM_ERR_MEMORY.
 */
enum um_status um_compare_page_put_channel(struct um_page_writer *w,
                                           const struct um_compare_page_channel *channel,
                                           size_t number);
/* "chi-square 249.1 of 222 observations less what was fitted: 1.12 each, where noise alone leaves
 * 1", as the text of a page. Does not fail. */
void um_compare_page_put_chi2(struct um_page *page, const char *of, double chi2, double dof);

#endif
