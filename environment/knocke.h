/* The Earth by latitude and season, and its calendar. */
#ifndef UMBRA_ENVIRONMENT_KNOCKE_H
#define UMBRA_ENVIRONMENT_KNOCKE_H

/* Knocke, Ries & Tapley 1988 (AIAA 88-4292): with P1 = s and P2 = (3 s^2 - 1)/2 of the sine s of
 * the latitude, and the cosine c of 2 pi (days since 1981-12-22)/365.25, albedo = 0.34 + 0.10 c P1
 * + 0.29 P2,  emissivity = 0.68 - 0.07 c P1 - 0.18 P2, the emitted flux being emissivity * S/4 for
 * the solar irradiance S at the Earth's distance. */
void um_environment_knocke(double sine_latitude, double season, double *albedo, double *emissivity);
/* c of a date. */
double um_environment_knocke_season(double t_tai);
/* Brightness temperature in the window [K] of ground that emits this flux [W/m^2]: the flux
 * temperature T_F = (flux/sigma)^(1/4) is T (1.228 - 1.106e-3/K T) (Ohring, Gruber & Ellingson
 * 1984, J. Climate Appl. Meteor. 23:416, figures as in Yang & Slingo 2001, Mon. Wea. Rev. 129:784).
 * Meant for 100 to 320 W/m^2; does not fail. */
double um_environment_window_temperature(double longwave);
/* Month of a date: 0 in the middle of January, 11 in that of December; -0.5 to 11.5. */
double um_environment_month_of(double t_tai);
/* Gregorian year, month 0..11 and time since the month's beginning [d], of days since 2000-03-01 0
 * h. Returns the month. */
int um_environment_month_split(double days, int *year, double *in_month);

#endif
