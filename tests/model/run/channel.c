/* One quantity of a reference beside ours: see channel.h. */
#include "channel.h"

#include <math.h>
#include <stdlib.h>

struct channel channel_new(size_t rows)
{
  struct channel c = {NULL, NULL, 0, rows};
  c.expected = calloc(2 * rows + 1, sizeof *c.expected);
  assert_non_null(c.expected);
  c.value = c.expected + rows;
  return c;
}

void channel_add(struct channel *c, double expected, double value)
{
  assert_true(c->n < c->room);
  c->expected[c->n] = expected;
  c->value[c->n++] = value;
}

bool channel_close(struct channel *c, const char *what, const char *unit, struct accept accept)
{
  double peak = 0.0, worst = 0.0, squares = 0.0, ratio = 0.0;
  bool accepted = true;
  assert_true(c->n >= 20);
  for (size_t i = 0; i < c->n; i++) peak = fmax(peak, fabs(c->expected[i]));
  for (size_t i = 0; i < c->n; i++) {
    double scale = 1.0, limit = accept.absolute;
    if (accept.relative > 0.0) {
      scale = fmax(fabs(c->expected[i]), accept.least);
      limit = scale > 0.0 ? accept.relative * scale : accept.absolute * peak;
    }
    double difference = fabs(c->value[i] - c->expected[i]);
    if (!(difference <= limit)) {
      accepted = false;
      print_message("  NOT ACCEPTED %s row %zu: %.9g, expected %.9g\n", what, i, c->value[i],
                    c->expected[i]);
    }
    double shown = scale > 0.0 ? difference / scale : 0.0;
    if (limit > 0.0) ratio = fmax(ratio, difference / limit);
    worst = fmax(worst, shown);
    squares += shown * shown;
  }
  print_message("  %-30s %4zu rows, peak %9.4g, max %.1e rms %.1e %-3s %3.0f %% of accepted\n",
                what, c->n, peak, worst, sqrt(squares / (double)c->n), unit, 100.0 * ratio);
  free(c->expected);
  *c = (struct channel){0};
  return accepted;
}
