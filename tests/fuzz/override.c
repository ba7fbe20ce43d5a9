/* One text of --set on a small scenario. */
#include <stdlib.h>

#include "tests/fuzz/documents.h"

static const char scenario[] =
    "schema: 1\n"
    "name: small\n"
    "time: {start_utc: 2016-03-20T04:30:00Z, stop_utc: 2016-03-20T04:31:00Z, step_s: 10}\n"
    "orbit:\n"
    "  circular: {altitude_km: 765, beta_deg: 0}\n"
    "attitude:\n"
    "  - fixed: {q_gcrs: [1, 0, 0, 0]}\n"
    "parts:\n"
    "  - name: bus # a comment that stays\n"
    "    box: {size_m: [1, 1, 1]}\n"
    "    outside: black\n"
    "    groups: {\"+x\": {power_W: 3}}\n"
    "bands: {vis: {from_um: 0.4, to_um: 0.7}}\n"
    "effects:\n"
    "  - effect: heater\n"
    "    target: bus\n";

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  char *text = um_fuzz_text(data, size);
  const char *const set[1] = {text};
  documents_try(context, scenario, set, 1);
  free(text);
}
