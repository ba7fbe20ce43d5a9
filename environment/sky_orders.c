/* Light that is scattered more than once, order by order over a spherical Earth. At heights z and
 * zenith angles chi of the lamp, the mean radiance of light that was scattered n times is
 *
 *   J_n(z, chi) = 1/(4 pi) int int k_s(s) J_(n-1)(z(s), chi(s)) exp(-tau(s)) ds dOmega + ground,
 *
 * along straight lines; for n = 1 the lamp's own light with the phase function of air stands for
 * J_0. Every later order scatters alike to all sides; aerosol, which scatters forward, counts with
 * 1 - w g of its extinction and w (1 - g) of its scattering (similarity: van de Hulst 1980,
 * Multiple Light Scattering, ch. 14). The ground is a Lambert surface of albedo 0.15 (assumed: land
 * without snow). Four orders, the rest as a geometric series. The method: Lenoble 1985, Radiative
 * Transfer in Scattering and Absorbing Atmospheres, ch. 3. */
#include <math.h>

#include "base/core/constants.h"
#include "environment/quadrature_impl.h"
#include "environment/sky_light_impl.h"

#define TOP        100e3 /* of the air [m] */
#define CURVE      1.8   /* of the heights [1] */
#define GROUND     0.15  /* what the ground reflects [1] */
#define ORDERS     4
#define POLAR      16 /* half of it on lines that leave the air, half on those to the ground */
#define AZIMUTHS   6
#define STEPS      14
#define LEAST      1e-60 /* in place of 0 before a logarithm [1] */
#define MOST       0.9   /* ratio of the geometric series [1] */
#define LAMP_ROWS  41
#define LAMP_COLS  177
#define LAMP_SPLIT 80.0 /* [deg] */

#define HEIGHTS UM_SKY_LIGHT_HEIGHTS
#define ANGLES  UM_SKY_LIGHT_ANGLES

const double um_environment_sky_wavelengths[UM_SKY_LIGHT_WAVELENGTHS] = {
    0.30e-6,  0.33e-6,  0.37e-6, 0.42e-6, 0.48e-6, 0.53e-6,
    0.575e-6, 0.605e-6, 0.65e-6, 0.72e-6, 0.88e-6, 1.20e-6};

static const double angle[ANGLES] = {0,   35,  55,  68,  76,  81,  84,  86,  88,  89,  90,  91,
                                     92,  93,  94,  95,  96,  97,  98,  99,  100, 101, 102, 103,
                                     104, 105, 106, 108, 110, 112, 114, 116, 118, 120}; /* [deg] */

static double height_of(int i) { return TOP * pow((double)i / (HEIGHTS - 1), CURVE); }

double um_environment_sky_row(double height)
{
  return (HEIGHTS - 1) * pow(fmin(fmax(height / TOP, 0.0), 1.0), 1.0 / CURVE);
}

double um_environment_sky_col(double zenith_angle)
{
  double a = fmin(zenith_angle / UM_DEG, angle[ANGLES - 1]);
  size_t k = 0;
  while (k + 2 < ANGLES && angle[k + 1] < a) k++;
  return (double)k + (a - angle[k]) / (angle[k + 1] - angle[k]);
}

double um_environment_sky_again(const double table[HEIGHTS][ANGLES], double row, double col)
{
  size_t i = (size_t)fmin(row, HEIGHTS - 2), k = (size_t)fmin(col, ANGLES - 2);
  double x = row - (double)i, y = col - (double)k;
  return (1.0 - x) * ((1.0 - y) * table[i][k] + y * table[i][k + 1]) +
         x * ((1.0 - y) * table[i + 1][k] + y * table[i + 1][k + 1]);
}

/* A step on a line of sight from a node. */
struct step {
  double inside[UM_LIMB_CONSTITUENTS]; /* columns */
  float row, lamp_row;
  double way, r;
};

/* Where a step, or the ground, is met by the lamp: places in both tables. */
struct met {
  float col, lamp_col;
};

struct line {
  double theta, weight; /* zenith angle; solid angle of a full turn of it, over 4 pi */
  int n;
  double length; /* to the ground; 0: none */
  struct step step[STEPS];
  struct met met[ANGLES][AZIMUTHS][STEPS + 1]; /* the last: the ground */
};

