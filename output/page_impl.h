/* What the sections of a run's page share. Private to output/. */
#ifndef UMBRA_OUTPUT_PAGE_IMPL_H
#define UMBRA_OUTPUT_PAGE_IMPL_H

#include "base/page/writer.h"
#include "output/output.h"

struct um_output_page {
  struct um_page_writer *w; /* its times are the observations' */
  struct um_page *page;     /* the writer's */
  const struct um_output_run *run;
};
/* [nobs] zeros, owned by the page. */
enum um_status um_output_page_column(struct um_output_page *p, double **out);

/* The sections, each of what it has something to show of. */
enum um_status um_output_page_light(struct um_output_page *p);
enum um_status um_output_page_split(struct um_output_page *p); /* by mechanism and by material */
enum um_status um_output_page_counts(struct um_output_page *p);
enum um_status um_output_page_temperatures(struct um_output_page *p);
enum um_status um_output_page_heat(struct um_output_page *p);
enum um_status um_output_page_sky(struct um_output_page *p);
enum um_status um_output_page_scene(struct um_output_page *p);

#endif
