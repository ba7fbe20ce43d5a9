/* A binary tree of boxes over facets. The facets stand in the order of a Morton curve through their
 * middles (Karras 2012 builds such trees, too), each box is that of the two below it, and node i
 * has the children 2 i and 2 i + 1: no pointers. */
#include "geometry/facet_tree_impl.h"

#include <math.h>
#include <string.h>

#include "base/core/sort.h"

#define DEPTH 64

struct box {
  struct um_vec3 low, high; /* [m]; low above high: empty */
};
struct place {
  uint64_t code;
  uint32_t facet;
};
struct um_geometry_facet_tree {
  size_t leaves;        /* a power of two */
  struct box *box;      /* [2 leaves] from the root, 1, on */
  struct place *place;  /* [nfacet] in order */
  struct box *of_facet; /* [nfacet] */
  size_t nfacet;
};

static struct box box_join(struct box a, struct box b)
{
  return (struct box){
      um_vec3(fmin(a.low.x, b.low.x), fmin(a.low.y, b.low.y), fmin(a.low.z, b.low.z)),
      um_vec3(fmax(a.high.x, b.high.x), fmax(a.high.y, b.high.y), fmax(a.high.z, b.high.z))};
}

static bool boxes_touch(const struct box *a, const struct box *b, double margin)
{
  return a->low.x <= b->high.x + margin && b->low.x <= a->high.x + margin &&
         a->low.y <= b->high.y + margin && b->low.y <= a->high.y + margin &&
         a->low.z <= b->high.z + margin && b->low.z <= a->high.z + margin;
}

/* The lowest 21 bits, two zeros between each. */
static uint64_t spread(uint64_t x)
{
  x = (x | x << 32) & UINT64_C(0x001f00000000ffff);
  x = (x | x << 16) & UINT64_C(0x001f0000ff0000ff);
  x = (x | x << 8) & UINT64_C(0x100f00f00f00f00f);
  x = (x | x << 4) & UINT64_C(0x10c30c30c30c30c3);
  return (x | x << 2) & UINT64_C(0x1249249249249249);
}

static uint64_t step_of(double middle, double low, double size)
{
  double share = size > 0.0 ? (middle - low) / size : 0.0;
  return (uint64_t)(fmin(fmax(share, 0.0), 1.0) * 2097151.0);
}

static int by_code(const void *pa, const void *pb)
{
  const struct place *a = pa, *b = pb;
  return (a->code > b->code) - (a->code < b->code);
}

static enum um_status put_in_order(struct um_context *context, struct um_geometry_facet_tree *t,
                                   struct box all)
{
  for (size_t f = 0; f < t->nfacet; f++) {
    struct um_vec3 m = um_vec3_scale(um_vec3_add(t->of_facet[f].low, t->of_facet[f].high), 0.5);
    t->place[f].facet = (uint32_t)f;
    t->place[f].code = spread(step_of(m.x, all.low.x, all.high.x - all.low.x)) |
                       spread(step_of(m.y, all.low.y, all.high.y - all.low.y)) << 1 |
                       spread(step_of(m.z, all.low.z, all.high.z - all.low.z)) << 2;
  }
  return um_core_sort(context, t->place, t->nfacet, sizeof *t->place, by_code);
}

enum um_status um_geometry_facet_tree_create(struct um_context *context,
                                             const struct um_geometry_mesh *mesh,
                                             const struct um_geometry_pose *pose,
                                             struct um_geometry_facet_tree **out)
{
  static const struct box empty = {{INFINITY, INFINITY, INFINITY},
                                   {-INFINITY, -INFINITY, -INFINITY}};
  enum um_status status;
  struct um_geometry_facet_tree *t = NULL;
  struct box all = empty;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *t, &t));
  t->nfacet = mesh->nfacet;
  for (t->leaves = 1; t->leaves < t->nfacet;) t->leaves *= 2;
  UM_CHECK(um_core_allocate(context, 2 * t->leaves, sizeof *t->box, &t->box));
  UM_CHECK(um_core_allocate(context, t->nfacet, sizeof *t->place, &t->place));
  UM_CHECK(um_core_allocate(context, t->nfacet, sizeof *t->of_facet, &t->of_facet));
  for (size_t f = 0; f < t->nfacet; f++) {
    struct box box = empty;
    for (int k = 0; k < 3; k++) {
      struct um_vec3 p = pose->vertex[mesh->corner[f][k]];
      box = box_join(box, (struct box){p, p});
    }
    t->of_facet[f] = box;
    all = box_join(all, box);
  }
  UM_CHECK(put_in_order(context, t, all));
  for (size_t i = 0; i < t->leaves; i++)
    t->box[t->leaves + i] = i < t->nfacet ? t->of_facet[t->place[i].facet] : empty;
  for (size_t i = t->leaves; i-- > 1;) t->box[i] = box_join(t->box[2 * i], t->box[2 * i + 1]);
  *out = t;
  t = NULL;
done:
  um_geometry_facet_tree_destroy(context, &t);
  return status;
}

void um_geometry_facet_tree_destroy(struct um_context *context,
                                    struct um_geometry_facet_tree **tree)
{
  if (tree == NULL || *tree == NULL) return;
  UM_FREE(context, (*tree)->box, (*tree)->place, (*tree)->of_facet, *tree);
  *tree = NULL;
}

double um_geometry_facet_tree_size(const struct um_geometry_facet_tree *tree)
{
  return um_vec3_norm(um_vec3_sub(tree->box[1].high, tree->box[1].low));
}

bool um_geometry_facet_tree_visit(const struct um_geometry_facet_tree *tree, uint32_t facet,
                                  double margin, bool (*visit)(void *user, uint32_t other),
                                  void *user)
{
  const struct box *own = &tree->of_facet[facet];
  size_t stack[DEPTH], n = 0;
  for (stack[n++] = 1; n > 0;) {
    size_t i = stack[--n];
    if (!boxes_touch(&tree->box[i], own, margin)) continue;
    if (i < tree->leaves) {
      stack[n++] = 2 * i + 1;
      stack[n++] = 2 * i;
    } else if (!visit(user, tree->place[i - tree->leaves].facet)) {
      return false;
    }
  }
  return true;
}
