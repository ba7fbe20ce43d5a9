/* Numbers of sensitivity/ that decide which candidates are alive and where their search begins:
 * unit, and where each comes from. HAND and LAB mean what evidence/diagnosis/policy.h says. The
 * tolerance of evaluations is derived in variant/tolerance.h, the share of a step that
 * temperatures are moved by in evidence/sensitivity/moves.c. */
#ifndef UMBRA_SENSITIVITY_POLICY_H
#define UMBRA_SENSITIVITY_POLICY_H

/* ---- steps of differences (difference.c) ---- */

/* First step [prior widths]. LAB: a tenth of a width moves a derivative of a smooth model by some
 * percent, which matters less to a score. */
#define UM_SENSITIVITY_SHARE_OF_PRIOR 0.2
/* Of the range [1], where neither prior nor default say more. HAND. */
#define UM_SENSITIVITY_SHARE_OF_RANGE 0.01
/* A longer step reaches so far [prior widths]. LAB. */
#define UM_SENSITIVITY_PRIORS_MAX 2.0
/* A step that is too short grows by so much at most, and by so much more than is asked [1]. LAB. */
#define UM_SENSITIVITY_LONGEST 100.0
#define UM_SENSITIVITY_MARGIN  1.5
/* Divides a step that goes too far, or is refused [1]. LAB. */
#define UM_SENSITIVITY_SHORTER 10.0
/* Largest change of an observation that a step makes at least [sigma], and how often the noise of
 * an integration anew it is [1]: the derivative is then good to a tenth. LAB. */
#define UM_SENSITIVITY_SEEN        1e-3
#define UM_SENSITIVITY_ABOVE_NOISE 10.0
/* rms change from which on a step is far from a derivative [sigma]. LAB. */
#define UM_SENSITIVITY_FAR 30.0

/* Of a step of temperatures that answer to a parameter, over the largest answer [1], where a
 * signature and no derivative is wanted. A hundredth of a signature takes a ten-thousandth from a
 * score. LAB. */
#define UM_SENSITIVITY_HEAT_TOLERANCE 1e-3

/* ---- memory (forward.c, moves.c) ---- */

/* Geometries that are kept between evaluations, beside the scenario's, shared by workers, and those
 * that are open for one run of heat's answers, whoever shares it [bytes]. Answers stay whatever
 * they are. Of 201 geometries that a diagnosis of FUNcube-1 asked for again, 188 were among the
 * last ten. */
#define UM_SENSITIVITY_KEPT ((size_t)256 << 20)
#define UM_SENSITIVITY_OPEN ((size_t)512 << 20)

/* ---- derivatives (derivative.c) ---- */

/* Of the first step, where nothing is integrated anew [1]: a thousandth of a prior width or so.
 * Numbers carry 16 digits, and a bend over the first step is a ten-thousandth over this. */
#define UM_SENSITIVITY_SMALL 1e-2
/* Noise of an integration that a derivative has, of its largest value [1]. */
#define UM_SENSITIVITY_NOISE_SHARE 2e-4
/* An error that is small enough [1]: a thousandth is promised. */
#define UM_SENSITIVITY_GOOD 3e-4
/* What forward sensitivities of temperatures are good to [1]
 * (model/products/thermal_sensitivity.h).
 */
#define UM_SENSITIVITY_TANGENT 1e-3
/* An error that says that there is no derivative [1]. */
#define UM_SENSITIVITY_BROKEN 0.05
/* Channels count from this share of the largest change [1, in sigma]. */
#define UM_SENSITIVITY_COUNTS 1e-2
/* Divides a step whose error is too large, where runs are differenced [1], and how many are tried.
 */
#define UM_SENSITIVITY_CLOSER 4.0
#define UM_SENSITIVITY_TRIES  4
/* Of the difference of slopes over two steps, what the shorter one may still have [1]: a sixteenth
 * where the model is smooth. */
#define UM_SENSITIVITY_AGREES 0.25
/* What a line leaves of a change that is no bend [1]: noise of derivatives. */
#define UM_SENSITIVITY_STRAIGHT 1e-5
/* What a line may leave where it is called good [sigma]: a hundredth of a curve, since sigma is a
 * thousandth of its size (own.h). */
#define UM_SENSITIVITY_LINEAR 10.0

/* ---- who is alive ---- */

/* Root of the chi-square of all observations [sigma], at the furthest plausible value, that no
 * longer step is tried for. Derived: one sigma in all is within noise. */
#define UM_SENSITIVITY_UNSEEN 1.0
/* Largest change of an observation [sigma] that is none. HAND: a millionth of its noise. */
#define UM_SENSITIVITY_NOTHING 1e-6
/* Changes below so many times the noise of an integration [1] are not seen. Convention: three
 * sigma. LAB. */
#define UM_SENSITIVITY_LOST 3.0

/* ---- where a thermostat switches, before it is fitted (scan.c) ---- */

/* Where its place was measured: the quantile of its temperatures [1]. LAB: the coldest alone is
 * noise. Elsewhere: the share of the model's own range from its cold end [1]. LAB. */
#define UM_SENSITIVITY_COLDEST    0.05
#define UM_SENSITIVITY_COLD_SHARE 0.25

#endif
