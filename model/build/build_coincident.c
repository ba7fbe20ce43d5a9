/* What a geometry counts twice, said before anything is computed. */
#include "model/build/steps_impl.h"

#include <stdio.h>

#include "geometry/bodies.h"
#include "geometry/coincident.h"

#define NAMED 5 /* pairs of parts with a line of their own */

static void warn_pair(struct um_context *context, const struct um_model *model,
                      const struct um_geometry_coincidence *pair, const char *least)
{
  static const char says[] =
      "in one place that look the same way: light and heat count twice there";
  const char *a = um_geometry_part_name(model->geometry, pair->part[0]);
  const char *b = um_geometry_part_name(model->geometry, pair->part[1]);
  if (pair->part[0] == pair->part[1])
    um_core_log(context, UM_LOG_WARNING, "part %s has %s%.4g m2 of surfaces %s", a, least,
                pair->area, says);
  else
    um_core_log(context, UM_LOG_WARNING, "parts %s and %s have %s%.4g m2 of surfaces %s", a, b,
                least, pair->area, says);
}

static enum um_status warn_surfaces(struct um_context *context, const struct um_model *model)
{
  struct um_geometry_coincidences *found = NULL;
  double area = 0.0;
  UM_TRY(um_geometry_coincidences_create(context, model->geometry, &found));
  const char *least = found->all ? "" : "at least ";
  for (size_t i = 0; i < found->n; i++)
    if (i < NAMED)
      warn_pair(context, model, &found->pair[i], least);
    else
      area += found->pair[i].area;
  if (found->n > NAMED)
    um_core_log(context, UM_LOG_WARNING, "so have %s%zu more pairs of parts, %s%.4g m2 together",
                least, found->n - NAMED, least, area);
  um_geometry_coincidences_destroy(context, &found);
  return UM_OK;
}

/* An interior of several bodies; the areas of the first of them are named. */
static enum um_status warn_bodies(struct um_context *context, const struct um_model *model,
                                  size_t part)
{
  double *area = NULL;
  size_t n, at = 0;
  char areas[128] = "";
  UM_TRY(um_geometry_bodies(context, model->geometry, part, &area, &n));
  for (size_t i = 0; i < n && i < NAMED; i++)
    at += (size_t)snprintf(areas + at, sizeof areas - at, "%s%.4g", i > 0 ? ", " : "", area[i]);
  if (n > 1)
    um_core_log(context, UM_LOG_WARNING,
                "part %s: its mesh holds %zu bodies that do not touch, of %s%s m2: they share its "
                "interior",
                um_geometry_part_name(model->geometry, part), n, areas, n > NAMED ? " ..." : "");
  um_core_free(context, area);
  return UM_OK;
}

enum um_status um_model_warn_coincident(struct um_context *context, const struct um_model *model)
{
  const struct um_scenario_part *part = model->scenario->parts.items;
  UM_TRY(warn_surfaces(context, model));
  for (size_t p = 0; p < model->scenario->parts.count; p++)
    if (um_model_interior_count(&part[p]) > 0) UM_TRY(warn_bodies(context, model, p));
  return UM_OK;
}
