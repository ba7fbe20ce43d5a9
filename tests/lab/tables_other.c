/* Of complete models, two effects at once, pairs and heat. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/lab/lab.h"

static double share(size_t part, size_t of) { return of == 0 ? NAN : (double)part / (double)of; }

static void of_complete(const struct lab_case *cases, size_t count, const struct lab_row *row,
                        size_t nrow, struct lab_figures *figures)
{
  size_t n = 0, accused = 0, other = 0;
  double chi2 = 0.0;
  for (size_t i = 0; i < count; i++) {
    const struct lab_row *r;
    if (strcmp(cases[i].part, "complete") != 0) continue;
    if ((r = lab_journal_find(row, nrow, &cases[i])) == NULL) continue;
    bool is_accused = strcmp(r->first, "-") != 0;
    n++;
    accused += is_accused;
    other += !is_accused && strcmp(r->verdict, "complete") != 0;
    chi2 += r->chi2_before;
    if (is_accused || strcmp(r->verdict, "complete") != 0)
      printf("complete, %s, seed %llu: %s, named %s\n", r->world, (unsigned long long)r->seed,
             r->verdict, r->first);
  }
  if (n == 0) return;
  lab_figures_add(figures, "complete models", "1", (double)n, NAN, true);
  lab_figures_add(figures, "complete models: mean reduced chi-square", "1", chi2 / (double)n, NAN,
                  true);
  /* nominal 1 %: 10 of 200; of fewer, what is exceeded as rarely */
  lab_figures_add(
      figures, "complete models: accused", "1", (double)accused,
      n >= 200 ? 0.05 * (double)n : ceil(0.01 * (double)n + 3.0 * sqrt(0.01 * (double)n)), false);
  lab_figures_add(figures, "complete models: neither accused nor called complete", "1",
                  (double)other, NAN, true);
}

static void of_two(const struct lab_case *cases, size_t count, const struct lab_row *row,
                   size_t nrow, struct lab_figures *figures)
{
  size_t n = 0, both = 0;
  for (size_t i = 0; i < count; i++) {
    const struct lab_row *r;
    if (strcmp(cases[i].part, "two") != 0) continue;
    if ((r = lab_journal_find(row, nrow, &cases[i])) == NULL) continue;
    if (n++ == 0) printf("\ntwo hidden effects\n");
    bool found = true;
    for (size_t k = 0; k < cases[i].nhidden; k++) {
      char name[LAB_TEXT];
      lab_hidden_name(&cases[i].hidden[k], name, sizeof name);
      found &= lab_list_has(r->found, name);
    }
    both += found;
    printf("%-5s %-52s %s: %s; chi2_red %.2f > %.2f\n", r->world, r->hidden,
           found ? "both found" : "NOT both", r->found, r->chi2_before, r->chi2_after);
  }
  if (n == 0) return;
  lab_figures_add(figures, "two hidden effects: cases", "1", (double)n, NAN, true);
  lab_figures_add(figures, "two hidden effects: both found", "1", share(both, n), 0.8, true);
}

/* Is an effect, on whatever target, in the list? */
static bool has_effect(const char *list, const char *effect)
{
  size_t n = strlen(effect);
  for (const char *at = strstr(list, effect); at != NULL; at = strstr(at + 1, effect))
    if ((at == list || at[-1] == '+') && (at[n] == ':' || at[n] == '+' || at[n] == '\0'))
      return true;
  return false;
}

static void of_pairs(const struct lab_case *cases, size_t count, const struct lab_row *row,
                     size_t nrow, struct lab_figures *figures)
{
  size_t n[2] = {0, 0}, right[2] = {0, 0};
  for (size_t i = 0; i < count; i++) {
    const struct lab_row *r;
    const struct lab_case *c = &cases[i];
    if (strcmp(c->part, "pairs") != 0) continue;
    if ((r = lab_journal_find(row, nrow, c)) == NULL) continue;
    if (n[0] + n[1] == 0) printf("\npairs\n");
    const char *other = lab_pair_partner(c);
    bool with = c->tie_breaker;
    bool named = strcmp(r->first, r->hidden) == 0;
    bool together =
        other != NULL && lab_list_has(r->group, r->hidden) && has_effect(r->group, other);
    bool ok = with ? named && (other == NULL || !has_effect(r->group, other)) : together;
    n[with]++;
    right[with] += ok;
    printf("%-31s %-26s %-4s %s first %s; group %s\n", r->world, r->hidden, ok ? "ok" : "NOT",
           r->verdict, r->first, r->group);
  }
  if (n[0] + n[1] == 0) return;
  lab_figures_add(figures, "pairs without tie-breaker: reported as indistinguishable", "1",
                  share(right[0], n[0]), 1.0, true);
  lab_figures_add(figures, "pairs with tie-breaker: told apart", "1", share(right[1], n[1]), 1.0,
                  true);
}

static void of_pulses(const struct lab_case *cases, size_t count, const struct lab_row *row,
                      size_t nrow, struct lab_figures *figures)
{
  size_t n = 0, called = 0, place = 0, shape = 0, start = 0, energy = 0;
  for (size_t i = 0; i < count; i++) {
    const struct lab_row *r;
    const struct lab_case *c = &cases[i];
    if (strcmp(c->part, "pulse") != 0) continue;
    if ((r = lab_journal_find(row, nrow, c)) == NULL) continue;
    if (n++ == 0) printf("\nheat\n");
    double truth[2] = {NAN, NAN}, found[2] = {NAN, NAN}, sigma[2] = {NAN, NAN};
    sscanf(r->value, "%lf+%lf", &truth[0], &truth[1]);
    sscanf(r->fitted, "%lf+%lf", &found[0], &found[1]);
    sscanf(r->sigma, "%lf+%lf", &sigma[0], &sigma[1]);
    const char *at = strchr(r->found, ':');
    called += strcmp(r->verdict, "unexplained") == 0;
    place += at != NULL && strcmp(at + 1, c->pulse->place) == 0;
    shape += strcmp(r->found, r->hidden) == 0;
    start += fabs(r->start_error_s) <= 3.0 * sigma[1];
    energy += fabs(found[0] - truth[0]) <= 3.0 * sigma[0];
    printf("%-22s %s, %s, start %+.2f +- %.2f s off, energy %.4g +- %.2g of %.4g J\n", r->hidden,
           r->verdict, r->found, r->start_error_s, sigma[1], found[0], sigma[0], truth[0]);
  }
  if (n == 0) return;
  lab_figures_add(figures, "heat: called unexplained", "1", share(called, n), 1.0, true);
  lab_figures_add(figures, "heat: place found", "1", share(place, n), 1.0, true);
  lab_figures_add(figures, "heat: shape found", "1", share(shape, n), 0.9, true);
  lab_figures_add(figures, "heat: start within three sigma", "1", share(start, n), 0.95, true);
  lab_figures_add(figures, "heat: energy within three sigma", "1", share(energy, n), 0.95, true);
}

void lab_tables_other(const struct lab_case *cases, size_t count, const struct lab_row *row,
                      size_t nrow, struct lab_figures *figures)
{
  of_complete(cases, count, row, nrow, figures);
  of_two(cases, count, row, nrow, figures);
  of_pairs(cases, count, row, nrow, figures);
  of_pulses(cases, count, row, nrow, figures);
}
