/* A matrix of sensitivities as tables for a person. */
#include "app/sensitivity.h"

void um_app_sensitivity_print(const struct um_sensitivity_matrix *m, const char *folder)
{
  for (size_t i = 0; i < m->nrow; i++) {
    const struct um_sensitivity_row *r = &m->row[i];
    printf("%-50s %-8s %10.3g %9.2e %10.3g", r->name, um_sensitivity_way_name(r->quality.way),
           r->quality.step, r->quality.error, r->quality.reach);
    for (size_t c = 0; c < m->ncurve && c < 2; c++)
      printf(" %9.3g", um_sensitivity_matrix_strength(m, r, c, r->width));
    printf("  %s\n", r->why == NULL ? "" : r->why);
  }
  printf("%.2f s, run %.2f s\nresults in %s\n", m->seconds, m->seconds_run, folder);
}
