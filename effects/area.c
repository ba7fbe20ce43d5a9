/* Area of a part: lengths times sqrt(f), so that every surface has f times its area and emits,
 * reflects and absorbs f times as much. Facets grow alike, so that mesh and sample points stay. */
#include "effects/list_impl.h"
#include "geometry/geometry.h"

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(n->geometry);
  double area = 0.0;
  for (size_t f = 0; n->use.target != NULL && f < mesh->nfacet; f++)
    if (strcmp(um_geometry_part_name(n->geometry, mesh->facet_part[f]), n->use.target) == 0)
      area += mesh->area[f];
  if (area > 0.0) um_effect_state(out, "area of facets", "m^2", area, -INFINITY, INFINITY);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "factor of the area of every surface of the part",
     .null_value = 1.0,
     .default_value = 1.1,
     .minimum = 0.1,
     .maximum = 10.0,
     .prior_sigma = 0.2,
     .stated = stated,
     .change = UM_CHANGE_SCALES,
     .prior = "0.7 to 1.3 of the area of a drawing",
     .formerly = "area_factor"},
};

static enum um_status geometry(struct um_context *context, const struct um_effect_use *use,
                               struct um_geometry_part_spec *part)
{
  (void)context;
  if (!um_effect_acts_on(use, part->name)) return UM_OK;
  double s = sqrt(use->value[0]);
  double *const length[] = {&part->size[0],      &part->size[1],    &part->size[2],
                            &part->radius,       &part->radius_top, &part->height,
                            &part->focal_length, &part->facet_size};
  for (size_t i = 0; i < sizeof length / sizeof length[0]; i++) *length[i] *= s;
  part->mesh_scale = part->mesh_scale == 0.0 ? s : part->mesh_scale * s;
  return UM_OK;
}

const struct um_effect um_effects_area = {
    UM_EFFECT_ABI,
    .name = "area",
    .summary = "A part is larger or smaller than modelled",
    .reference = "Wetterer & Jah 2009, J. Guid. Control Dyn. 32:1648",
    .validity = "the part grows about its own origin, parts that hang on it stay where they are; "
                "heat capacity and conductance per area, interior nodes and contacts stay",
    .separated_by = "zero_point and band_emissivity: visible and thermal infrared change by one "
                    "factor, and only at phases that show the part",
    .targets = UM_TARGET_PART,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.geometry = geometry},
};
