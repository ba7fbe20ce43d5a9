/* Every number that decides a verdict: unit, and where it comes from. Those of rooms below stand in
 * headers of their own:
 *
 *   base/inference/policy.h     what observations see, what can be told apart, where a fit ends
 *   evidence/sensitivity/policy.h   steps of differences, which candidates are alive
 *   evidence/missing_heat/policy.h  whether heat explains a residual; the false-alarm rate
 *   files of effects/      widths of priors, with their sources; which sides may have solar cells
 *
 * HAND: chosen by hand, and not calibrated. LAB: chosen by hand too, and in force when the
 * laboratory last ran in full (make lab; 654 cases on 2026-11-22, its figures are in
 * scenarios/hidden-effect/README.md) and met its goals. That shows that the number serves, not that
 * another would not. Where scans and simplices begin stands in non_smooth.c. */
#ifndef UMBRA_DIAGNOSIS_POLICY_H
#define UMBRA_DIAGNOSIS_POLICY_H

#include "base/inference/policy.h"
#include "evidence/missing_heat/policy.h"
#include "evidence/sensitivity/policy.h"

/* ---- noise, or not (verdict.c) ---- */

/* p below which a residual is not white noise of the stated sigma [1], and rows set aside that
 * follow one another are no accidents. Three tests (chi-square, autocorrelation, worst channel)
 * refuse a complete model in at most 0.3 %. LAB: 1 of 200, where 0.6 are expected. */
#define UM_DIAGNOSIS_NOT_NOISE 1e-3
/* Reduced chi-square [1] of all, and of a channel, up to which an effect suffices though the rest
 * is not quite noise. HAND: the model is never exact. 1.25 is 2.8 standard deviations sqrt(2 / n)
 * of 250 observations. LAB asks the same 1.25 (met in 99.7 %), and 2.25 of a channel (98.6 %). */
#define UM_DIAGNOSIS_BAD_FIT  1.25
#define UM_DIAGNOSIS_BAD_PART 2.0
/* Distance of a free nuisance from its start [sigma] at which it has taken up something. HAND: 6e-7
 * by chance. */
#define UM_DIAGNOSIS_MOVED 5.0

/* ---- a discrepancy of the model (discrepancy.c, scatter.c) ---- */

/* Distances over which phases of the orbit [rad] and directions in the body [rad] are alike. HAND:
 * an eighth of a turn of the orbit, 20 deg. Scales of time stand in discrepancy.c. */
#define UM_DIAGNOSIS_ALIKE_IN_ORBIT  0.8
#define UM_DIAGNOSIS_ALIKE_IN_ASPECT 0.35
/* Times that the noise is estimated and the search made anew, at most. HAND. */
#define UM_DIAGNOSIS_NOISE_ROUNDS 3
/* Fall of BIC [1] by another estimate of a fit's noise, or from another start, that is not worth
 * one more. Derived: ten times what a fit calls converged. */
#define UM_DIAGNOSIS_SETTLED 0.1
/* A discrepancy that is too large to be called one: above these sigmas, and this temperature [K] or
 * share of the light [1], and this share of what the scenario was off by [1]. HAND: models of
 * spacecraft that are held to be right are within 3 K of tests (ECSS-E-ST-31C asks 5 K). */
#define UM_DIAGNOSIS_LARGE_SIGMAS      3.0
#define UM_DIAGNOSIS_LARGE_TEMPERATURE 2.0
#define UM_DIAGNOSIS_LARGE_LIGHT       0.05
#define UM_DIAGNOSIS_LARGE_SHARE       0.3
/* Times sigma [1] from which on a scatter is said. Derived: less is 1 by two digits. */
#define UM_DIAGNOSIS_SCATTERS 1.05
/* Times sigma [1] that measurements may scatter. HAND: who states a third of his noise does not
 * know it. */
#define UM_DIAGNOSIS_LARGE_SCALE 3.0
/* Share of a channel's rows [1] that may be set aside as outliers. HAND: one of twenty; glints of a
 * blanket that a model without creases lacks were 6 % (w43). */
#define UM_DIAGNOSIS_LARGE_OUTLIERS 0.05

/* ---- one effect against another ---- */

/* Difference of BIC [1] that decides: odds exp(10 / 2) = 148 to 1, "very strong" of Kass & Raftery
 * 1995, JASA 90:773. LAB. */
