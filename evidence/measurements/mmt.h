/* Import of survey tracks. */
#ifndef UMBRA_COMPARE_MMT_H
#define UMBRA_COMPARE_MMT_H

#include "evidence/measurements/set.h"

/* What a survey states beside a row. */
struct um_compare_mmt_point {
  double standard_magnitude; /* reduced to a standard place by the survey [mag]; NaN */
  double distance;           /* [m]; NaN */
  double phase;              /* phase angle [rad]; NaN */
  bool penumbra;             /* the survey's own flag */
};

/* Import text tracks of Mini-MegaTORTORA (mmt.favor2.info/satellites; Karpov et al. 2016, RevMexAA
 * Conf. Ser. 48), as that site writes them: '#' lines "# key: value" of which `track` is used,
 * then one '#' line of column names, then rows divided by blanks. Columns by name:
 * Date, Time (UTC), Mag, Filter are needed; StdMag, Penumbra (0 or 1), Distance [km], Phase [deg],
 * Channel (camera), Track, Satellite are optional, others refused.
 *
 * Mag is the apparent magnitude calibrated by field stars, hence exo-atmospheric; it becomes
 * magnitude_vega of the filter's name ("Clear" is light without a filter; the scenario has to
 * have a filter of that name). A track becomes "TRACK/CHANNEL", because each camera
 * has its own zero point and the order in time holds per camera. The file gives neither sigma nor
 * exposure: both are NaN, see um_compare_noise_fill. Penumbra rows are kept and not flagged.
 *
 * points: shape [count of the set], in row order, the caller frees; NULL when not wanted.
 * Refused, one line naming file and line: unreadable, no or unknown columns, a wrong number of
 * fields, non-numeric fields, more than one satellite, and what um_compare_measurements_read
 * refuses between rows. UM_ERR_IO, UM_ERR_INPUT, UM_ERR_MEMORY. The caller destroys the set. */
enum um_status um_compare_mmt_read(struct um_context *context, const char *path,
                                   struct um_compare_measurements **out,
                                   struct um_compare_mmt_point **points);

/* Has the file the '#' line of columns of such a track, Date first, Mag and Filter among them?
 * UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_compare_mmt_is(struct um_context *context, const char *path, bool *out);

#endif
