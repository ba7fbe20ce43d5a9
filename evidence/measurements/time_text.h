/* Times in words. */
#ifndef UMBRA_COMPARE_TIME_TEXT_H
#define UMBRA_COMPARE_TIME_TEXT_H

/* UTC of a time as messages and files show it: milliseconds, or microseconds where it is not a
 * whole millisecond. */
void um_compare_time_text(double t_tai, char out[40]);

#endif
