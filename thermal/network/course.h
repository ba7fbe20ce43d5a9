/* Courses of heat in time: those that a part may have (body.h), and that missing heat may have
 * (evidence/missing_heat/). Each is on or off, or falls away; none is a wave, since what is
 * electric switches, and an error of the model that is locked to the orbit would look like one. */
#ifndef UMBRA_THERMAL_COURSE_H
#define UMBRA_THERMAL_COURSE_H

#include <stddef.h>

enum um_thermal_course_shape {
  UM_HEAT_STEP,     /* on from `start` to the end of what is observed */
  UM_HEAT_PULSE,    /* on for `last` */
  UM_HEAT_DECAY,    /* exp(-(t - start) / last) */
  UM_HEAT_PERIODIC, /* on for `last` in every `period` from `start` to the end */
  UM_HEAT_SHAPES
};

/* Heat of 1 W: where it begins, and what else its shape has. */
struct um_thermal_course {
  enum um_thermal_course_shape shape;
  double start;  /* t_tai [s] */
  double last;   /* [s]; INFINITY for a step */
  double period; /* [s]; NaN where there is none */
};

/* "step", "pulse", "decay", "periodic" */
const char *um_thermal_course_name(enum um_thermal_course_shape shape);
/* Numbers that are fitted for heat of a shape, for BIC: place, start and power, and those above. */
size_t um_thermal_course_parameters(enum um_thermal_course_shape shape);

/* Energy until t_tai = t [J] at a power of 1 W: the integral of the course. */
double um_thermal_course_energy(const struct um_thermal_course *course, double t);

/* The course as rows of time and power that are joined by lines, until `end`: two rows of one time
 * are a jump. A decay leaves its curve by less than 5e-4 of its first power. t NULL counts the
 * rows. power: of the course at 1 W. */
size_t um_thermal_course_rows(const struct um_thermal_course *course, double end, double *t,
                              double *power);

#endif
