/* A study that is prepared: the scenario as it stands with geometry and heat, what parameters do,
 * what is kept of a point. Private to study/. */
#ifndef UMBRA_STUDY_STUDY_IMPL_H
#define UMBRA_STUDY_STUDY_IMPL_H

#include "study/identity.h"
#include "study/parameter.h"
#include "study/study.h"
#include "variant/accuracy.h"

/* What is wanted of a point. */
enum um_study_wanted { UM_STUDY_IRRADIANCE, UM_STUDY_MAGNITUDE, UM_STUDY_TEMPERATURE };
struct um_study_output {
  enum um_study_wanted kind;
  const char *of; /* band or place; of the file or the nominal model */
};

struct um_study {
  struct um_study_run_options options;
  struct um_document *document;
  struct um_study_file *file;
  char *scenario;         /* its path */
  char *measurements;     /* their path, NULL: none */
  struct um_model *model; /* the scenario as it stands */
  struct um_variant_evaluator
      *evaluator;         /* of it, in each process; points come sorted by geometry */
  struct um_variant base; /* geometry and heat of the scenario as it stands */
  bool holds_files;
  struct um_study_identity *identity; /* of the scenario; of the points once they are run */
  struct um_study_binding *binding;   /* [nbinding] */
  size_t nbinding;
  bool *moves_geometry, *moves_heat;   /* [nbinding] */
  struct um_study_output *output;      /* [noutput] */
  size_t noutput, ntime, nvalue;       /* nvalue: noutput curves of ntime */
  double *nominal;                     /* [nvalue]; NaN: nothing is seen */
  double *scale;                       /* [noutput] largest of the nominal curve */
  struct um_variant_curve *curve;      /* [noutput] */
  struct um_variant_curves curves;     /* of a point */
  struct um_variant_accuracy accuracy; /* of a point's heat (tolerance.c) */
  size_t lost;                         /* by the batch */
  double seconds_run;                  /* wall time of the nominal's geometry, heat and light [s] */
};

/* --- outputs.c --- */
/* Which curves; the nominal model is built. UM_ERR_INPUT: no such band or place. */
enum um_status um_study_outputs_make(struct um_context *context, struct um_study *study);
/* The same with what is asked of them; the nominal curves are known. */
enum um_status um_study_curves_make(struct um_context *context, struct um_study *study);
/* From a run to value [nvalue]; what is not finite is NaN. user: the study. */
enum um_status um_study_outputs_take(struct um_context *context, const void *user,
                                     const struct um_model *model,
                                     const struct um_model_result *result, double *value);

/* --- run.c --- */
struct um_batch;
/* Solve points [n][nbinding], those of one geometry one after another; value, reason as of
 * um_batch_run. */
enum um_status um_study_solve(struct um_context *context, const struct um_study *study,
                              struct um_batch *batch, const double *parameter, size_t n,
                              double *value, char **reason);
/* --- stand_in.c --- */
/* Values of the result's points by a surrogate; of the solved ones their own. What the surrogate
 * does not bear is left to points that are solved: the result's falls_short, withheld and fewer
 * points say so. */
enum um_status um_study_stand_in(struct um_context *context, const struct um_study *study,
                                 struct um_batch *batch, struct um_study_result *result);
/* --- order.c --- */
/* In which order points of the design are solved where not all of them are, out [npoint], such that
 * the first ones are a sample of all: as it is of sobol, otherwise shuffled by the seed. */
enum um_status um_study_order(struct um_context *context, const struct um_study *study,
                              size_t npoint, size_t *out);

/* --- limits.c --- */
/* UM_ERR_INPUT with file and line: a limit of what is not among the outputs. */
enum um_status um_study_limits_check(struct um_context *context, const struct um_study *study);
enum um_status um_study_limits_make(struct um_context *context, const struct um_study *study,
                                    struct um_study_result *result);

/* --- point.c --- */
/* Model and values of a point. value [nvalue]; parameter [nbinding]. um_workers_compute, whose user
 * is the study. */
enum um_status um_study_point(struct um_context *context, void *user, const double *parameter,
                              double *value);
/* The scenario with some bindings at values, with its geometry; closed by the caller, after a
 * failure too. */
enum um_status um_study_open(struct um_context *context, const struct um_study *study,
                             const struct um_study_binding *binding, size_t nbinding,
                             const double *value, struct um_variant *out);

/* --- accepts.c --- */
/* um_batch_accepts, whose user is the study: temperatures are above 0 K, light is finite and not
 * below 0 unless effects change readings, and is seen where the scenario's is if nothing moves the
 * geometry. */
bool um_study_accepts(void *user, const double *parameter, const double *value);

/* --- points.c --- */
/* Points of the design: u, parameter [*n][nbinding], which the caller frees. */
enum um_status um_study_points(struct um_context *context, const struct um_study *study, double **u,
                               double **parameter, size_t *n);
/* Rows of u of a Saltelli or Morris design; 0 of others. */
size_t um_study_base(const struct um_study *study);
/* --- dependencies.c --- */
/* What every parameter wants computed anew; it is tried at both ends. */
enum um_status um_study_dependencies_find(struct um_context *context, struct um_study *study);
/* --- tolerance.c --- */
/* Of the asked error that solved points may use up where a surrogate takes the rest. */
#define UM_STUDY_SHARE_SURROGATE 0.3
/* The loosest tolerances that keep the asked error, held against a run with the scenario's own. */
enum um_status um_study_tolerance(struct um_context *context, struct um_study *study);

#endif
