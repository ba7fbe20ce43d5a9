/* Of hidden effects: which was named, and how well its value was found. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "effects/effects.h"
#include "tests/lab/lab.h"

#define NAMES 12

/* Counts of the rows of one hidden effect in one world. */
struct tally {
  size_t rows, separable, right, in_group, missed, errors;
  size_t valued, sign, within, fit, noise; /* of separable cases that were named right */
  double chi2_before, chi2_after, rms_before, rms_after; /* sums, of those too */
  double worst;                                          /* largest |value - truth| / sigma */
  struct {
    char name[96];
    size_t count;
  } other[NAMES];
  size_t nother;
};

bool lab_list_has(const char *list, const char *name)
{
  size_t n = strlen(name);
  for (const char *at = list; *at != '\0';) {
    size_t length = strcspn(at, "+");
    /* signs of places, "bus.+x", do not part a list: a name begins with a letter */
    while (at[length] == '+' && (length == 0 || at[length - 1] == '.'))
      length += 1 + strcspn(at + length + 1, "+");
    if (length == n && strncmp(at, name, n) == 0) return true;
    at += length + (at[length] == '+' ? 1 : 0);
  }
  return false;
}

bool lab_row_is_separable(const struct lab_row *row)
{
  return strcmp(row->first, "-") != 0 && strcmp(row->group, row->first) == 0;
}

void lab_row_value(const struct lab_row *row, const struct lab_case *c, size_t i, bool *sign,
                   double *deviation)
{
  const struct um_effect *effect = um_effects_find(c->hidden[i].effect);
  double null_value = effect->parameters[c->hidden[i].parameter].null_value;
  const char *fitted = row->fitted, *sigma = row->sigma;
  for (size_t k = 0; k < i; k++) {
    fitted += strcspn(fitted, "+") + (fitted[strcspn(fitted, "+")] == '+' ? 1 : 0);
    sigma += strcspn(sigma, "+") + (sigma[strcspn(sigma, "+")] == '+' ? 1 : 0);
  }
  char *end;
  double value = strtod(fitted, &end);
  if (end == fitted) value = NAN;
  double s = strtod(sigma, &end);
  if (end == sigma) s = NAN;
  *sign = (value - null_value) * (c->hidden[i].value - null_value) > 0.0;
  *deviation = (value - c->hidden[i].value) / s;
}

static void count_other(struct tally *t, const char *name)
{
  size_t i = 0;
  while (i < t->nother && strcmp(t->other[i].name, name) != 0) i++;
  if (i == NAMES) return;
  if (i == t->nother) snprintf(t->other[t->nother++].name, sizeof t->other[i].name, "%s", name);
  t->other[i].count++;
}

static void count_row(struct tally *t, const struct lab_row *row, const struct lab_case *c)
{
  bool separable = lab_row_is_separable(row), right = strcmp(row->first, row->hidden) == 0;
  t->rows++;
  t->errors += strcmp(row->verdict, "error") == 0;
  t->missed += strcmp(row->first, "-") == 0;
  if (!right) count_other(t, row->first);
  if (!separable) {
    t->in_group += lab_list_has(row->group, row->hidden);
    return;
  }
  t->separable++;
  if (!right) return;
  t->right++;
  t->chi2_before += row->chi2_before;
  t->chi2_after += row->chi2_after;
  t->rms_before += row->rms_before;
  t->rms_after += row->rms_after;
  t->fit += row->chi2_after >= 0.8 && row->chi2_after <= 1.25;
  t->noise += row->rms_after <= 1.5;
  if (c->nhidden == 0) return;
  bool sign;
  double deviation;
  lab_row_value(row, c, 0, &sign, &deviation);
  t->valued++;
  t->sign += sign;
  t->within += sign && fabs(deviation) <= 3.0;
  if (!(fabs(deviation) <= t->worst)) t->worst = fabs(deviation);
}

