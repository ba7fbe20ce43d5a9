/* Numbers of missing_heat/ that decide whether heat explains a residual, and which: unit, and where
 * each comes from. HAND and LAB mean what evidence/diagnosis/policy.h says; the laboratory hides
 * heat of every shape. The warming that a response is differenced by stands in
 * evidence/missing_heat/observations.c. */
#ifndef UMBRA_MISSING_HEAT_POLICY_H
#define UMBRA_MISSING_HEAT_POLICY_H

/* ---- whether it explains (unexplained.c) ---- */

/* Probability [1] that noise alone is taken for heat, over all places and courses, and of a
 * diagnosis that it is taken for an effect. Convention. LAB: of 200 complete models none was
 * accused. */
#define UM_MISSING_HEAT_LEVEL 0.01
/* Of chi-square above its expectation [1], that an explanation may leave. LAB: all heat of
 * four shapes. Before that it was enough to explain half. */
#define UM_MISSING_HEAT_LEFT 0.05
/* Or so many standard deviations sqrt(2 dof) of chi-square [1], where that is more. Convention:
 * three sigma. */
#define UM_MISSING_HEAT_SCATTER 3.0

/* ---- how far it is looked for ---- */

/* Intervals of the first look. HAND: courses to try grow with their square. */
#define UM_MISSING_HEAT_BINS_MAX 60
/* Places whose responses are followed along one run of heat. Measured at 2733 nodes and 60 bins: a
 * place costs 1.9 s alone, 0.96 s of eight and 0.89 s of sixteen; eight hold 100 MB there. */
#define UM_MISSING_HEAT_TOGETHER 8
/* Best places that are looked at again, while their chi-square is above so much of the best [1],
 * with all times within so many intervals of an edge. LAB. */
#define UM_MISSING_HEAT_REFINED 3
#define UM_MISSING_HEAT_WORTHY  0.5
#define UM_MISSING_HEAT_ABOUT   2
/* BIC behind the best [1], up to which a shape gets these times. Convention: odds of 150 to 1. */
#define UM_MISSING_HEAT_RIVAL 10.0
/* Runs of the model that correct the linear response, until start and energy move by less than
 * this of their sigmas [1]. HAND: less than what is drawn. */
#define UM_MISSING_HEAT_STEPS   3
#define UM_MISSING_HEAT_SETTLED 0.1

/* ---- courses (numbers.c) ---- */

/* Time constant of a decay, of a first interval and of the whole time [1]. HAND: shorter is a
 * pulse, longer a step. */
#define UM_MISSING_HEAT_DECAY_LEAST 0.25
#define UM_MISSING_HEAT_DECAY_MOST  3.0
/* Share of a period that is on, or off, at least [1]. HAND. */
#define UM_MISSING_HEAT_ON_LEAST 0.05

/* ---- what is known of them (improve.c) ---- */

/* Walkers, and their steps: to forget where they began, that are samples, and up to the best. HAND:
 * errors over sigmas of 600 sets have an rms of 0.85 to 1.02. */
#define UM_MISSING_HEAT_WALKERS  32
#define UM_MISSING_HEAT_SETTLING 150
#define UM_MISSING_HEAT_SAMPLES  200
#define UM_MISSING_HEAT_CLIMB    150
/* Chi-square behind the best [1], from which on a walker was left in another valley. Derived: three
 * numbers lie there with probability 1e-6. */
#define UM_MISSING_HEAT_ASTRAY 30.0

/* ---- the history (history.c) ---- */

/* Chains, their moves until the first draw, moves between draws, and draws of each. HAND. */
#define UM_MISSING_HEAT_CHAINS  4
#define UM_MISSING_HEAT_FORGET  3000
#define UM_MISSING_HEAT_BETWEEN 20
#define UM_MISSING_HEAT_DRAWS   200
/* Changes of power at most. HAND: more than bins that tell anything. */
#define UM_MISSING_HEAT_CHANGES 40
/* ln [1] of the largest size of a change over that of one sigma. HAND: e^10 sigma. */
#define UM_MISSING_HEAT_SIZES 10.0
/* Probability that the band holds the heat of a bin [1]. Convention. */
#define UM_MISSING_HEAT_BAND 0.95

#endif
