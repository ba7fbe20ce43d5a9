/* The words of a verdict. */
#include "diagnosis/diagnose.h"

const char *um_diagnosis_verdict_name(enum um_diagnosis_verdict verdict)
{
  static const char *const name[] = {"complete", "found", "not_identifiable", "unexplained"};
  return name[verdict];
}
