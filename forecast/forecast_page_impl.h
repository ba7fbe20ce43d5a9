/* Private to forecast/: what the parts of its page share. */
#ifndef UMBRA_FORECAST_PAGE_IMPL_H
#define UMBRA_FORECAST_PAGE_IMPL_H

#include "base/page/writer.h"
#include "forecast/forecast_impl.h"

struct um_forecast_track;

struct um_forecast_page {
  struct um_page_writer *w;
  struct um_page *page; /* the writer's */
  const struct um_forecast *f;
  struct um_forecast_track *track; /* [npass]; of passes that are drawn */
};

/* --- forecast_page_words.c --- */
/* Is it night or twilight at the station when it culminates? */
bool um_forecast_page_dark(const struct um_forecast_pass *pass);
/* "night", "civil twilight". UM_ERR_MEMORY, as those below. */
enum um_status um_forecast_page_sky(struct um_forecast_page *k, const struct um_forecast_pass *pass,
                                    const char **out);
/* "2016-09-21 20:36:59"; empty where t_tai is not known. */
enum um_status um_forecast_page_clock(struct um_forecast_page *k, double t, const char **out);
/* "sunlit", "in the shadow", "dark from 20:31:05, lit from 20:36:58" */
enum um_status um_forecast_page_light(struct um_forecast_page *k,
                                      const struct um_forecast_pass *pass, const char **out);

/* --- forecast_page_curves.c --- */
/* All passes of each station over the days, and curves and path of the best ones. Errors of
 * um_model_variant_create and um_model_sample_seen. */
enum um_status um_forecast_page_curves(struct um_forecast_page *k);

#endif
