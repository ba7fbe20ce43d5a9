/* Measurement sets: memory, and the checks that hold between rows. */
#include "evidence/measurements/set_group.h"

#include <ctype.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "evidence/measurements/time_text.h"

void um_compare_measurements_destroy(struct um_context *context,
                                     struct um_compare_measurements **measurements)
{
  if (measurements == NULL || *measurements == NULL) return;
  struct um_compare_measurements *m = *measurements;
  for (size_t i = 0; i < m->nchannel; i++) UM_FREE(context, m->channel[i].of, m->channel[i].label);
  for (size_t i = 0; i < m->nfile; i++)
    UM_FREE(context, m->file[i].path, m->file[i].name, m->file[i].station);
  for (size_t i = 0; i < m->ntrack; i++) um_core_free(context, m->track[i]);
  for (size_t i = 0; i < m->nstation; i++) um_core_free(context, m->station[i]);
  UM_FREE(context, m->channel, m->track, m->station, m->row, m->file, m->path, m);
  *measurements = NULL;
}

const char *um_compare_row_path(const struct um_compare_measurements *m, size_t row)
{
  return m->file[m->row[row].set].path;
}

const char *um_compare_row_time_column(const struct um_compare_measurements *m, size_t row)
{
  return m->file[m->row[row].set].time_column;
}

size_t um_compare_set_find(const struct um_compare_measurements *m, const char *name)
{
  for (size_t i = 0; i < m->nfile; i++)
    if (m->file[i].name != NULL && strcmp(m->file[i].name, name) == 0) return i;
  return UM_COMPARE_NOWHERE;
}

/* The name of a file without folder and ending, fit for targets ("vis@NAME") and tables; "-2" and
 * so on behind it where files of several folders have the same. */
static enum um_status name_file(struct um_context *context, const struct um_compare_measurements *m,
                                const char *path, char **out)
{
  const char *slash = strrchr(path, '/'), *name = slash != NULL ? slash + 1 : path;
  const char *dot = strrchr(name, '.');
  size_t n = dot != NULL && dot > name ? (size_t)(dot - name) : strlen(name), room = n + 24;
  char *made;
  UM_TRY(um_core_allocate(context, room, 1, &made));
  memcpy(made, name, n);
  for (size_t i = 0; i < n; i++)
    if (!isalnum((unsigned char)made[i]) && strchr("-_.", made[i]) == NULL) made[i] = '_';
  for (size_t k = 2; um_compare_set_find(m, made) != UM_COMPARE_NOWHERE; k++)
    snprintf(made + n, room - n, "-%zu", k);
  *out = made;
  return UM_OK;
}

enum um_status um_compare_set_begin(struct um_context *context, const char *path,
                                    const char *time_column, struct um_compare_set *set)
{
  *set = (struct um_compare_set){0};
  UM_TRY(um_core_allocate(context, 1, sizeof *set->made, &set->made));
  UM_TRY(um_core_strdup(context, path, &set->made->path));
  return um_compare_set_file(context, set, path, time_column);
}

enum um_status um_compare_set_file(struct um_context *context, struct um_compare_set *set,
                                   const char *path, const char *time_column)
{
  struct um_compare_measurements *m = set->made;
  UM_TRY(um_core_reallocate(context, m->nfile + 1, sizeof *m->file, &m->file));
  struct um_compare_file *file = &m->file[m->nfile++];
  *file = (struct um_compare_file){.time_column = time_column};
  UM_TRY(um_core_strdup(context, path, &file->path));
  return name_file(context, m, path, &file->name);
}

enum um_status um_compare_set_channel(struct um_context *context, struct um_compare_set *set,
                                      enum um_compare_quantity quantity, const char *of,
                                      size_t *channel)
{
  size_t tag = (set->made->nfile - 1) * UM_QUANTITY_COUNT + (size_t)quantity;
  return um_compare_names_intern(context, &set->channels, tag, of, channel);
}

enum um_status um_compare_set_track(struct um_context *context, struct um_compare_set *set,
                                    const char *name, size_t *track)
{
  UM_TRY(um_compare_names_intern(context, &set->tracks, set->made->nfile - 1, name, track));
  if (*track < set->last_capacity) return UM_OK;
  size_t capacity = 2 * *track + 16;
  UM_TRY(um_core_reallocate(context, capacity, sizeof *set->last, &set->last));
  for (size_t i = set->last_capacity; i < capacity; i++) set->last[i] = SIZE_MAX;
  set->last_capacity = capacity;
  return UM_OK;
}

