/* Stations by name: observer.station, then observer.stations. */
#include "model/scenario/station.h"

#include <string.h>

#include "base/core/suggestions.h"

enum um_status um_model_station_find(struct um_context *context,
                                     const struct um_scenario_observer *observer, const char *name,
                                     size_t *out)
{
  const char *own = NULL;
  size_t n = observer != NULL ? observer->stations.count : 0;
  const struct um_scenario_station *other = n > 0 ? observer->stations.items : NULL;
  char names[320] = "", hint[UM_CORE_WORDS_HINT];
  struct um_core_words_guess guess = {.written = name};
  if (observer != NULL && observer->station != NULL) own = observer->station->name;
  *out = 0;
  if (name[0] == '\0' || (own != NULL && strcmp(name, own) == 0)) return UM_OK;
  if (own != NULL) um_core_words_append(names, sizeof names, own);
  if (own != NULL) um_core_words_consider(&guess, own);
  for (size_t i = 0; i < n; i++) {
    *out = i + 1;
    if (other[i].name == NULL) continue;
    if (strcmp(name, other[i].name) == 0) return UM_OK;
    um_core_words_append(names, sizeof names, other[i].name);
    um_core_words_consider(&guess, other[i].name);
  }
  return um_core_fail(context, UM_ERR_INPUT,
                      "the scenario has no station '%.60s'%s; accepted: %s%sempty for the "
                      "observer's (observer.station, observer.stations)",
                      name, um_core_words_hint(&guess, hint), names, names[0] == '\0' ? "" : ", ");
}
