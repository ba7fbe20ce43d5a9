/* Numbers of inference/ that decide what a diagnosis says: unit, and where each comes from. HAND
 * and LAB mean what evidence/diagnosis/policy.h says. What only steers a descent to the same
 * minimum stands where it acts (descent.c, jacobian.c, bounded.c). */
#ifndef UMBRA_INFERENCE_POLICY_H
#define UMBRA_INFERENCE_POLICY_H

/* ---- what observations see of a direction ---- */

/* Of a column's length [1], below which other columns express it. HAND: near the square root of the
 * rounding of a double, 1.5e-8. */
#define UM_INFERENCE_RANK_TOLERANCE 1e-8
/* Of a column's length [1] after the nuisances, below which they do the same. LAB. */
#define UM_INFERENCE_KEPT 1e-3
/* Length of a column [sigma], of one prior width where there is one, below which the observations
 * do not see it. HAND: a value is seen a million prior widths away. */
#define UM_INFERENCE_VISIBLE 1e-6
/* Cosine [1] above which two directions are one test. LAB. Such directions are 0.8 deg apart, their
 * scores of white noise 0.014 sigma rms. */
#define UM_INFERENCE_ONE_TEST 0.9999
/* p of a one-sided test [1] from which on the bound keeps the value out. Derived: p is halved on
 * the allowed side, and 1 less its half on the other. */
#define UM_INFERENCE_WRONG_SIDE 0.5

/* Expected chi-square between two explanations [1], above which they can be told apart. Derived:
 * the wrong one wins with probability Phi(-sqrt(D) / 2), 0.6 % at 25. LAB. */
#define UM_INFERENCE_SEPARABLE 25.0

/* ---- whiteness ---- */

/* Lags [observations] of the test at most, and observations to a lag. Hyndman & Athanasopoulos
 * 2018, Forecasting: principles and practice, section 3.3: ten, or a fifth of few observations. */
#define UM_INFERENCE_LAGS_MAX      10
#define UM_INFERENCE_ROWS_OF_A_LAG 5

/* ---- where a fit ends ---- */

/* Expected decrease of chi-square [1] that is not worth an evaluation. Derived: the square of a
 * tenth of a sigma. */
#define UM_INFERENCE_END 0.01
/* Steps of a fit at most. LAB. */
#define UM_INFERENCE_STEPS_MAX 20
/* Times its predicted reduction [1], a fit may still gain after so many steps. LAB. */
#define UM_INFERENCE_PRUNE_FACTOR 4.0
#define UM_INFERENCE_PRUNE_STEPS  2
/* The same of what is known to be linear. Derived: temperatures that an explanation moves by a
 * tenth bend by a few per cent. */
#define UM_INFERENCE_PRUNE_SURE 1.05

/* ---- noise that is more than sigma (noise.c) ---- */

/* Share of the trace of a correlation [1] that is left out, and most vectors of a channel: more is
 * no discrepancy but noise. HAND. */
#define UM_INFERENCE_CORRELATION_LEFT 1e-4
#define UM_INFERENCE_CORRELATION_RANK 256
/* Ratios of a discrepancy to noise [1] that are looked through. HAND: less is not seen in a
 * thousand rows, more is no discrepancy. */
#define UM_INFERENCE_RATIO_LEAST 0.02
#define UM_INFERENCE_RATIO_MOST  500.0
/* Scale on sigma [1], at least, beside a discrepancy: who states what the model may be off by
 * states more than the noise. HAND. White noise alone is never less than stated. */
#define UM_INFERENCE_SCALE_LEAST 0.1
/* Distance of a row from what the others foretell [sigma] at which it is an outlier. Convention:
 * 7e-6 by chance. */
#define UM_INFERENCE_OUTLIER 4.5
/* Share of rows that are outliers before anything is known [1], and at most in a channel. HAND. */
#define UM_INFERENCE_OUTLIERS      0.02
#define UM_INFERENCE_OUTLIERS_MOST 0.1
/* Looks for outliers, the noise estimated anew before each. HAND. */
#define UM_INFERENCE_LOOKS 4
/* Scatters at which a residual is cut before outliers are looked for [1]. HAND. */
#define UM_INFERENCE_WINSOR 3.0

#endif