enum um_status um_compare_set_station(struct um_context *context, struct um_compare_set *set,
                                      const char *name, size_t *station)
{
  return um_compare_names_intern(context, &set->stations, 0, name, station);
}

static enum um_compare_quantity quantity_of(const struct um_compare_set *set, size_t channel)
{
  return (enum um_compare_quantity)(set->channels.tag[channel] % UM_QUANTITY_COUNT);
}

/* Against the rows of the track that came before. */
static enum um_status check_order(struct um_context *context, const struct um_compare_set *set,
                                  const struct um_compare_measurement *row)
{
  const struct um_compare_measurements *m = set->made;
  size_t k = set->last[row->track];
  if (k == SIZE_MAX) return UM_OK;
  char time[40], other[40];
  const char *track = set->tracks.text[row->track];
  const struct um_compare_file *file = &m->file[m->nfile - 1];
  um_compare_time_text(row->t_tai, time);
  um_compare_time_text(m->row[k].t_tai, other);
  if (row->t_tai < m->row[k].t_tai)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s:%d: column '%s': %s is before %s of line %d in track '%s'; accepted: "
                        "rows in time order within a track",
                        file->path, row->line, file->time_column, time, other, m->row[k].line,
                        track);
  for (; k != SIZE_MAX && m->row[k].t_tai == row->t_tai; k = set->before[k])
    if (m->row[k].channel == row->channel)
      return um_core_fail(
          context, UM_ERR_INPUT,
          "%s:%d: column '%s': second row of %s '%s' at %s in track '%s', the first is line %d; "
          "accepted: one",
          file->path, row->line, file->time_column,
          um_compare_quantity_name(quantity_of(set, row->channel)),
          set->channels.text[row->channel], time, track, m->row[k].line);
  return UM_OK;
}

enum um_status um_compare_set_add(struct um_context *context, struct um_compare_set *set,
                                  const struct um_compare_measurement *row)
{
  struct um_compare_measurements *m = set->made;
  UM_TRY(check_order(context, set, row));
  if (m->count == set->row_capacity) {
    size_t capacity = 2 * set->row_capacity + 64;
    UM_TRY(um_core_reallocate(context, capacity, sizeof *m->row, &m->row));
    UM_TRY(um_core_reallocate(context, capacity, sizeof *set->before, &set->before));
    set->row_capacity = capacity;
  }
  set->before[m->count] = set->last[row->track];
  set->last[row->track] = m->count;
  m->row[m->count] = *row;
  m->row[m->count++].set = m->nfile - 1;
  return UM_OK;
}

static enum um_status label(struct um_context *context, const struct um_compare_measurements *m,
                            struct um_compare_channel *channel)
{
  if (m->nfile < 2) return um_core_strdup(context, channel->of, &channel->label);
  return um_core_asprintf(context, &channel->label, "%s@%s", channel->of,
                          m->file[channel->set].name);
}

enum um_status um_compare_set_finish(struct um_context *context, struct um_compare_set *set,
                                     struct um_compare_measurements **out)
{
  struct um_compare_measurements *m = set->made;
  if (m->count == 0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: no measurements; accepted: at least one row below the header",
                        m->path);
  size_t n = set->channels.count;
  UM_TRY(um_core_allocate(context, n, sizeof *m->channel, &m->channel));
  m->nchannel = n;
  for (size_t i = 0; i < n; i++) {
    m->channel[i].quantity = quantity_of(set, i);
    m->channel[i].of = set->channels.text[i]; /* taken over */
  }
  for (size_t i = 0; i < m->count; i++) {
    m->channel[m->row[i].channel].count++;
    m->channel[m->row[i].channel].set = m->row[i].set;
  }
  um_core_free(context, um_compare_names_take(context, &set->channels));
  for (size_t i = 0; i < n; i++) UM_TRY(label(context, m, &m->channel[i]));
  m->ntrack = set->tracks.count;
  m->track = um_compare_names_take(context, &set->tracks);
  m->nstation = set->stations.count;
  m->station = um_compare_names_take(context, &set->stations);
  *out = m;
  set->made = NULL;
  return UM_OK;
}

void um_compare_set_abandon(struct um_context *context, struct um_compare_set *set)
{
  um_compare_measurements_destroy(context, &set->made);
  um_compare_names_free(context, &set->channels);
  um_compare_names_free(context, &set->tracks);
  um_compare_names_free(context, &set->stations);
  UM_FREE(context, set->last, set->before);
  set->last = set->before = NULL;
}