struct lines {
  struct line line[HEIGHTS][POLAR];
  double lamp_column[LAMP_ROWS][LAMP_COLS][UM_LIMB_CONSTITUENTS];
  double arrives[LAMP_ROWS][LAMP_COLS];
};

/* What becomes of a wavelength. */
struct work {
  const struct lines *lines;
  double lamp[LAMP_ROWS][LAMP_COLS];               /* irradiance that arrives */
  double glow[HEIGHTS][POLAR][STEPS];              /* scattered to the node of radiance 1 */
  double air[HEIGHTS][POLAR][STEPS];               /* share of air in it */
  double through[HEIGHTS][POLAR];                  /* transmission to the ground */
  double source[HEIGHTS][ANGLES], flux[ANGLES];    /* ln of J and of irradiance on the ground */
  double next[HEIGHTS][ANGLES], next_flux[ANGLES]; /* not ln */
  double sum[HEIGHTS][ANGLES];
};

static double lamp_col(double degrees)
{
  double col = degrees < LAMP_SPLIT ? degrees / 5.0 : 16.0 + (degrees - LAMP_SPLIT) / 0.2;
  return fmin(fmax(col, 0.0), LAMP_COLS - 1.001);
}

static double lamp_angle(double col)
{
  return col < 16.0 ? 5.0 * col : LAMP_SPLIT + 0.2 * (col - 16.0);
}

static double lamp_row(double height)
{
  return fmin((LAMP_ROWS - 1) * sqrt(fmax(height, 0.0) / TOP), LAMP_ROWS - 1.001);
}

static void light_lamp(const struct um_environment_slant *slant, struct lines *w)
{
  for (int i = 0; i < LAMP_ROWS; i++)
    for (int k = 0; k < LAMP_COLS; k++) {
      double x = (double)i / (LAMP_ROWS - 1), dilution = 0.0;
      bool lit = um_environment_slant_sun(slant, TOP * x * x, lamp_angle(k) * UM_DEG,
                                          w->lamp_column[i][k], &dilution);
      w->arrives[i][k] = lit ? dilution : 0.0;
    }
}

static double lamp_at(const struct work *w, double row, double col)
{
  size_t i = (size_t)row, k = (size_t)col;
  double x = row - (double)i, y = col - (double)k;
  return (1.0 - x) * ((1.0 - y) * w->lamp[i][k] + y * w->lamp[i][k + 1]) +
         x * ((1.0 - y) * w->lamp[i + 1][k] + y * w->lamp[i + 1][k + 1]);
}

/* Ends of the steps of a line: dense where it is low. */
static void divide(double radius, double z, struct line *line, double end[STEPS + 1])
{
  double r = radius + z, u = cos(line->theta), across = r * sin(line->theta);
  double top = sqrt(fmax((radius + TOP) * (radius + TOP) - across * across, 0.0));
  double lowest = fmax(-r * u, 0.0);
  line->n = STEPS;
  line->length = 0.0;
  end[0] = 0.0;
  if (u < 0.0 && across < radius) {
    line->length = -r * u - sqrt(radius * radius - across * across);
    for (int k = 1; k <= STEPS; k++) end[k] = line->length * k / STEPS;
    return;
  }
  int down = lowest > 0.0 ? STEPS / 2 : 0;
  for (int k = 1; k <= down; k++) {
    double x = (double)(down - k) / down;
    end[k] = lowest * (1.0 - x * x);
  }
  for (int k = 1; k <= STEPS - down; k++) {
    double x = (double)k / (STEPS - down);
    end[down + k] = lowest + (top - r * u - lowest) * x * x;
  }
}

static struct met meet(double way, double r, double r0, double chi, double direction)
{
  double there = acos(fmin(fmax((r0 * cos(chi) + way * direction) / r, -1.0), 1.0));
  return (struct met){(float)um_environment_sky_col(there), (float)lamp_col(there / UM_DEG)};
}

/* Cosine between a line and the lamp's direction. */
static double between(double theta, double chi, int azimuth)
{
  return cos(theta) * cos(chi) + sin(theta) * sin(chi) * cos(UM_PI * (azimuth + 0.5) / AZIMUTHS);
}

