/* Which part of a pass an observation belongs to. */
#ifndef UMBRA_COMPARE_SEGMENTS_H
#define UMBRA_COMPARE_SEGMENTS_H

#include "model/build/model.h"
#include "model/geometry/tables.h"

/* The first three exclude each other, so do the last two. */
enum um_compare_segment {
  UM_SEGMENT_SUNLIT,   /* the whole disc during the whole exposure */
  UM_SEGMENT_PENUMBRA, /* between the two, or an exposure across an edge */
  UM_SEGMENT_UMBRA,    /* nothing of the disc during the whole exposure */
  UM_SEGMENT_RISING,   /* elevation at the station grows */
  UM_SEGMENT_SETTING,  /* it falls or stands still */
  UM_SEGMENT_COUNT
};
/* "sunlit", ...; borrowed; does not fail. */
const char *um_compare_segment_name(enum um_compare_segment segment);

/* light: shape [nobs], UM_SEGMENT_SUNLIT to UM_SEGMENT_UMBRA. motion: shape [nobs],
 * UM_SEGMENT_RISING or UM_SEGMENT_SETTING; UM_SEGMENT_COUNT where there is no station or no
 * track (orbit.points). Errors of the orbit. */
enum um_status um_compare_segments_find(struct um_context *context, const struct um_model *model,
                                        const struct um_model_tables *tables,
                                        enum um_compare_segment *light,
                                        enum um_compare_segment *motion);

#endif
