/* Measurements that a scenario lists: files, windows of time, names. */
#include "evidence/measurements/listed.h"

#include <string.h>

#include "evidence/measurements/join.h"
#include "evidence/measurements/measurements.h"
#include "model/scenario/scenario.h"
#include "model/scenario/station.h"

static enum um_status check(struct um_context *context, const struct um_scenario_set *set, size_t i)
{
  const struct um_mark *at = &set[i].at;
  if (strchr(set[i].name, '@') != NULL)
    return um_document_mark_fail(context, um_document_mark_key(at, "name"),
                                 "'%s' has an '@'; accepted: a name without", set[i].name);
  for (size_t k = 0; k < i; k++)
    if (strcmp(set[k].name, set[i].name) == 0)
      return um_document_mark_fail(context, um_document_mark_key(at, "name"),
                                   "'%s' is already listed on line %d; accepted: once", set[i].name,
                                   set[k].at.line);
  if (set[i].to < set[i].from)
    return um_document_mark_fail(context, um_document_mark_key(at, "to_utc"),
                                 "before from_utc; accepted: a time behind it");
  return UM_OK;
}

static enum um_status check_station(struct um_context *context, const struct um_scenario *scenario,
                                    const struct um_scenario_set *set)
{
  size_t station;
  if (set->station == NULL) return UM_OK;
  enum um_status status =
      um_model_station_find(context, scenario->observer, set->station, &station);
  const struct um_mark *at = um_document_mark_key(&set->at, "station");
  if (status != UM_OK)
    um_core_message_prefix(context, "%s:%d: %s.station", at->file, at->line, set->at.path);
  return status;
}

/* Leave out the rows outside the window. */
static enum um_status cut(struct um_context *context, const struct um_scenario_set *set,
                          struct um_compare_measurements *m)
{
  size_t left = 0;
  for (size_t i = 0; i < m->count; i++) {
    double t = m->row[i].t_tai;
    if (t < set->from || t > set->to) m->row[i].flag = 1; /* NaN: neither */
    left += m->row[i].flag == 0;
  }
  if (left > 0) return UM_OK;
  return um_document_mark_fail(context, &set->at,
                               "no row of %s is left; accepted: one with flag 0 between from_utc "
                               "and to_utc",
                               set->file);
}

enum um_status um_compare_measurements_listed(struct um_context *context,
                                              const struct um_scenario *scenario,
                                              struct um_compare_measurements **out)
{
  enum um_status status;
  const struct um_scenario_measurements *from = scenario->measurements;
  size_t n = from != NULL ? from->sets.count : 0;
  const struct um_scenario_set *set = n > 0 ? from->sets.items : NULL;
  struct um_compare_measurements **part = NULL, *joined = NULL;
  const char **name = NULL;
  *out = NULL;
  if (n == 0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: no measurements; accepted: files of them behind the scenario, or "
                        "measurements.sets in it",
                        scenario->at.file);
  UM_CHECK(um_core_allocate(context, n, sizeof *part, (void *)&part));
  UM_CHECK(um_core_allocate(context, n, sizeof *name, (void *)&name));
  for (size_t i = 0; i < n; i++) {
    UM_CHECK(check(context, set, i));
    UM_CHECK(check_station(context, scenario, &set[i]));
    name[i] = set[i].name;
    UM_CHECK(um_compare_measurements_read(context, set[i].file, &part[i]));
    UM_CHECK(cut(context, &set[i], part[i]));
  }
  UM_CHECK(um_compare_measurements_join(context, part, name, n, &joined));
  for (size_t i = 0; i < n; i++)
    if (set[i].station != NULL)
      UM_CHECK(um_core_strdup(context, set[i].station, &joined->file[i].station));
  *out = joined;
  joined = NULL;
done:
  um_compare_measurements_destroy(context, &joined);
  for (size_t i = 0; part != NULL && i < n; i++) um_compare_measurements_destroy(context, &part[i]);
  UM_FREE(context, (void *)part, (void *)name);
  return status;
}
