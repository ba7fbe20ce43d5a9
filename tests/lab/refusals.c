/* Questions that have no answer: an attitude of its own for every observation, more parameters than
 * rows, one scale for all channels that nobody knows. Refused, or not identifiable; never an effect
 * named with confidence. */
#include <math.h>
#include <string.h>

#include "effects/effects.h"
#include "evidence/diagnosis/diagnose.h"
#include "evidence/diagnosis/request.h"
#include "tests/lab/lab.h"

struct question {
  const char *name;
  struct lab_world world;
  struct lab_hidden hidden;
  const char *nuisance[3];
  size_t nnuisance;
  bool plain; /* the truth has the analyst's mesh: the finer keys are of another satellite */
};

static const struct question questions[] = {
    {.name = "attitude of its own for every observation",
     .world = {.name = "refusal", .folder = "dusk", .relative = 0.01, .floor = 1e-3},
     .hidden = {"attitude_offset", NULL, 1, 2.0},
     .nuisance = {"attitude_offset,sigma=free,per=observation"},
     .nnuisance = 1},
    {.name = "fewer observations than parameters",
     .world = {.name = "refusal",
               .folder = "dusk",
               .relative = 0.01,
               .floor = 1e-3,
               .filter = {.channels = "lwir", .from_s = 0.0, .to_s = 6.0}},
     .hidden = {"zero_point", "lwir", 0, 1.06},
     .nuisance = {"extinction:lwir,sigma=free", "background:lwir,sigma=free",
                  "earth_ir_level,sigma=free"},
     .nnuisance = 3},
    {.name = "one unknown scale for all channels",
     .world = {.name = "refusal", .folder = "dusk", .relative = 0.01, .floor = 1e-3},
     .hidden = {"zero_point", NULL, 0, 1.1},
     .nuisance = {"zero_point,sigma=free"},
     .nnuisance = 1},
    {.name = "a sphere's area, its scale unknown",
     .world = {.name = "refusal",
               .folder = "../sphere",
               .relative = 0.01,
               .floor = 1e-3,
               .set = {"time.step_s=120", "parts.sphere.facet_size_m=0.3"}},
     .hidden = {"area", "sphere", 0, 1.2},
     .nuisance = {"zero_point,sigma=free"},
     .nnuisance = 1,
     .plain = true},
};

/* False when an effect was named with confidence. */
static bool ask(struct um_context *context, const struct question *q, const char *folder,
                char answer[LAB_TEXT])
{
  enum um_status status;
  bool refused = true;
  struct lab_case c = {
      .part = "refusals", .world = &q->world, .hidden = {q->hidden}, .nhidden = 1, .seed = 1};
  struct lab_truth truth = {0};
  struct lab_analyst analyst;
  struct um_compare_measurements *measurements = NULL;
  struct um_sensitivity_forward *forward = NULL;
  struct um_sensitivity_candidates *candidates = NULL;
  struct um_diagnosis_request request = {0};
  struct um_diagnosis *d = NULL;
  char path[LAB_TEXT * 4];
  lab_world_path(&q->world, path);
  lab_world_analyst(&q->world, &analyst);
  UM_CHECK(lab_truth_create(context, &c, q->plain, folder, &truth));
  UM_CHECK(lab_truth_measure(context, &truth, &c, &measurements));
  UM_CHECK(um_sensitivity_forward_create(context, path, &analyst.options, measurements,
                                         UM_VARIANT_TIGHT, &forward));
  UM_CHECK(um_diagnosis_request_make(
      context, forward->model,
      &(struct um_diagnosis_request_texts){.nuisance = q->nuisance, .nnuisance = q->nnuisance},
      &request));
  const char *const only[] = {"zero_point", "area", "attitude_offset", "extinction"};
  struct um_diagnosis_options options = {.candidates = {.only = only, .nonly = 4},
                                         .nuisance = request.nuisance,
                                         .nnuisance = request.nnuisance,
                                         .no_next = true,
                                         .no_heat = true};
  UM_CHECK(um_sensitivity_candidates_create(context, forward, NULL, 0, &options.candidates,
                                            &candidates));
  UM_CHECK(um_diagnosis_create(context, forward, candidates, &options, &d));
  refused = d->verdict == UM_VERDICT_NOT_IDENTIFIABLE;
  snprintf(answer, LAB_TEXT, "%s", d->summary);
done:
  if (status != UM_OK) snprintf(answer, LAB_TEXT, "%s", um_core_message(context));
  if (status != UM_OK && status != UM_ERR_INPUT) refused = false;
  um_core_message_clear(context);
  um_diagnosis_destroy(context, &d);
  um_diagnosis_request_release(context, &request);
  um_sensitivity_candidates_destroy(context, &candidates);
  um_sensitivity_forward_destroy(context, &forward);
  um_compare_measurements_destroy(context, &measurements);
  lab_truth_release(context, &truth);
  return refused;
}

size_t lab_refusals(struct um_context *context, const struct lab_options *options, size_t *tried)
{
  size_t answered = 0;
  *tried = sizeof questions / sizeof questions[0];
  printf("\nquestions that have no answer\n");
  for (size_t i = 0; i < *tried; i++) {
    char answer[LAB_TEXT];
    bool refused = ask(context, &questions[i], options->folder, answer);
    answered += !refused;
    printf("%-42s %-8s %s\n", questions[i].name, refused ? "refused" : "ANSWERED", answer);
  }
  return answered;
}
