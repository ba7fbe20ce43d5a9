/* umbra new: a folder with a scenario to begin with. The text is that of a scenario that comes with
 * the program, scenarios/cubesat-3u, with what was asked for in its place. */
#include "app/new.h"

#include <math.h>
#include <string.h>
#include <sys/stat.h>

#include "app/app.h"
#include "app/terminal.h"
#include "base/core/constants.h"
#include "base/core/data.h"
#include "base/core/file.h"
#include "base/core/listing.h"
#include "base/core/text.h"
#include "model/build/build.h"
#include "orbit/elements.h"
#include "orbit/time.h"

#define TEMPLATE       "cubesat-3u"
#define TEMPLATE_BYTES ((size_t)1 << 20)
#define FILE_BYTES     ((size_t)1 << 30) /* of a mesh; the elements are read to 1 MiB */
#define ELEMENTS_NAME  24                /* bytes of the name of elements */

/* What was made, for the last words. */
struct made {
  const char *mesh; /* plain name; NULL: the template's body */
  double scale;
  size_t npart;
  bool looked; /* was a pass looked for? */
  struct um_app_new_window window;
};

static const char *plain_name(const char *path)
{
  const char *slash = strrchr(path, '/');
  return slash == NULL ? path : slash + 1;
}

/* "a/b///" -> "b" into the text of the path, which loses its slashes. */
static enum um_status check_name(struct um_context *context, char *path, const char **name)
{
  struct stat st;
  size_t n = strlen(path);
  while (n > 1 && path[n - 1] == '/') path[--n] = '\0';
  *name = plain_name(path);
  if (!um_core_path_is_plain(*name) || !um_core_name_is_safe(*name))
    return um_core_fail(context, UM_ERR_INPUT,
                        "'%s' cannot name a scenario; accepted: " UM_CORE_NAME_ACCEPTED, *name);
  if (lstat(path, &st) == 0)
    return um_core_fail(context, UM_ERR_IO,
                        "%s: exists, and umbra new writes over nothing; accepted: a new name",
                        path);
  return UM_OK;
}

static enum um_status read_template(struct um_context *context, char **text)
{
  char *folder = NULL, *path = NULL;
  size_t length;
  UM_TRY(um_core_data_folder(context, "scenarios", &folder));
  enum um_status status = um_core_asprintf(context, &path, "%s/" TEMPLATE "/scenario.yaml", folder);
  if (status == UM_OK) status = um_core_file_read(context, path, TEMPLATE_BYTES, text, &length);
  UM_FREE(context, folder, path);
  return status;
}

/* A file of the folder in the making. */
static enum um_status put_file(struct um_context *context, struct um_core_folder *folder,
                               const char *name, const char *bytes, size_t n)
{
  FILE *file = NULL;
  UM_TRY(um_core_folder_open(context, folder, name, &file));
  enum um_status status = um_core_file_write(context, name, bytes, n, file);
  enum um_status closed = um_core_file_close(context, name, &file);
  return status == UM_OK ? closed : status;
}

/* The mesh beside the scenario, and its groups as parts. */
static enum um_status put_mesh(struct um_context *context, struct um_core_folder *folder,
                               const char *path, char **text, struct made *made)
{
  enum um_status status;
  struct um_geometry_obj_look look = {0};
  struct um_app_new_materials own = {0};
  char *bytes = NULL, **record = NULL;
  size_t n, nrecord = 0;
  made->mesh = plain_name(path);
  if (!um_core_name_is_safe(made->mesh))
    return um_core_fail(context, UM_ERR_INPUT, "'%s': accepted: " UM_CORE_NAME_ACCEPTED,
                        made->mesh);
  UM_CHECK(um_geometry_obj_look(context, path, &look));
  made->npart = look.npart;
  UM_CHECK(um_core_data_names(context, "materials", ".yaml", &record, &nrecord));
  UM_CHECK(um_app_new_materials(context, folder, path, made->mesh, record, nrecord, &own));
  UM_CHECK(um_app_new_parts(context, text, made->mesh, &look, record, nrecord, &own, &made->scale));
  UM_CHECK(um_core_file_read(context, path, FILE_BYTES, &bytes, &n));
  UM_CHECK(put_file(context, folder, made->mesh, bytes, n));
done:
  um_core_free(context, bytes);
  um_core_listing_free(context, record, nrecord);
  um_app_new_materials_clear(context, &own);
  um_geometry_obj_look_clear(context, &look);
  return status;
}

