/* Joined measurements: rows of the parts in their order, names of channels, tracks and stations
 * interned anew. */
#include "evidence/measurements/join.h"

#include <stdint.h>
#include <string.h>

#include "evidence/measurements/measurements.h"
#include "evidence/measurements/set_group.h"

static enum um_status check(struct um_context *context, struct um_compare_measurements *const *part,
                            const char *const *name, size_t n)
{
  for (size_t i = 1; i < n; i++) {
    if (part[i]->independent != part[0]->independent)
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s has columns of the satellite's geometry, %s has none; accepted: all "
                          "files with them, or none",
                          part[part[0]->independent ? 0 : i]->path,
                          part[part[0]->independent ? i : 0]->path);
    for (size_t k = 0; name != NULL && name[i] != NULL && k < i; k++)
      if (name[k] != NULL && strcmp(name[k], name[i]) == 0)
        return um_core_fail(context, UM_ERR_INPUT,
                            "two sets are called '%s'; accepted: a name of its own for each",
                            name[i]);
  }
  return UM_OK;
}

static enum um_status add_part(struct um_context *context,
                               const struct um_compare_measurements *part,
                               struct um_compare_set *set)
{
  for (size_t i = 0; i < part->count; i++) {
    struct um_compare_measurement row = part->row[i];
    const struct um_compare_channel *channel = &part->channel[row.channel];
    UM_TRY(um_compare_set_channel(context, set, channel->quantity, channel->of, &row.channel));
    UM_TRY(um_compare_set_track(context, set, part->track[row.track], &row.track));
    if (row.station != SIZE_MAX)
      UM_TRY(um_compare_set_station(context, set, part->station[row.station], &row.station));
    UM_TRY(um_compare_set_add(context, set, &row));
  }
  return UM_OK;
}

/* "a.csv, b.csv" */
static enum um_status join_paths(struct um_context *context, struct um_compare_measurements *m)
{
  size_t room = 1;
  char *text = NULL;
  for (size_t i = 0; i < m->nfile; i++) room += strlen(m->file[i].path) + 2;
  UM_TRY(um_core_allocate(context, room, 1, &text));
  for (size_t i = 0; i < m->nfile; i++) {
    if (i > 0) strcat(text, ", ");
    strcat(text, m->file[i].path);
  }
  um_core_free(context, m->path);
  m->path = text;
  return UM_OK;
}

static enum um_status rename_last(struct um_context *context, const char *const *name, size_t i,
                                  struct um_compare_measurements *m)
{
  if (name == NULL || name[i] == NULL || name[i][0] == '\0') return UM_OK;
  um_core_free(context, m->file[i].name);
  m->file[i].name = NULL;
  return um_core_strdup(context, name[i], &m->file[i].name);
}

enum um_status um_compare_measurements_join(struct um_context *context,
                                            struct um_compare_measurements *const *part,
                                            const char *const *name, size_t n,
                                            struct um_compare_measurements **out)
{
  enum um_status status;
  struct um_compare_set set = {0};
  *out = NULL;
  UM_TRY(check(context, part, name, n));
  for (size_t i = 0; i < n; i++) {
    const struct um_compare_file *file = &part[i]->file[0];
    UM_CHECK(i == 0 ? um_compare_set_begin(context, file->path, file->time_column, &set)
                    : um_compare_set_file(context, &set, file->path, file->time_column));
    UM_CHECK(rename_last(context, name, i, set.made));
    UM_CHECK(add_part(context, part[i], &set));
  }
  set.made->independent = part[0]->independent;
  UM_CHECK(join_paths(context, set.made));
  UM_CHECK(um_compare_set_finish(context, &set, out));
done:
  um_compare_set_abandon(context, &set);
  return status;
}

enum um_status um_compare_measurements_read_all(struct um_context *context, const char *const *path,
                                                size_t n, struct um_compare_measurements **out)
{
  enum um_status status;
  struct um_compare_measurements **part = NULL;
  if (n == 1) return um_compare_measurements_read(context, path[0], out);
  *out = NULL;
  UM_TRY(um_core_allocate(context, n, sizeof(*part), (void **)&part));
  for (size_t i = 0; i < n; i++) UM_CHECK(um_compare_measurements_read(context, path[i], &part[i]));
  UM_CHECK(um_compare_measurements_join(context, part, NULL, n, out));
done:
  for (size_t i = 0; i < n; i++) um_compare_measurements_destroy(context, &part[i]);
  um_core_free(context, (void *)part);
  return status;
}
