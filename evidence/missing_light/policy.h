/* Numbers of missing_light/ that decide whether a correction of light explains a residual, and
 * which: unit, and where each comes from. HAND and LAB mean what evidence/diagnosis/policy.h says.
 */
#ifndef UMBRA_MISSING_LIGHT_POLICY_H
#define UMBRA_MISSING_LIGHT_POLICY_H

/* ---- what is tried ---- */

/* Knots of a curve that is joined by lines, at most. HAND: an effect has eight parameters. */
#define UM_MISSING_LIGHT_KNOTS 8
/* Turns of a circular coordinate, up to which it is taken as an arc with ends [1]. HAND. */
#define UM_MISSING_LIGHT_ARC 0.8
/* Pairs of waves of a circular coordinate, at most. HAND. */
#define UM_MISSING_LIGHT_WAVES 3
/* Places of a bump or an edge over the range that was seen, and how wide each may be, from the
 * widest down by halves, of that range [1]. HAND: what is between is found by
 * um_missing_light_refine.
 */
#define UM_MISSING_LIGHT_PLACES 16
#define UM_MISSING_LIGHT_WIDTHS 4
#define UM_MISSING_LIGHT_WIDEST 0.25
/* Observations that a curve has to rest on, for each of its numbers [1]. HAND. */
#define UM_MISSING_LIGHT_ROWS 4
/* Largest size of a number of a factor [1]. HAND: more is light of its own, beside the light that
 * it is said to be of. */
#define UM_MISSING_LIGHT_FACTOR 3.0
/* A coordinate that varies by less than this is none [deg or s]; of shares and turns [1]. HAND. */
#define UM_MISSING_LIGHT_RANGE       1.0
#define UM_MISSING_LIGHT_RANGE_SHARE 0.02

/* ---- which one it is ---- */

/* What place and coordinate cost, as numbers that are fitted [1]. As missing heat counts its place.
 */
#define UM_MISSING_LIGHT_CHOSEN 2
/* What time costs beside other coordinates, in BIC [1]. HAND: along one pass every angle is a
 * function of time, and what goes with an angle comes again. */
#define UM_MISSING_LIGHT_TIME 10.0
/* What it costs, in BIC [1], that a coordinate is none of the place: a surface does not know the
 * elevation at the station, nor the sky the attitude of the body. HAND: odds of 150 to 1. One pass
 * gives several coordinates that fit alike. */
#define UM_MISSING_LIGHT_ODD 10.0
/* BIC behind the best [1], up to which others are named. Convention: odds of 150 to 1. */
#define UM_MISSING_LIGHT_TIED 10.0

/* ---- whether it explains ---- */

/* BIC that it must be worth [1], beside 2 ln of how many were tried (extended BIC of Chen & Chen
 * 2008). Convention. */
#define UM_MISSING_LIGHT_EVIDENCE 10.0
/* Of chi-square above its expectation [1], that an explanation may leave; or so many standard
 * deviations sqrt(2 dof). As of missing heat, but a curve of few numbers follows less closely.
 * HAND.
 */
#define UM_MISSING_LIGHT_LEFT    0.1
#define UM_MISSING_LIGHT_SCATTER 3.0

#endif