/* "elements" with the ending of the user's file. */
static void name_elements(const char *path, char name[ELEMENTS_NAME])
{
  const char *dot = strrchr(plain_name(path), '.');
  bool plain = dot != NULL && strlen(dot) < 8 && um_core_name_is_safe(dot + 1);
  snprintf(name, ELEMENTS_NAME, "elements%s", plain ? dot : ".tle");
}

/* The elements beside the scenario; *epoch [t_tai, s] of the last set. */
static enum um_status put_elements(struct um_context *context, struct um_core_folder *folder,
                                   const char *path, char **text, double *epoch)
{
  enum um_status status;
  struct um_orbit_elements elements = {0};
  char *bytes = NULL, *value = NULL, name[ELEMENTS_NAME];
  size_t n;
  UM_CHECK(um_core_file_read(context, path, TEMPLATE_BYTES, &bytes, &n));
  UM_CHECK(um_orbit_elements_parse(context, path, bytes, n, 0, &elements));
  *epoch = elements.set[elements.count - 1].epoch_tai;
  name_elements(path, name);
  UM_CHECK(put_file(context, folder, name, bytes, n));
  UM_CHECK(um_core_asprintf(context, &value, "orbit:\n  elements: %s\n", name));
  UM_CHECK(um_app_new_put(context, text, "orbit",
                          "# Where it flies: elements in the file beside this one, by SGP4. They "
                          "are good for some days about\n# their epoch; newer ones: "
                          "celestrak.org.\n",
                          value));
done:
  UM_FREE(context, bytes, value);
  um_orbit_elements_release(context, &elements);
  return status;
}

static enum um_status put_station(struct um_context *context, const char *said, char **text)
{
  struct um_forecast_station station = {0};
  char *value = NULL;
  enum um_status status = um_app_station_parse(context, said, &station);
  if (status == UM_OK)
    status = um_core_asprintf(
        context, &value,
        "observer:\n  station: {name: \"%s\", latitude_deg: %.9g, longitude_deg: %.9g, height_m: "
        "%.9g}\n  # `umbra passes` leaves out what stays below this elevation.\n"
        "  minimum_elevation_deg: 10\n",
        station.name, station.latitude / UM_DEG, station.longitude / UM_DEG, station.height);
  if (status == UM_OK) status = um_app_new_put(context, text, "observer", NULL, value);
  UM_FREE(context, value, (void *)station.name);
  return status;
}

/* The text as far as it is, where the model can read it. */
static enum um_status put_scenario(struct um_context *context, struct um_core_folder *folder,
                                   const char *text)
{
  return put_file(context, folder, "scenario.yaml", text, strlen(text));
}

static enum um_status put_name(struct um_context *context, const struct um_app_options *options,
                               const char *name, char **text)
{
  char *value = NULL;
  bool own = options->from_mesh != NULL || options->tle != NULL || options->one_station != NULL;
  UM_TRY(um_core_asprintf(context, &value, "name: \"%s\"\n", name));
  enum um_status status = um_app_new_put(context, text, "name", NULL, value);
  um_core_free(context, value);
  UM_TRY(status);
  if (!own) return UM_OK;
  UM_TRY(um_core_asprintf(context, &value, "summary: %s, as a telescope sees it.\n",
                          options->from_mesh != NULL ? "A satellite from a mesh"
                                                     : "A 3U CubeSat with two panels"));
  status = um_app_new_put(context, text, "summary", NULL, value);
  um_core_free(context, value);
  return status;
}