static void lay_line(const struct um_environment_slant *slant, double z, struct line *line)
{
  double end[STEPS + 1], r0 = slant->radius + z, u = cos(line->theta);
  divide(slant->radius, z, line, end);
  for (int k = 0; k < STEPS; k++) {
    struct step *s = &line->step[k];
    s->way = 0.5 * (end[k] + end[k + 1]);
    s->r = sqrt(r0 * r0 + s->way * s->way + 2.0 * r0 * s->way * u);
    double height = fmax(s->r - slant->radius, 0.0);
    s->row = (float)um_environment_sky_row(height);
    s->lamp_row = (float)lamp_row(height);
    for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++)
      s->inside[c] =
          (end[k + 1] - end[k]) *
          um_environment_slant_density(slant, (enum um_environment_limb_constituent)c, height);
  }
  for (int j = 0; j < ANGLES; j++)
    for (int a = 0; a < AZIMUTHS; a++) {
      double chi = angle[j] * UM_DEG, direction = between(line->theta, chi, a);
      for (int k = 0; k < STEPS; k++)
        line->met[j][a][k] = meet(line->step[k].way, line->step[k].r, r0, chi, direction);
      line->met[j][a][STEPS] = meet(line->length, slant->radius, r0, chi, direction);
    }
}

/* theta = horizon (1 - t^2) above it, horizon + (pi - horizon) t^2 below. */
static void lay_lines(const struct um_environment_slant *slant, struct lines *w)
{
  for (int i = 0; i < HEIGHTS; i++)
    for (int p = 0; p < POLAR; p++) {
      struct um_environment_gauss g = um_environment_gauss_8[p % 8];
      double z = height_of(i), horizon = UM_PI - asin(slant->radius / (slant->radius + z));
      double span = p < 8 ? -horizon : UM_PI - horizon;
      struct line *line = &w->line[i][p];
      line->theta = horizon + span * g.x * g.x;
      line->weight = 0.5 * sin(line->theta) * fabs(span) * 2.0 * g.x * g.w;
      lay_line(slant, z, line);
    }
}

/* What a wavelength makes of lines and lamp. */
static void colour(const double depth[UM_LIMB_CONSTITUENTS], struct work *w)
{
  const double kept = 1.0 - UM_SKY_AEROSOL_ALBEDO * UM_SKY_AEROSOL_ASYMMETRY;
  const double aside = UM_SKY_AEROSOL_ALBEDO * (1.0 - UM_SKY_AEROSOL_ASYMMETRY);
  const double extinction[UM_LIMB_CONSTITUENTS] = {depth[0], depth[1], depth[2] * kept,
                                                   depth[3] * kept};
  const double scatter[UM_LIMB_CONSTITUENTS] = {depth[0], 0.0, depth[2] * aside, depth[3] * aside};
  for (int i = 0; i < LAMP_ROWS; i++)
    for (int k = 0; k < LAMP_COLS; k++) {
      double tau = 0.0;
      for (int c = 0; c < UM_LIMB_CONSTITUENTS && w->lines->arrives[i][k] > 0.0; c++)
        tau += extinction[c] * w->lines->lamp_column[i][k][c];
      w->lamp[i][k] = w->lines->arrives[i][k] * exp(-tau);
    }
  for (int i = 0; i < HEIGHTS; i++)
    for (int p = 0; p < POLAR; p++) {
      double tau = 0.0;
      for (int k = 0; k < STEPS; k++) {
        const struct step *s = &w->lines->line[i][p].step[k];
        double own = 0.0, glow = 0.0;
        for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) own += extinction[c] * s->inside[c];
        for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) glow += scatter[c] * s->inside[c];
        double fade = own > 1e-6 ? -expm1(-own) / own : 1.0;
        w->glow[i][p][k] = glow * exp(-tau) * fade;
        w->air[i][p][k] = glow > 0.0 ? scatter[UM_LIMB_AIR] * s->inside[UM_LIMB_AIR] / glow : 0.0;
        tau += own;
      }
      w->through[i][p] = exp(-tau);
    }
}

