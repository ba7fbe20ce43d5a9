/* What view factors are made of, and how they are written; the format stands in the header. */
#include "geometry/view_factor_file.h"

#include <inttypes.h>
#include <string.h>

#include "base/core/csv.h"
#include "base/core/sampling.h"
#include "geometry/view_factor_file_impl.h"

#define VERSION 1 /* of the way they are made: another one, other bits */

const char *const um_geometry_view_factor_key_name[4] = {"surfaces", "positions", "angles",
                                                         "sampling"};

static uint64_t hash_double(uint64_t hash, double value)
{
  uint64_t bits;
  memcpy(&bits, &value, sizeof bits);
  return um_core_hash(hash, bits);
}

static uint64_t hash_vertices(uint64_t hash, const struct um_geometry_mesh *mesh,
                              const struct um_geometry_pose *pose)
{
  for (size_t i = 0; i < mesh->nvertex; i++) {
    hash = hash_double(hash, pose->vertex[i].x);
    hash = hash_double(hash, pose->vertex[i].y);
    hash = hash_double(hash, pose->vertex[i].z);
  }
  return hash;
}

void um_geometry_view_factor_key_begin(const struct um_geometry_mesh *mesh,
                                       const struct um_geometry_pose *rest, size_t limit,
                                       const struct um_geometry_view_factor_options *options,
                                       struct um_geometry_view_factor_key *key)
{
  uint64_t hash = um_core_hash(um_core_hash(VERSION, mesh->nfacet), mesh->nsurface);
  for (size_t f = 0; f < mesh->nfacet; f++)
    for (int c = 0; c < 3; c++) hash = um_core_hash(hash, mesh->corner[f][c]);
  for (size_t s = 0; s < mesh->nsurface; s++) {
    const struct um_geometry_surface *own = &mesh->surface[s];
    hash = um_core_hash(um_core_hash(hash, own->facet), own->part);
    hash = um_core_hash(um_core_hash(hash, own->group), own->back);
  }
  key->surfaces = hash;
  key->positions = hash_vertices(VERSION, mesh, rest);
  key->angles = VERSION;
  hash = um_core_hash(um_core_hash(VERSION, options->rays), limit);
  hash = um_core_hash(um_core_hash(hash, options->open), options->closed);
  key->sampling = hash_double(hash, options->cutoff);
}

void um_geometry_view_factor_key_pose(const struct um_geometry_mesh *mesh,
                                      const struct um_geometry_pose *pose,
                                      struct um_geometry_view_factor_key *key)
{
  key->angles = hash_vertices(key->angles, mesh, pose);
}

void um_geometry_view_factor_key_values(const struct um_geometry_view_factor_key *key,
                                        uint64_t out[4])
{
  const uint64_t value[4] = {key->surfaces, key->positions, key->angles, key->sampling};
  memcpy(out, value, sizeof value);
}

static void put_number(FILE *file, const char *record, size_t pose, double value)
{
  char text[32];
  um_core_number_text(value, text);
  fprintf(file, "%s,%zu,,,%s,\n", record, pose, text);
}

static void put_patches(const struct um_geometry_view_factor_set *set, FILE *file)
{
  const struct um_geometry_patches *patches = set->patches;
  char text[32], name[1024];
  for (size_t p = 0; p < patches->npatch; p++)
    for (size_t i = patches->begin[p]; i < patches->begin[p + 1]; i++) {
      const struct um_geometry_surface *s = &set->mesh->surface[patches->surface[i]];
      um_core_number_text(set->mesh->area[s->facet], text);
      fprintf(file, "patch,,%zu,%" PRIu32 ",%s,", p, patches->surface[i], text);
      snprintf(name, sizeof name, "%s.%s", um_geometry_part_name(set->geometry, s->part),
               um_geometry_group(set->geometry, s->group)->name);
      um_core_csv_put(file, name, s->back ? ".back" : "");
      fputc('\n', file);
    }
}

static void put_pose(const struct um_geometry_view_factors *f, size_t pose, FILE *file)
{
  char text[32];
  put_number(file, "rays", pose, (double)f->rays);
  put_number(file, "cut", pose, f->cut);
  put_number(file, "unclosed", pose, f->unclosed);
  put_number(file, "residual", pose, f->residual);
  for (size_t p = 0; p < f->npatch; p++) {
    um_core_number_text(f->space[p], text);
    fprintf(file, "space,%zu,%zu,,%s,\n", pose, p, text);
    for (size_t e = f->begin[p]; e < f->begin[p + 1]; e++) {
      if (f->other[e] < p) continue;
      um_core_number_text(f->area[e], text);
      fprintf(file, "exchange,%zu,%zu,%" PRIu32 ",%s,\n", pose, p, f->other[e], text);
    }
  }
}

void um_geometry_view_factor_file_write(const struct um_geometry_view_factor_set *set, FILE *file)
{
  uint64_t key[4];
  um_geometry_view_factor_key_values(&set->key, key);
  fprintf(file,
          "# view factors of patches of surfaces as exchange areas [m2]: area of a patch times "
          "its view factor; the same both ways\n"
          "record,pose,from,to,value,of\n");
  for (int k = 0; k < 4; k++)
    fprintf(file, "%s,,,,%016" PRIx64 ",\n", um_geometry_view_factor_key_name[k], key[k]);
  fprintf(file, "patches,,,,%zu,\nposes,,,,%zu,\n", set->patches->npatch, set->npose);
  put_number(file, "interpolation", 0, set->interpolation);
  put_patches(set, file);
  for (size_t k = 0; k < set->npose; k++) put_pose(set->pose[k], k, file);
}
