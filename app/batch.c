/* Many points: how many processes, which share of them, and whether work is resumed. */
#include "app/batch.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "app/terminal.h"

/* One process a rank where a launcher has placed the ranks. */
static int workers_by_machine(void)
{
  long n = sysconf(_SC_NPROCESSORS_ONLN);
  bool launched = getenv("OMPI_COMM_WORLD_SIZE") != NULL || getenv("PMIX_RANK") != NULL ||
                  getenv("PMI_RANK") != NULL;
  return launched || n < 1 ? 1 : (int)(n > 4096 ? 4096 : n);
}

static enum um_status parse_share(struct um_context *context, const char *text,
                                  struct um_batch_task *task)
{
  char *slash, *end;
  unsigned long k = strtoul(text, &slash, 10), n = *slash == '/' ? strtoul(slash + 1, &end, 10) : 0;
  bool digits = strspn(text, "0123456789/") == strlen(text) && strlen(text) < 20;
  if (!digits || n == 0 || *end != '\0' || k < 1 || k > n)
    return um_core_fail(context, UM_ERR_INPUT,
                        "--share '%s': accepted: K/N with K from 1 to N, e.g. --share 3/16", text);
  task->share = (size_t)k - 1;
  task->nshare = (size_t)n;
  return UM_OK;
}

enum um_status um_app_batch_options(struct um_context *context,
                                    const struct um_app_options *options,
                                    struct um_batch_task *task)
{
  task->work.workers = options->workers > 0 ? options->workers : workers_by_machine();
  task->resume = options->resume;
  um_app_terminal_progress_in_pipes();
  return options->share == NULL ? UM_OK : parse_share(context, options->share, task);
}

enum um_status um_app_batch_records(struct um_context *context, const char *out, char **records)
{
  size_t n = strlen(out);
  while (n > 1 && out[n - 1] == '/') n--;
  return um_core_asprintf(context, records, "%.*s.records", (int)n, out);
}

int um_app_batch_end(size_t lost, const char *records)
{
  if (lost == 0) return UM_APP_DONE;
  um_app_terminal_clear();
  fprintf(stderr,
          "umbra: %zu point%s missing; the others stay on record in %s: the same command with "
          "--resume computes what is missing\n",
          lost, lost == 1 ? " is" : "s are", records);
  return UM_APP_LOST;
}