/* Radiance that arrives at a node along a line, of light scattered first or once more. */
static double arriving(const struct work *w, int i, int p, int j, int a, bool first)
{
  const struct line *line = &w->lines->line[i][p];
  double sum = 0.0, phase = 0.0, even = 0.25 / UM_PI;
  if (first) phase = um_environment_sky_rayleigh(between(line->theta, angle[j] * UM_DEG, a));
  for (int k = 0; k < STEPS; k++) {
    struct met met = line->met[j][a][k];
    double air = w->air[i][p][k];
    sum += w->glow[i][p][k] *
           (first ? (air * phase + (1.0 - air) * even) *
                        lamp_at(w, (double)line->step[k].lamp_row, (double)met.lamp_col)
                  : exp(um_environment_sky_again(w->source, (double)line->step[k].row,
                                                 (double)met.col)));
  }
  if (!(line->length > 0.0)) return sum;
  struct met met = line->met[j][a][STEPS];
  double at = (double)met.lamp_col, fall = 0.0;
  if (first) {
    fall = fmax(cos(lamp_angle(at) * UM_DEG), 0.0) * lamp_at(w, 0.0, at);
  } else {
    size_t k = (size_t)fminf(met.col, ANGLES - 2);
    double y = (double)met.col - (double)k;
    fall = exp((1.0 - y) * w->flux[k] + y * w->flux[k + 1]);
  }
  return sum + w->through[i][p] * GROUND / UM_PI * fall;
}

static void scatter(struct work *w, bool first)
{
  for (int j = 0; j < ANGLES; j++) {
    for (int i = 0; i < HEIGHTS; i++) {
      double mean = 0.0, flux = 0.0;
      for (int p = 0; p < POLAR; p++)
        for (int a = 0; a < AZIMUTHS; a++) {
          const struct line *line = &w->lines->line[i][p];
          double share = line->weight / AZIMUTHS * arriving(w, i, p, j, a, first);
          mean += share;
          if (i == 0) flux += 4.0 * UM_PI * share * fmax(cos(line->theta), 0.0);
        }
      w->next[i][j] = mean;
      if (i == 0) w->next_flux[j] = flux;
    }
  }
}

/* All orders of a wavelength. */
static void add_up(struct work *w, double out[HEIGHTS][ANGLES])
{
  for (int n = 1; n <= ORDERS; n++) {
    scatter(w, n == 1);
    for (int i = 0; i < HEIGHTS; i++)
      for (int j = 0; j < ANGLES; j++) {
        double before = n > 1 ? exp(w->source[i][j]) : 0.0, now = w->next[i][j];
        w->sum[i][j] = (n > 1 ? w->sum[i][j] : 0.0) + now;
        double q = before > 0.0 ? fmin(now / before, MOST) : 0.0;
        if (n == ORDERS) out[i][j] = log(fmax(w->sum[i][j] + now * q / (1.0 - q), LEAST));
        w->source[i][j] = log(fmax(now, LEAST));
      }
    for (int j = 0; j < ANGLES; j++) w->flux[j] = log(fmax(w->next_flux[j], LEAST));
  }
}

/* One of the wavelengths. */
static void add_up_at(const struct um_environment *environment, const struct lines *lines, size_t k,
                      struct work *w, struct um_environment_sky_light *out)
{
  double amount[UM_LIMB_CONSTITUENTS], depth[UM_LIMB_CONSTITUENTS];
  w->lines = lines;
  um_environment_sky_amounts(environment, &out->slant, out->height, amount);
  um_environment_sky_depths(amount, environment->sky.angstrom, um_environment_sky_wavelengths[k],
                            depth);
  colour(depth, w);
  add_up(w, out->again[k]);
}

enum um_status um_environment_sky_orders(struct um_context *context,
                                         const struct um_environment *environment,
                                         struct um_environment_sky_light *out)
{
  enum um_status status;
  struct lines *lines = NULL;
  struct work *work = NULL;
  int n = (int)out->count;
  if (n == 0) return UM_OK;
  UM_CHECK(um_core_allocate(context, 1, sizeof *lines, &lines));
  UM_CHECK(um_core_allocate(context, out->count, sizeof *work, &work));
  light_lamp(&out->slant, lines);
  lay_lines(&out->slant, lines);
#pragma omp parallel for schedule(dynamic) num_threads(um_core_context_threads(context))
  for (int k = 0; k < n; k++) add_up_at(environment, lines, out->first + (size_t)k, &work[k], out);
done:
  UM_FREE(context, lines, work);
  return status;
}
