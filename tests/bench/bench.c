/* Clocks, medians, table and JSON of the benchmarks. */
#include "tests/bench/bench.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* Running processes, mean of the last minute (/proc/loadavg); NaN where the system has none. */
static double load_average(void)
{
  double load = NAN;
  FILE *file = fopen("/proc/loadavg", "r");
  if (file == NULL) return load;
  if (fscanf(file, "%lf", &load) != 1) load = NAN;
  fclose(file);
  return load;
}

void bench_begin(struct bench *bench, int argc, char **argv, const char *title)
{
  *bench = (struct bench){.json = argc > 1 ? argv[1] : NULL};
  if (um_core_context_create(NULL, &bench->context) != UM_OK) exit(1);
  um_core_context_set_threads(bench->context, 1);
  printf("%s\n", title);
  bench->processors = (int)sysconf(_SC_NPROCESSORS_ONLN);
  bench_number(bench, "processors", "1", bench->processors, NAN, NAN);
  bench_number(bench, "load average before", "1", load_average(), NAN, NAN);
}

void bench_must(const struct bench *bench, enum um_status status)
{
  if (status == UM_OK) return;
  fprintf(stderr, "bench: %s: %s\n", um_core_status_text(status), um_core_message(bench->context));
  exit(1);
}

void bench_folder(char path[BENCH_FOLDER])
{
  const char *base = getenv("TMPDIR");
  int length =
      snprintf(path, BENCH_FOLDER, "%s/umbra-bench-XXXXXX", base != NULL ? base : P_tmpdir);
  if (length < BENCH_FOLDER && mkdtemp(path) != NULL) return;
  fprintf(stderr, "no folder below %s\n", base != NULL ? base : P_tmpdir);
  exit(1);
}

void *bench_allocate(const struct bench *bench, size_t count, size_t size)
{
  void *block = NULL;
  bench_must(bench, um_core_allocate(bench->context, count, size, (void *)&block));
  return block;
}

static double seconds(clockid_t clock)
{
  struct timespec t;
  clock_gettime(clock, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double bench_wall(void) { return seconds(CLOCK_MONOTONIC); }
double bench_cpu(void) { return seconds(CLOCK_THREAD_CPUTIME_ID); }

void bench_add(struct bench_series *series, double value)
{
  if (series->n < BENCH_RUNS) series->value[series->n++] = value;
}

static int compare(const void *pa, const void *pb)
{
  double a = *(const double *)pa, b = *(const double *)pb;
  return (a > b) - (a < b);
}

double bench_median(const struct bench_series *series)
{
  struct bench_series sorted = *series;
  size_t n = sorted.n;
  if (n == 0) return NAN;
  qsort(sorted.value, n, sizeof sorted.value[0], compare);
  return 0.5 * (sorted.value[(n - 1) / 2] + sorted.value[n / 2]);
}

static double spread(const struct bench_series *series)
{
  if (series->n < 2) return NAN;
  double low = series->value[0], high = low;
  for (size_t i = 1; i < series->n; i++) {
    low = fmin(low, series->value[i]);
    high = fmax(high, series->value[i]);
  }
  return (high - low) / bench_median(series);
}

static struct bench_figure *next_figure(struct bench *bench, const char *name, const char *unit)
{
  if (bench->n == BENCH_FIGURES) {
    fprintf(stderr, "bench: more than %d figures\n", BENCH_FIGURES);
    exit(1);
  }
  struct bench_figure *figure = &bench->figure[bench->n++];
  snprintf(figure->name, sizeof figure->name, "%s", name);
  figure->unit = unit;
  figure->runs = 1;
  figure->spread = NAN;
  return figure;
}

void bench_number(struct bench *bench, const char *name, const char *unit, double value,
                  double reference, double goal)
{
  struct bench_figure *figure = next_figure(bench, name, unit);
  figure->value = value;
  figure->reference = reference;
  figure->goal = goal;
}

void bench_time(struct bench *bench, const char *name, const char *unit,
                const struct bench_series *series, const struct bench_series *reference,
                double goal)
{
  struct bench_figure *figure = next_figure(bench, name, unit);
  figure->value = bench_median(series);
  figure->reference = reference == NULL ? NAN : bench_median(reference);
  figure->goal = goal;
  figure->runs = series->n;
  figure->spread = spread(series);
}

static bool is_met(const struct bench_figure *f) { return f->value / f->reference <= f->goal; }

/* A number, or `none` where there is none. */
static const char *number(double value, const char *format, const char *none, char text[32])
{
  if (isfinite(value))
    snprintf(text, 32, format, value);
  else
    snprintf(text, 32, "%s", none);
  return text;
}

static void table_print(const struct bench *bench)
{
  char a[32], b[32], c[32], d[32], e[32];
  printf("%-54s %11s %-6s %11s %8s %7s %4s %5s %7s\n", "figure", "value", "unit", "reference",
         "ratio", "goal", "met", "runs", "spread");
  for (size_t i = 0; i < bench->n; i++) {
    const struct bench_figure *f = &bench->figure[i];
    printf("%-54s %11s %-6s %11s %8s %7s %4s %5zu %7s\n", f->name, number(f->value, "%.4g", "-", a),
           f->unit, number(f->reference, "%.4g", "", b),
           number(f->value / f->reference, "%.3g", "", c), number(f->goal, "%.3g", "", d),
           isnan(f->goal) ? "" : (is_met(f) ? "yes" : "no"), f->runs,
           number(100.0 * f->spread, "%.0f %%", "", e));
  }
}

static void json_write(const struct bench *bench, FILE *file)
{
  char a[32], b[32], c[32], d[32];
  fputs("[\n", file);
  for (size_t i = 0; i < bench->n; i++) {
    const struct bench_figure *f = &bench->figure[i];
    fprintf(file,
            "  {\"name\": \"%s\", \"value\": %s, \"unit\": \"%s\", \"reference\": %s, "
            "\"ratio\": %s, \"goal\": %s, \"met\": %s}%s\n",
            f->name, number(f->value, "%.6g", "null", a), f->unit,
            number(f->reference, "%.6g", "null", b),
            number(f->value / f->reference, "%.6g", "null", c), number(f->goal, "%.6g", "null", d),
            isnan(f->goal) ? "null" : (is_met(f) ? "true" : "false"), i + 1 < bench->n ? "," : "");
  }
  fputs("]\n", file);
}

int bench_end(struct bench *bench)
{
  bench_number(bench, "load average after", "1", load_average(), NAN, NAN);
  table_print(bench);
  um_core_context_destroy(&bench->context);
  if (bench->json == NULL) return 0;
  FILE *file = fopen(bench->json, "w");
  if (file == NULL) {
    fprintf(stderr, "bench: cannot write %s\n", bench->json);
    return 1;
  }
  json_write(bench, file);
  bool written = ferror(file) == 0;
  written = fclose(file) == 0 && written;
  if (!written) fprintf(stderr, "bench: cannot write %s\n", bench->json);
  return written ? 0 : 1;
}
