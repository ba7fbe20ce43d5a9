/* run.nc: temperatures of nodes and places, and the heat flows of places.
 *
 * A node is named by the smallest place that has it: "bus.+x" when the place is that node alone,
 * else "bus.+x[12]", counted in the place. What no place has (the inside of a solid) is "node[i]".
 */
#include <math.h>

#include "output/netcdf_impl.h"

/* The place of a node, and which of the place's nodes it is. */
struct home {
  size_t place, member; /* place SIZE_MAX: none */
};

static void find_homes(const struct um_thermal_body *body, struct home *home, size_t n)
{
  for (size_t i = 0; i < n; i++) home[i] = (struct home){SIZE_MAX, 0};
  for (size_t p = 0; p < body->nplace; p++)
    for (size_t j = 0; j < body->place[p].nnode; j++) {
      struct home *at = &home[body->place[p].node[j]];
      if (at->place == SIZE_MAX || body->place[p].nnode < body->place[at->place].nnode)
        *at = (struct home){p, j};
    }
}

static enum um_status put_nodes(const struct um_output_netcdf *w)
{
  const struct um_thermal_body *body = w->run->model->body;
  const enum um_output_dimension axis = UM_NC_NODE;
  size_t n = w->length[UM_NC_NODE];
  struct home *home = NULL;
  char **name = NULL;
  int *place = NULL;
  enum um_status status;
  UM_CHECK(um_core_allocate(w->context, n, sizeof *home, &home));
  UM_CHECK(um_core_allocate(w->context, n, sizeof *name, &name));
  UM_CHECK(um_core_allocate(w->context, n, sizeof *place, &place));
  find_homes(body, home, n);
  for (size_t i = 0; i < n; i++) {
    bool none = home[i].place == SIZE_MAX;
    const struct um_thermal_place *at = none ? NULL : &body->place[home[i].place];
    place[i] = none ? -1 : (int)home[i].place;
    if (none)
      UM_CHECK(um_core_asprintf(w->context, &name[i], "node[%zu]", i));
    else if (at->nnode == 1)
      UM_CHECK(um_core_strdup(w->context, at->name, &name[i]));
    else
      UM_CHECK(um_core_asprintf(w->context, &name[i], "%s[%zu]", at->name, home[i].member));
  }
  UM_CHECK(um_output_netcdf_names(w, UM_NC_NODE, "heat nodes, by the smallest place that has them",
                                  (const char *const *)name));
  UM_CHECK(um_output_netcdf_int(w, "node_part", &axis, 1,
                                "index into part of the smallest place that has the node, -1: none",
                                place));
done:
  for (size_t i = 0; name != NULL && i < n; i++) um_core_free(w->context, name[i]);
  UM_FREE(w->context, name, home, place);
  return status;
}

static enum um_status put_places(const struct um_output_netcdf *w)
{
  const char **name = NULL;
  size_t n = w->length[UM_NC_PLACE];
  UM_TRY(um_core_allocate(w->context, n, sizeof *name, &name));
  for (size_t p = 0; p < n; p++) name[p] = w->run->result->place[p].name;
  enum um_status status =
      um_output_netcdf_names(w, UM_NC_PLACE, "parts, sides, groups, interiors and materials", name);
  um_core_free(w->context, name);
  return status;
}

static enum um_status put_temperatures(const struct um_output_netcdf *w, double *v)
{
  static const char *const names[3][2] = {
      {"part_temperature", "mean temperature"},
      {"part_temperature_minimum", "lowest temperature of the place"},
      {"part_temperature_maximum", "highest temperature of the place"}};
  const enum um_output_dimension tp[2] = {UM_NC_TIME, UM_NC_PLACE};
  const struct um_model_result *r = w->run->result;
  for (int which = 0; which < 3; which++) {
    for (size_t p = 0; p < r->nplace; p++) {
      const struct um_model_place_history *h = &r->place[p];
      const double *from = which == 0 ? h->mean : which == 1 ? h->minimum : h->maximum;
      for (size_t k = 0; k < r->nobs; k++) v[k * r->nplace + p] = from[k];
    }
    UM_TRY(um_output_netcdf_double(w, names[which][0], tp, 2, "K", names[which][1], v));
  }
  return UM_OK;
}

static double flow(const struct um_thermal_heat *heat, size_t i)
{
  const double all[] = {heat->solar,     heat->albedo,   heat->planet,    heat->internal,
                        heat->conducted, heat->radiated, heat->exchanged, heat->stored};
  return all[i];
}

/* Materials have no nodes of their own: NaN. */
static enum um_status put_flows(const struct um_output_netcdf *w, double *v)
{
  static const char *const names[][2] = {
      {"heat_solar", "absorbed sunlight, straight or by the satellite's own surfaces"},
      {"heat_albedo", "absorbed sunlight from the Earth"},
      {"heat_planet", "absorbed radiation of the Earth"},
      {"heat_internal", "electrical heat and heaters"},
      {"heat_conducted", "conducted into the place"},
      {"heat_radiated", "radiated, negative: to space"},
      {"heat_exchanged", "radiated between surfaces of the satellite, into the place"},
      {"heat_stored", "stored: the sum of the others"}};
  const enum um_output_dimension tp[2] = {UM_NC_TIME, UM_NC_PLACE};
  const struct um_model_result *r = w->run->result;
  size_t nplace = w->run->model->body->nplace;
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    for (size_t k = 0; k < r->nobs; k++)
      for (size_t p = 0; p < r->nplace; p++)
        v[k * r->nplace + p] = p < nplace ? flow(&r->heat[k * r->nplace + p], i) : (double)NAN;
    UM_TRY(um_output_netcdf_double(w, names[i][0], tp, 2, "W", names[i][1], v));
    UM_TRY(um_output_netcdf_note(w, names[i][0], "comment",
                                 "of all nodes of the place; a node on the edge of two sides "
                                 "counts for both"));
  }
  return UM_OK;
}

enum um_status um_output_netcdf_heat(const struct um_output_netcdf *w)
{
  const struct um_model_result *r = w->run->result;
  const enum um_output_dimension tn[2] = {UM_NC_TIME, UM_NC_NODE};
  enum um_status status;
  double *v = NULL;
  UM_TRY(put_places(w));
  UM_TRY(put_nodes(w));
  UM_TRY(um_output_netcdf_double(w, "node_temperature", tn, 2, "K", "temperature of each heat node",
                                 r->node_temperature));
  UM_TRY(um_core_allocate(w->context, r->nobs * r->nplace, sizeof *v, &v));
  UM_CHECK(put_temperatures(w, v));
  UM_CHECK(put_flows(w, v));
done:
  um_core_free(w->context, v);
  return status;
}
