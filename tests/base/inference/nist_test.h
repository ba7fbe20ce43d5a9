/* Nonlinear regression problems of the NIST Statistical Reference Datasets (Rogers, Filliben, Gill,
 * Guthrie, Lagergren & Vangel 1998, https://www.itl.nist.gov/div898/strd/nls/nls_main.shtml): data,
 * starts, certified parameters, their standard deviations and residual sums of squares. */
#ifndef UMBRA_TESTS_INFERENCE_NIST_TEST_H
#define UMBRA_TESTS_INFERENCE_NIST_TEST_H

#include <math.h>
#include <stddef.h>

#define NIST_ROWS_MAX       37
#define NIST_PARAMETERS_MAX 7

struct nist_problem {
  const char *name;
  size_t nobservation, nparameter;
  double y[NIST_ROWS_MAX], x[NIST_ROWS_MAX];
  double start[2][NIST_PARAMETERS_MAX];
  double certified[NIST_PARAMETERS_MAX], deviation[NIST_PARAMETERS_MAX];
  double squares;
  double (*model)(const double *b, double x);
  size_t flat_start; /* 1: from the first start the fit runs away to where the model is flat */
};

/* Misra 1978, dental research in monomolecular adsorption; lower difficulty. */
static double misra1a(const double *b, double x) { return b[0] * (1.0 - exp(-b[1] * x)); }
/* Kowalik & Osborne 1978, in More, Garbow & Hillstrom 1981; higher difficulty. */
static double mgh09(const double *b, double x)
{
  return b[0] * (x * x + x * b[1]) / (x * x + x * b[2] + b[3]);
}
/* Thurber 1979, semiconductor electron mobility; higher difficulty. */
static double thurber(const double *b, double x)
{
  return (b[0] + x * (b[1] + x * (b[2] + x * b[3]))) / (1.0 + x * (b[4] + x * (b[5] + x * b[6])));
}

static const struct nist_problem nist[] = {
    {"Misra1a",
     14,
     2,
     {10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01, 66.40, 75.47,
      81.78},
     {77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8, 593.1, 689.1,
      760.0},
     {{500.0, 0.0001}, {250.0, 0.0005}},
     {2.3894212918e+02, 5.5015643181e-04},
     {2.7070075241e+00, 7.2668688436e-06},
     1.2455138894e-01,
     misra1a,
     0},
    {"MGH09",
     11,
     4,
     {1.957e-01, 1.947e-01, 1.735e-01, 1.600e-01, 8.44e-02, 6.27e-02, 4.56e-02, 3.42e-02, 3.23e-02,
      2.35e-02, 2.46e-02},
     {4.0, 2.0, 1.0, 0.5, 0.25, 0.167, 0.125, 0.1, 0.0833, 0.0714, 0.0625},
     {{25.0, 39.0, 41.5, 39.0}, {0.25, 0.39, 0.415, 0.39}},
     {1.9280693458e-01, 1.9128232873e-01, 1.2305650693e-01, 1.3606233068e-01},
     {1.1435312227e-02, 1.9633220911e-01, 8.0842031232e-02, 9.0025542308e-02},
     3.0750560385e-04,
     mgh09,
     1},
    {"Thurber",
     37,
     7,
     {80.574,   84.248,   87.264,   87.195,   89.076,   89.608,   89.868,   90.101,
      92.405,   95.854,   100.696,  101.060,  401.672,  390.724,  567.534,  635.316,
      733.054,  759.087,  894.206,  990.785,  1090.109, 1080.914, 1122.643, 1178.351,
      1260.531, 1273.514, 1288.339, 1327.543, 1353.863, 1414.509, 1425.208, 1421.384,
      1442.962, 1464.350, 1468.705, 1447.894, 1457.628},
     {-3.067, -2.981, -2.921, -2.912, -2.840, -2.797, -2.702, -2.699, -2.633, -2.481,
      -2.363, -2.322, -1.501, -1.460, -1.274, -1.212, -1.100, -1.046, -0.915, -0.714,
      -0.566, -0.545, -0.400, -0.309, -0.109, -0.103, 0.010,  0.119,  0.377,  0.790,
      0.963,  1.006,  1.115,  1.572,  1.841,  2.047,  2.200},
     {{1000.0, 1000.0, 400.0, 40.0, 0.7, 0.3, 0.03}, {1300.0, 1500.0, 500.0, 75.0, 1.0, 0.4, 0.05}},
     {1.2881396800e+03, 1.4910792535e+03, 5.8323836877e+02, 7.5416644291e+01, 9.6629502864e-01,
      3.9797285797e-01, 4.9727297349e-02},
     {4.6647963344e+00, 3.9571156086e+01, 2.8698696102e+01, 5.5675370270e+00, 3.1333340687e-02,
      1.4984928198e-02, 6.5842344623e-03},
     5.6427082397e+03,
     thurber,
     0}};

#endif
