/* The axis of time of a diagnosis and the Earth's shadow on it. */
#include "diagnosis/report/plot_frame_impl.h"
#include "orbit/time.h"

#define SHADES  1000     /* instants at which the shadow is looked up */
#define LONGEST 259200.0 /* [s] beyond it single shadows are not to be seen */

struct um_plot_time um_diagnosis_report_plot_time(double first, double last)
{
  char start[32];
  um_orbit_time_format(first, start);
  return um_plot_time(first, last, start);
}

enum um_status um_diagnosis_report_plot_shade(struct um_context *context,
                                              const struct um_diagnosis *d,
                                              const struct um_plot_time *time, struct um_plot *plot)
{
  const struct um_model *model = d->forward->model;
  double t[SHADES], sunlit[SHADES];
  if (model->points || !(time->last - time->first < LONGEST)) return UM_OK;
  for (size_t i = 0; i < SHADES; i++) {
    struct um_environment_sample sample;
    t[i] = time->first + (time->last - time->first) * (double)i / (SHADES - 1);
    enum um_status status = um_model_sample_at(context, model, t[i], &sample);
    if (status == UM_ERR_INPUT) { /* an orbit that ends with the measurements */
      um_core_message_clear(context);
      sample.sunlit_fraction = 1.0;
    } else {
      UM_TRY(status);
    }
    sunlit[i] = sample.sunlit_fraction;
  }
  um_plot_shade(plot, time, SHADES, t, sunlit);
  return UM_OK;
}
