/* dev */
#include "effects/effects.h"
#include "evidence/sensitivity/matrix.h"
#include "evidence/sensitivity/own.h"
#include "model/build/build.h"
#include "tests/support/cmocka_all.h"
#include "evidence/sensitivity/forward_impl.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/core/context.h"

static struct um_context *context;
static void ok(enum um_status s) { if (s != UM_OK) { printf("FAIL %s\n", um_core_message(context)); exit(1);} }

int main(int argc, char **argv)
{
  const char *path = argv[1];
  ok(um_core_context_create(NULL, &context));
  const char *only[64]; size_t nonly = 0;
  const char *base_over[64]; size_t nb = 0;
  for (int i = 2; i < argc; i++) if (strchr(argv[i], '=')) base_over[nb++] = argv[i]; else only[nonly++] = argv[i];
  struct um_model_options o = {.overrides = base_over, .noverride = nb};
  struct um_model *model; ok(um_model_create(context, path, &o, &model));
  struct um_compare_measurements *set; ok(um_sensitivity_own_create(context, model, &set));
  struct um_sensitivity_forward *f, *t;
  ok(um_sensitivity_forward_create_near(context, path, &o, set, (struct um_variant_tolerance){atof(getenv("FACTOR")), atof(getenv("PER"))}, &f));
  struct um_sensitivity_matrix *m;
  struct um_sensitivity_candidates_options which = {.only = only, .nonly = nonly};
  ok(um_sensitivity_matrix_create(context, f, true, &which, &m));
  double noise; ok(um_sensitivity_forward_noise(context, f, &noise)); printf("noise %g\n", noise); printf("matrix %.2f s run %.2f; %zu batches, %zu sens, heat runs %zu, evals %zu\n", m->seconds, m->seconds_run, f->heat_batches, f->heat_sensitivities, f->heat_runs, f->evaluations);
  const char *over[64]; memcpy(over, base_over, sizeof over);
  over[nb] = "thermal.accuracy_K=1e-5";
  struct um_model_options tight = {.overrides = over, .noverride = nb + 1};
  ok(um_sensitivity_forward_create_near(context, path, &tight, set, (struct um_variant_tolerance){1.0, 1e-7}, &t));
  size_t n = f->observations.count;
  double *v[4];
  for (int i = 0; i < 4; i++) v[i] = malloc(n * sizeof(double));
  for (size_t i = 0; i < m->nrow; i++) {
    struct um_sensitivity_row *r = &m->row[i];
    if (r->column == NULL || r->parameter == SIZE_MAX) continue;
    const struct um_sensitivity_candidate *c = r->candidate;
    double top = fmin(0.5 * r->width, 0.3 * r->quality.reach);
    double room = fmax(r->maximum - r->null_value, r->null_value - r->minimum);
    if (top > room) top = room;
    if (getenv("STEP")) top = atof(getenv("STEP"));
    double *base = malloc(n * sizeof(double)); ok(um_sensitivity_forward_evaluate(context, t, NULL, 0, base));
    double *col = malloc(m->ncurve * m->ntime * sizeof(double)), *ref = malloc(m->ncurve * m->ntime * sizeof(double)), *ref1 = malloc(m->ncurve * m->ntime * sizeof(double));
    double *R[8]; int nr = 0; double *D[8]; int nd = 0;
    for (int k = 0; k < 5; k++) {
      double h = top / pow(4, k);
      bool one = r->null_value - h < r->minimum || r->null_value + h > r->maximum;
      double sg = r->null_value + h > r->maximum ? -1 : 1;
      double offs[2] = {sg * h, one ? sg * h / 2 : -sg * h};
      bool bad = false;
      for (int q = 0; q < 2 && !bad; q++) {
        struct um_model_addition a = {.effect = c->effect, .target = c->target};
        memcpy(a.value, c->null_value, sizeof a.value);
        a.value[r->parameter] += offs[q];
        if (um_sensitivity_forward_evaluate(context, t, &a, 1, v[q]) != UM_OK) { um_core_message_clear(context); bad = true; }
      }
      if (bad) continue;
      D[nd] = malloc(n * sizeof(double));
      for (size_t j = 0; j < n; j++) D[nd][j] = one ? (4 * v[1][j] - v[0][j] - 3 * base[j]) / offs[0] : (v[0][j] - v[1][j]) / (2 * offs[0]);
      nd++;
    }
    if (nd < 3) { printf("%s: no reference\n", r->name); continue; }
    for (int k = 0; k + 1 < nd; k++) { R[nr] = malloc(n * sizeof(double)); for (size_t j = 0; j < n; j++) R[nr][j] = (16 * D[k+1][j] - D[k][j]) / 15; nr++; }
    double *r1 = malloc(n * sizeof(double)), *r2 = malloc(n * sizeof(double));
    for (int g = 0; g < 3; g++) {
      double best = INFINITY; int bk = 0;
      for (int k = 0; k + 1 < nr; k++) { double d = 0; for (size_t j = 0; j < n; j++) { size_t q = m->curve_of[f->observations.channel[j]]; size_t gg = q < m->nlight ? q : 2; if (gg > 2) gg = 1; if ((int)gg == g) d = fmax(d, fabs(R[k][j]-R[k+1][j])); } if (d < best) best = d, bk = k; }
      for (size_t j = 0; j < n; j++) { size_t q = m->curve_of[f->observations.channel[j]]; size_t gg = q < m->nlight ? q : 2; if (gg > 2) gg = 1; if ((int)gg == g) { r1[j] = R[bk][j]; r2[j] = R[bk+1][j]; } }
    }
    um_sensitivity_matrix_spread(m, r1, ref);
    um_sensitivity_matrix_spread(m, r2, ref1);
    printf("%-44s %-8s est %8.1e", r->name, um_sensitivity_way_name(r->quality.way), r->quality.error);
    double most_s = 0, ms[3] = {0}, es[3] = {0}, us[3]={0};
    for (size_t q = 0; q < m->ncurve; q++) { size_t g = q < m->nlight ? q : 2; if (g > 2) g = 1;
      for (size_t k = 0; k < m->ntime; k++) { size_t at = q * m->ntime + k; if (isnan(ref[at])) continue;
        ms[g] = fmax(ms[g], fabs(ref[at])); es[g] = fmax(es[g], fabs(r->column[at] - ref[at])); us[g] = fmax(us[g], fabs(ref1[at]-ref[at])); } }
    (void)most_s;
    double overall = 0, overallu = 0, wh = 0;
    for (size_t q = 0; q < m->ncurve; q++) for (size_t k = 0; k < m->ntime; k++) { size_t at = q * m->ntime + k; if (isnan(ref[at]) || !(m->curve[q].size > 0)) continue;
      overall = fmax(overall, fabs(r->column[at] - ref[at]) / m->curve[q].size); overallu = fmax(overallu, fabs(ref1[at] - ref[at]) / m->curve[q].size); wh = fmax(wh, fabs(ref[at]) / m->curve[q].size); }
    printf(" all %8.1e (%7.0e)%s", overall / wh, overallu / wh, overall / wh > 1e-3 ? "!!!" : "");
    double strength[3] = {0};
    for (size_t q = 0; q < m->ncurve; q++) { size_t g = q < m->nlight ? q : 2; if (g > 2) g = 1; strength[g] = fmax(strength[g], um_sensitivity_matrix_strength(m, r, q, r->width)); }
    double ss = fmax(strength[0], fmax(strength[1], strength[2]));
    double worst = 0;
    for (int g = 0; g < 3; g++) { if (strength[g] >= 1e-2 * ss) worst = fmax(worst, es[g]/ms[g]);
      printf(" | %8.1e (%7.0e)%s", ms[g] > 0 ? es[g] / ms[g] : 0, ms[g] > 0 ? us[g] / ms[g] : 0, strength[g] >= 1e-2*ss ? "" : "-"); }
    printf("  %s  %s\n", worst > 1e-3 ? "***" : "", r->why ? r->why : "");
    fflush(stdout);
    free(base); free(col); free(ref); free(ref1); free(r1); free(r2); for (int k = 0; k < nr; k++) free(R[k]); for (int k = 0; k < nd; k++) free(D[k]);
  }
  return 0;
}
