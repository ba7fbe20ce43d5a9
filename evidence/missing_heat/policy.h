/* Numbers of missing_heat/ that decide whether heat explains a residual, and which: unit, and where
 * each comes from. HAND and LAB mean what evidence/diagnosis/policy.h says; the laboratory hides
 * six pulses. The warming that a response is differenced by stands in
 * evidence/missing_heat/observations.c. */
#ifndef UMBRA_MISSING_HEAT_POLICY_H
#define UMBRA_MISSING_HEAT_POLICY_H

/* ---- whether it explains (unexplained.c) ---- */

/* Probability [1] that noise alone is taken for heat, over all places and pulses, and of a
 * diagnosis that it is taken for an effect. Convention. LAB: of 200 complete models none was
 * accused. */
#define UM_MISSING_HEAT_LEVEL 0.01
/* Of chi-square above its expectation [1], that an explanation may leave. LAB: all six pulses.
 * Before that it was enough to explain half. */
#define UM_MISSING_HEAT_LEFT 0.05
/* Or so many standard deviations sqrt(2 dof) of chi-square [1], where that is more. Convention:
 * three sigma. */
#define UM_MISSING_HEAT_SCATTER 3.0

/* ---- how far it is looked for ---- */

/* Intervals of the first look. HAND: pulses to try grow with their square. */
#define UM_MISSING_HEAT_BINS_MAX 60
/* Places whose responses are followed along one run of heat. Measured at 2733 nodes and 60 bins: a
 * place costs 1.9 s alone, 0.96 s of eight and 0.89 s of sixteen; eight hold 100 MB there. */
#define UM_MISSING_HEAT_TOGETHER 8
/* Best places that are looked at again, while their chi-square is above so much of the best [1],
 * with all times within so many intervals of an edge. LAB. */
#define UM_MISSING_HEAT_REFINED 3
#define UM_MISSING_HEAT_WORTHY  0.5
#define UM_MISSING_HEAT_ABOUT   2
/* Secant steps to the power that the model itself asks for, until it moves by less than this [1].
 * LAB: energies came within 2 %. */
#define UM_MISSING_HEAT_STEPS   3
#define UM_MISSING_HEAT_SETTLED 0.01

/* ---- the smoothed history (history.c) ---- */

/* Of a column's length [1], below which others express it. Derived: hardly above rounding, since
 * lambda is to decide. */
#define UM_MISSING_HEAT_RANK_TOLERANCE 1e-13
/* Decades of lambda about tr D'D / tr L'L, either way, and halvings of that range. HAND: thirty
 * leave 3e-8 decades. */
#define UM_MISSING_HEAT_DECADES  14
#define UM_MISSING_HEAT_HALVINGS 30

#endif