#define UM_DIAGNOSIS_EVIDENCE 10.0
/* Difference of BIC [1] up to which the next best is named, and fits are not pruned, but those of
 * ties beyond EVIDENCE: odds 1800 to 1. LAB: no verdict moved when 15 took the place of 10. */
#define UM_DIAGNOSIS_NEXT_BEST 15.0
/* Worth of a step in BIC [1], below which it is small. Derived: twice the evidence, since an effect
 * that does half as well is then within the evidence of it. */
#define UM_DIAGNOSIS_SMALL (2.0 * UM_DIAGNOSIS_EVIDENCE)
/* Difference of BIC [1] by which an effect, or a pair, takes the place of what was found. Kass &
 * Raftery 1995: less is "not worth more than a bare mention". LAB. */
#define UM_DIAGNOSIS_BETTER 2.0
/* Distance of a value from where the effect does nothing [sigma], within which it is uncertain.
 * Convention: 4.6 % by chance. */
#define UM_DIAGNOSIS_SIGMAS 2.0
/* Probability [1] against a mere discrepancy, below which an effect is uncertain. HAND: one of a
 * hundred may be wrong. */
#define UM_DIAGNOSIS_CERTAIN 0.99
/* Distance from the usual [prior widths] from which on the prior may keep a value out, and beyond
 * which a value is implausible. Convention: one and three sigma. */
#define UM_DIAGNOSIS_UNUSUAL     1.0
#define UM_DIAGNOSIS_IMPLAUSIBLE 3.0
/* Priors [1] of nothing, of one effect, of several, of what the catalogue has not. HAND: somebody
 * who asks has a reason; a model that is held to be right mostly is. */
#define UM_DIAGNOSIS_PRIOR_NOTHING 0.5
#define UM_DIAGNOSIS_PRIOR_ONE     0.35
#define UM_DIAGNOSIS_PRIOR_SEVERAL 0.1
#define UM_DIAGNOSIS_PRIOR_NONE    0.05
/* In BIC [1], that something is off which is on by default: true nearly always, 1 to 100. HAND:
 * data may come from a program that has it not. */
#define UM_DIAGNOSIS_OFF 9.2

/* ---- what convinces a sceptic (sceptic.c) ---- */

/* Blocks of time, by turns of one half and the other; rows that are left out, those that are off
 * most; draws of noise. HAND: a p of 2e-3 is as small as 500 show. */
#define UM_DIAGNOSIS_BLOCKS 10
#define UM_DIAGNOSIS_ROWS   20
#define UM_DIAGNOSIS_DRAWS  500

/* ---- how far the search goes: it may miss, never accuse ---- */

/* Effects that are added, and candidates that are fitted in a round, when not asked for another
 * number. LAB. */
#define UM_DIAGNOSIS_STEPS_MAX    4
#define UM_DIAGNOSIS_ALTERNATIVES 8
/* Rounds of a step, while the best leaves a reduced chi-square above this [1]. LAB. */
#define UM_DIAGNOSIS_ROUNDS      2
#define UM_DIAGNOSIS_GOOD_ENOUGH 1.3
/* Share of the best score [1] from which on one whose shape is not known may fit as well. HAND:
 * heat of air of depth 0.12 has 0.99 of it by the shape of depth 0.3 that it begins with (w36). */
#define UM_DIAGNOSIS_SHAPE_REACH 0.9
/* Share of the best score [1] from which on a candidate is fitted, in the first round and in later
 * ones: by so much the linear model may underrate a non-linear one. LAB. */
#define UM_DIAGNOSIS_REACH       0.25
#define UM_DIAGNOSIS_LATER_REACH 0.5
/* Scans of candidates with parameters unidentified under the null, in a round. LAB: each costs a
 * scan of 8 to 16 runs. */
#define UM_DIAGNOSIS_UNIDENTIFIED_MAX 2
/* Fits of a step beyond those, of candidates that score within the evidence. HAND. */
#define UM_DIAGNOSIS_TIES 12
/* Pairs that are fitted in place of two effects, and replacements at the end, at most. LAB. */
#define UM_DIAGNOSIS_PAIRS  4
#define UM_DIAGNOSIS_PASSES 3
/* Distance from nothing [sigma] at which an effect is not tried without. Derived: chi-square would
 * rise by 36, and BIC falls by ln n, which is less for any n below 1e15. */
