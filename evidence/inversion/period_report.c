/* The period of every light curve of a set. */
#include "evidence/inversion/period_report.h"

#include <stdint.h>
#include <string.h>

#include "base/core/suggestions.h"
#include "evidence/inversion/fold.h"

static enum um_status search(struct um_context *context, const struct um_compare_measurements *m,
                             size_t channel, const struct um_compare_period_options *options,
                             struct um_compare_period_entry *out)
{
  enum um_status status;
  struct um_compare_series *series = NULL;
  out->channel = channel;
  UM_CHECK(um_compare_series_create(context, m, channel, SIZE_MAX, &series));
  status = um_compare_period_search(context, series, options, &out->period);
  if (status == UM_ERR_INPUT)
    um_core_message_prefix(context, "%s: %s %s", m->path,
                           um_compare_quantity_name(m->channel[channel].quantity),
                           m->channel[channel].of);
  if (status != UM_OK) goto done;
  UM_CHECK(um_compare_fold(context, series, out->period, UM_COMPARE_FOLD_BINS, out->bin));
done:
  um_compare_series_destroy(context, &series);
  return status;
}

static enum um_status refuse_band(struct um_context *context,
                                  const struct um_compare_measurements *m, const char *of)
{
  char accepted[320] = "", hint[UM_CORE_WORDS_HINT] = "";
  struct um_core_words_guess guess = {.written = of == NULL ? "" : of};
  for (size_t c = 0; c < m->nchannel; c++) {
    if (m->channel[c].quantity == UM_QUANTITY_TEMPERATURE) continue;
    um_core_words_append(accepted, sizeof accepted, m->channel[c].of);
    um_core_words_consider(&guess, m->channel[c].of);
  }
  return um_core_fail(
      context, UM_ERR_INPUT, "%s: no light curve%s%s%s; accepted: %s", m->path,
      of == NULL ? "" : " of ", of == NULL ? "" : of, um_core_words_hint(&guess, hint),
      accepted[0] == '\0' ? "observations of another quantity than temperature" : accepted);
}

enum um_status um_compare_period_report_create(struct um_context *context,
                                               const struct um_compare_measurements *measurements,
                                               const char *of,
                                               const struct um_compare_period_options *options,
                                               struct um_compare_period_report **out)
{
  enum um_status status;
  struct um_compare_period_report *r = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *r, &r));
  r->measurements = measurements;
  UM_CHECK(um_core_allocate(context, measurements->nchannel, sizeof *r->entry, &r->entry));
  for (size_t c = 0; c < measurements->nchannel; c++) {
    const struct um_compare_channel *channel = &measurements->channel[c];
    if (channel->quantity == UM_QUANTITY_TEMPERATURE) continue;
    if (of != NULL && strcmp(of, channel->of) != 0) continue;
    UM_CHECK(search(context, measurements, c, options, &r->entry[r->count++]));
  }
  if (r->count == 0) {
    status = refuse_band(context, measurements, of);
    goto done;
  }
  *out = r;
  r = NULL;
done:
  um_compare_period_report_destroy(context, &r);
  return status;
}

void um_compare_period_report_destroy(struct um_context *context,
                                      struct um_compare_period_report **report)
{
  if (report == NULL || *report == NULL) return;
  for (size_t i = 0; i < (*report)->count; i++)
    um_compare_period_destroy(context, &(*report)->entry[i].period);
  UM_FREE(context, (*report)->entry, *report);
  *report = NULL;
}
