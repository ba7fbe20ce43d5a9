/* The place of this process among those that a launcher started, by the environment variables of
 * mpirun (OpenMPI, MPICH) and srun. */
#include "base/batch/launch_impl.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

extern char **environ;

/* The first of these variables that is set, as a number; -1: none. */
static long number_of(const char *const *name)
{
  for (; *name != NULL; name++) {
    const char *text = getenv(*name);
    if (text != NULL && *text != '\0') return strtol(text, NULL, 10);
  }
  return -1;
}

void um_batch_launch_told(long *rank, long *size)
{
  static const char *const ranks[] = {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK", NULL};
  static const char *const sizes[] = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS",
                                      NULL};
  static bool looked;
  static long r, n;
  if (!looked) {
    r = number_of(ranks);
    n = number_of(sizes);
  }
  looked = true;
  *rank = r;
  *size = n;
}

void um_batch_launch_forget_stray(void)
{
  static const char address[] = "PMIX_SERVER_URI";
  for (char **each = environ; *each != NULL; each++)
    if (strncmp(*each, address, sizeof address - 1) == 0) return;
  unsetenv("PMIX_NAMESPACE");
  unsetenv("PMIX_RANK");
}