#define UM_DIAGNOSIS_CLEAR 6.0
/* Blocks of time that are held out in turn. Hastie, Tibshirani & Friedman 2009, Elements of
 * Statistical Learning, section 7.10: five or ten. Nothing is decided by them. */
#define UM_DIAGNOSIS_FOLDS 5

/* ---- parameters unidentified under the null (non_smooth.c, state.c) ---- */

/* First step of a difference [prior widths]. LAB. */
#define UM_DIAGNOSIS_UNIDENTIFIED_STEP 0.05
/* Steps of such a fit at most. LAB: more of them only follow discontinuities. */
#define UM_DIAGNOSIS_NON_SMOOTH_STEPS 6
/* Temperatures of its place that tell of a thermostat at least. Derived: a tenth of them is one. */
#define UM_DIAGNOSIS_ROWS_MIN 10
/* Evaluations of one simplex at most, and its size [of the first] that is not worth another. LAB.
 */
#define UM_DIAGNOSIS_EVALUATIONS 50
#define UM_DIAGNOSIS_SIMPLEX_END 0.02
/* Chi-square that another simplex has to gain [1]. LAB: as much as BETTER, in BIC. */
#define UM_DIAGNOSIS_SIMPLEX_GAIN UM_DIAGNOSIS_BETTER
/* Phases of a thermostat's cycle that are scanned, and the step of a difference by it [1]. HAND: an
 * eighth of a cycle is half of the flank of a saw-tooth that is on for a quarter of it. */
#define UM_DIAGNOSIS_PHASES     8
#define UM_DIAGNOSIS_PHASE_STEP 0.01
/* Searches from the best of those, each of another power or band. HAND: w40 has two minima, 22 and
 * 43 W. */
#define UM_DIAGNOSIS_PHASE_STARTS 2
/* Points up to here [sigma] tell how wide the valley is. Convention: three sigma. LAB. */
#define UM_DIAGNOSIS_VALLEY 3.0

/* ---- the next measurement (next.c) ---- */

/* Expected chi-square of an observation [1] that is worth saying. Derived: a thousand observations
 * make UM_INFERENCE_SEPARABLE. */
#define UM_DIAGNOSIS_WORTH_SAYING (UM_INFERENCE_SEPARABLE / 1000.0)
/* Sigma of what was not measured: of a band [1], of a place [K]; and floor of a band's, of its
 * brightest observation [1]. HAND. */
#define UM_DIAGNOSIS_USUAL_RELATIVE    0.02
#define UM_DIAGNOSIS_USUAL_TEMPERATURE 0.5
#define UM_DIAGNOSIS_FAINT             0.01
/* Alternatives of a step that are computed. HAND. */
#define UM_DIAGNOSIS_NEAREST 4
/* Passes to come: how far ahead they are looked for [d], and steps that each is looked at in. HAND.
 */
#define UM_DIAGNOSIS_DAYS       30
#define UM_DIAGNOSIS_PASS_STEPS 40
/* High airmass: above this share of the observations [1], where the largest is so many times the
 * least [1], and said where it is worth so many times all observations [1]. HAND. */
#define UM_DIAGNOSIS_HIGH    0.67
#define UM_DIAGNOSIS_RANGE   1.5
#define UM_DIAGNOSIS_CLEARER 1.3

/* ---- pairs that cannot be told apart (ties.c) ---- */

/* Correlation [1] from which on only a combination is known. Derived: each alone is then known five
 * times worse than beside the other's true value, 1 / sqrt(1 - 0.98^2). */
#define UM_DIAGNOSIS_TIED 0.98
/* Distance of a power from 1 [1] that is not worth a word. Derived: twice the 5 % within which a
 * fit knows its slopes. */
#define UM_DIAGNOSIS_ONE 0.1

/* ---- what is said (summary.c) ---- */

/* Share of a signature [1] below which nuisances do what an effect would. HAND. */
#define UM_DIAGNOSIS_RESEMBLES 0.3
/* p of a correlation [1] that is said. Convention. */
#define UM_DIAGNOSIS_CORRELATES 0.01
/* BIC [1] behind the winner or the end, beyond which alternatives and what was replaced are left to
 * the files. HAND. */
#define UM_DIAGNOSIS_FAR_BEHIND 100.0
/* Names of a group that are said. HAND. */
#define UM_DIAGNOSIS_NAMES 4

#endif