/* Orbit, station and time: a pass is looked for where one of the first two is the user's. */
static enum um_status put_sky(struct um_context *context, struct um_core_folder *folder,
                              const struct um_app_options *options, char **text, struct made *made)
{
  double from = NAN;
  if (options->tle != NULL) UM_TRY(put_elements(context, folder, options->tle, text, &from));
  if (options->one_station != NULL) UM_TRY(put_station(context, options->one_station, text));
  made->looked = options->tle != NULL || options->one_station != NULL;
  if (!made->looked) return UM_OK;
  if (!isnan(from)) { /* elements are judged by their age at the start */
    made->window = (struct um_app_new_window){.start = floor(from), .stop = floor(from) + 60.0};
    UM_TRY(um_app_new_window_put(context, text, &made->window));
  }
  UM_TRY(put_scenario(context, folder, *text));
  UM_TRY(um_app_new_window_find(context, um_core_folder_path(folder), from, &made->window));
  return um_app_new_window_put(context, text, &made->window);
}

static void print_made(const char *path, const struct made *made)
{
  char start[32];
  printf("%s/scenario.yaml: a scenario to begin with; its comments say what each line is\n", path);
  if (made->mesh != NULL)
    printf("%zu part%s from %s%s\n", made->npart, made->npart == 1 ? "" : "s", made->mesh,
           made->scale < 1.0 ? ", taken to be drawn in millimetres; else change scale" : "");
  if (made->looked && !made->window.seen)
    printf("not seen from the station within three days: change observer.station, or see umbra "
           "passes %s\n",
           path);
  if (made->looked && made->window.seen) {
    um_orbit_time_format(made->window.start, start);
    printf("its pass begins at %s: up to %.0f deg high, %s sky%s\n", start,
           made->window.highest / UM_DEG, made->window.dark ? "dark" : "bright",
           made->window.edge ? ", across the edge of the shadow" : "");
  }
  printf("next:\n  umbra check %s   what was understood: parts, areas, materials\n"
         "  umbra run %s     light and temperatures, with pictures\n",
         path, path);
}

static void print_json(const char *path, const struct um_model *model)
{
  char start[32], stop[32];
  um_orbit_time_format(model->scenario->time->start, start);
  um_orbit_time_format(model->scenario->time->stop, stop);
  um_core_json_text(stdout, "{", "folder", path);
  um_core_json_text(stdout, ", ", "name", model->scenario->name);
  printf(", \"parts\": %zu, \"start_utc\": \"%s\", \"stop_utc\": \"%s\"}\n",
         um_geometry_part_count(model->geometry), start, stop);
}

int um_app_new(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_core_folder *folder = NULL;
  struct um_model *model = NULL;
  struct made made = {0};
  char *path = NULL, *text = NULL;
  const char *name;
  UM_CHECK(um_core_strdup(context, options->positional[0], &path));
  UM_CHECK(check_name(context, path, &name));
  UM_CHECK(read_template(context, &text));
  UM_CHECK(um_core_folder_begin(context, path, false, &folder));
  UM_CHECK(put_name(context, options, name, &text));
  if (options->from_mesh != NULL)
    UM_CHECK(put_mesh(context, folder, options->from_mesh, &text, &made));
  UM_CHECK(put_sky(context, folder, options, &text, &made));
  UM_CHECK(put_scenario(context, folder, text));
  UM_CHECK(um_model_create(context, um_core_folder_path(folder), NULL, &model));
  UM_CHECK(um_core_folder_give(context, &folder));
  um_app_terminal_clear();
  if (options->json)
    print_json(path, model);
  else
    print_made(path, &made);
done:
  um_model_destroy(context, &model);
  um_core_folder_abort(&folder);
  UM_FREE(context, text, path);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
