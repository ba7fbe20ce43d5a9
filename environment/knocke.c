/* Knocke's zones, the window's brightness temperature, and the month of a date. */
#include "environment/knocke.h"

#include <math.h>

#include "base/core/constants.h"

#define DAY              86400.0  /* [s] */
#define KNOCKE_EPOCH_DAY 6584.5   /* from 1981-12-22 0 h to 2000-01-01 12 h [d] */
#define WINDOW_A         1.228    /* Ohring, Gruber & Ellingson 1984 [1] */
#define WINDOW_B         1.106e-3 /* the same [1/K] */

void um_environment_knocke(double sine_latitude, double season, double *albedo, double *emissivity)
{
  double p1 = sine_latitude, p2 = 0.5 * (3.0 * sine_latitude * sine_latitude - 1.0);
  *albedo = 0.34 + 0.10 * season * p1 + 0.29 * p2;
  *emissivity = 0.68 - 0.07 * season * p1 - 0.18 * p2;
}

double um_environment_knocke_season(double t_tai)
{
  return cos(2.0 * UM_PI * (t_tai / DAY + KNOCKE_EPOCH_DAY) / 365.25);
}

double um_environment_window_temperature(double longwave)
{
  double flux_temperature = sqrt(sqrt(fmax(longwave, 0.0) / UM_STEFAN_BOLTZMANN));
  double root = WINDOW_A * WINDOW_A - 4.0 * WINDOW_B * flux_temperature;
  return (WINDOW_A - sqrt(fmax(root, 0.0))) / (2.0 * WINDOW_B);
}

/* Gregorian year, month 0..11 and time of the month [d] of days since 2000-03-01 0 h: a year that
 * begins in March ends with its leap day, and 400 of them have 146097 days. */
int um_environment_month_split(double days, int *year, double *in_month)
{
  static const int first[13] = {0, 31, 61, 92, 122, 153, 184, 214, 245, 275, 306, 337, 366};
  double era = floor(days / 146097.0), rest = days - era * 146097.0;
  int day = (int)rest, y = 0;
  y = (day - day / 1460 + day / 36524 - day / 146096) / 365;
  int of_year = day - (365 * y + y / 4 - y / 100), m = 0;
  while (m < 11 && of_year >= first[m + 1]) m++;
  *in_month = of_year - first[m] + (rest - day);
  *year = 2000 + 400 * (int)era + y + (m >= 10);
  return (m + 2) % 12;
}

double um_environment_month_of(double t_tai)
{
  static const double length[12] = {31, 28.25, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  int year;
  double in_month, days = t_tai / DAY + 0.5 - 60.0; /* since 2000-03-01 0 h */
  int m = um_environment_month_split(days, &year, &in_month);
  return m + fmin(in_month / length[m], 1.0) - 0.5;
}
