/* What is known of fitted parameters together, as a table for a person. */
#include "evidence/diagnosis/report/text.h"

#include <math.h>
#include <string.h>

#include "base/uncertainty/posterior.h"
#include "evidence/diagnosis/value_text.h"

/* "0.8440 (0.8338 .. 0.8541, 95 % 0.8241 .. 0.8640)" of quantiles. */
static void print_interval(FILE *file, const double q[UM_DIAGNOSIS_QUANTILES])
{
  fprintf(file, "%.5g (%.5g .. %.5g, 95 %% %.5g .. %.5g)", q[2], q[1], q[3], q[0], q[4]);
}

/* The parameter, and under it the whole that the scenario states. */
static void print_parameter(FILE *file, const struct um_diagnosis *d, size_t k)
{
  const struct um_diagnosis_posterior *p = d->posterior;
  const struct um_diagnosis_fitted *f = &d->fitted[k];
  const struct um_effect_parameter *of = &f->effect->parameters[f->parameter];
  bool plain = strcmp(of->unit, "1") == 0, stated = true;
  double q[UM_DIAGNOSIS_QUANTILES], w[UM_DIAGNOSIS_QUANTILES];
  struct um_diagnosis_whole whole = {0};
  char name[160];
  for (size_t i = 0; i < UM_DIAGNOSIS_QUANTILES; i++) {
    q[i] = p->quantile[i * p->nfitted + k];
    stated = stated && um_diagnosis_whole_find(d->forward, f->effect, f->target, f->parameter, q[i],
                                               NAN, &whole);
    w[i] = whole.value;
  }
  um_diagnosis_fitted_text(f, name);
  fprintf(file, "  %-36s ", name);
  print_interval(file, q);
  fprintf(file, "%s%s\n", plain ? "" : " ", plain ? "" : of->unit);
  if (!stated) return;
  for (size_t i = 0; w[0] > w[UM_DIAGNOSIS_QUANTILES - 1] && i < UM_DIAGNOSIS_QUANTILES / 2; i++) {
    double other = w[UM_DIAGNOSIS_QUANTILES - 1 - i]; /* it falls as its parameter rises */
    w[UM_DIAGNOSIS_QUANTILES - 1 - i] = w[i];
    w[i] = other;
  }
  plain = strcmp(whole.unit, "1") == 0;
  fprintf(file, "    %-34.80s ", whole.what);
  print_interval(file, w);
  fprintf(file, " instead of %.4g%s%s\n", whole.instead_of, plain ? "" : " ",
          plain ? "" : whole.unit);
}

void um_diagnosis_report_write_text_posterior(const struct um_diagnosis *d, FILE *file)
{
  const struct um_diagnosis_posterior *p = d->posterior;
  char words[640];
  for (size_t i = 0; i < d->ntie; i++) {
    um_diagnosis_tie_text(d->fitted, &d->tie[i], words);
    fprintf(file, "%s%s.\n", i == 0 ? "\n" : "", words);
  }
  if (p == NULL) return;
  fprintf(file, "\nposterior: %zu draws, effective number %.0f", p->n, p->effective);
  if (!p->sound) {
    fprintf(file, ": too few to state intervals%s; ask for more by --draws, or fit fewer effects\n",
            p->tail > UM_UNCERTAINTY_TAIL_MOST ? ", since a few of them weigh too much" : "");
    return;
  }
  fprintf(file, "; median, 68 and 95 %%\n");
  for (size_t k = 0; k < p->nfitted; k++) print_parameter(file, d, k);
}