static void add_tally(struct tally *to, const struct tally *t)
{
  to->rows += t->rows;
  to->separable += t->separable;
  to->right += t->right;
  to->in_group += t->in_group;
  to->missed += t->missed;
  to->errors += t->errors;
  to->valued += t->valued;
  to->sign += t->sign;
  to->within += t->within;
  to->fit += t->fit;
  to->noise += t->noise;
}

static void print_header(void)
{
  printf("\n%-16s %-28s %3s %4s %5s %6s %6s %4s %4s %5s %17s %16s\n", "world", "hidden", "n",
         "miss", "separ", "first", "group", "sign", "3sig", "worst", "chi2_red", "worst rms");
}

static void print_tally(const char *world, const char *hidden, const struct tally *t)
{
  double n = (double)t->right;
  printf("%-16s %-28s %3zu %4zu %5zu %6zu %6zu", world, hidden, t->rows, t->missed, t->separable,
         t->right, t->in_group);
  if (t->right > 0)
    printf(" %4zu %4zu %5.1f %9.2f > %-5.2f %8.2f > %-5.2f", t->sign, t->within, t->worst,
           t->chi2_before / n, t->chi2_after / n, t->rms_before / n, t->rms_after / n);
  for (size_t i = 0; i < t->nother; i++)
    printf("%s%s %zux", i == 0 ? "  named: " : ", ", t->other[i].name, t->other[i].count);
  printf("\n");
}

static double share(size_t part, size_t of) { return of == 0 ? NAN : (double)part / (double)of; }

static void add_figures(const struct tally *t, struct lab_figures *figures)
{
  lab_figures_add(figures, "hidden effects: cases", "1", (double)t->rows, NAN, true);
  lab_figures_add(figures, "hidden effects: not detected", "1", (double)t->missed, NAN, true);
  lab_figures_add(figures, "hidden effects: failed", "1", (double)t->errors, 0.0, false);
  lab_figures_add(figures, "hidden effects: called separable", "1", (double)t->separable, NAN,
                  true);
  lab_figures_add(figures, "of these the true effect named first", "1",
                  share(t->right, t->separable), 0.95, true);
  lab_figures_add(figures, "of these sign right", "1", share(t->sign, t->valued), 0.95, true);
  lab_figures_add(figures, "of these value within three sigma too", "1",
                  share(t->within, t->valued), 0.95, true);
  lab_figures_add(figures, "of these reduced chi-square 0.8 to 1.25 afterwards", "1",
                  share(t->fit, t->right), 0.95, true);
  lab_figures_add(figures, "of these worst rms of a channel at most 1.5 sigma afterwards", "1",
                  share(t->noise, t->right), 0.95, true);
  lab_figures_add(figures, "not separable: the true effect is in the group", "1",
                  share(t->in_group, t->rows - t->separable - t->missed), 0.95, true);
}

void lab_tables_effects(const struct lab_case *cases, size_t count, const struct lab_row *row,
                        size_t nrow, struct lab_figures *figures)
{
  struct tally all = {0};
  char last[LAB_TEXT * 2] = "", hidden[LAB_TEXT] = "";
  struct tally one = {0};
  const char *world = "";
  for (size_t i = 0; i <= count; i++) {
    const struct lab_case *c = &cases[i];
    const struct lab_row *r = NULL;
    char key[LAB_TEXT * 2] = "";
    if (i < count && strcmp(c->part, "effects") != 0 && strcmp(c->part, "switches") != 0) continue;
    if (i < count) {
      if ((r = lab_journal_find(row, nrow, c)) == NULL) continue;
      snprintf(key, sizeof key, "%s %s", r->world, r->hidden);
    }
    if (last[0] == '\0' && r != NULL) print_header();
    if (strcmp(key, last) != 0) {
      if (one.rows > 0) print_tally(world, hidden, &one);
      add_tally(&all, &one);
      one = (struct tally){0};
      memcpy(last, key, sizeof last);
    }
    if (r == NULL) break;
    world = r->world;
    snprintf(hidden, sizeof hidden, "%s", r->hidden);
    count_row(&one, r, c);
  }
  if (all.rows > 0) add_figures(&all, figures);
}
