/* Where results go when --out is not given, and how a command says where they went.
 *
 * out/NAME for a scenario as it is. What the command line changes is another model: it gets a
 * folder of its own, out/NAME--CHANGES, so that a variant never replaces the base it is to be held
 * against. CHANGES is every --set, --with and --without as typed, in that order, with what a file
 * name should not hold turned into '-'; a text that lost something, or is cut, ends in a hash of
 * the whole, so that two different changes never share a folder by that. */
#include <stdint.h>
#include <string.h>
#include <unistd.h>

#include "app/app.h"
#include "base/core/digest.h"
#include "base/page/page.h"

#define SLUG_LENGTH 60 /* of CHANGES without the hash; names of folders end at 255 bytes */

struct slug {
  char text[SLUG_LENGTH + 1];
  size_t length;
  bool lossy;
  uint64_t hash; /* digest so far */
};

static bool is_kept(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         (c != '\0' && strchr("._=+-", c) != NULL);
}

static void put(struct slug *slug, char c)
{
  bool kept = is_kept(c);
  slug->hash = um_core_digest(slug->hash, &c, 1);
  slug->lossy = slug->lossy || !kept || slug->length == SLUG_LENGTH;
  if (slug->length < SLUG_LENGTH) slug->text[slug->length++] = kept ? c : '-';
}

static void put_list(struct slug *slug, const char *option, const char *const *texts, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    for (const char *c = option; *c != '\0'; c++) put(slug, *c);
    for (const char *c = texts[i]; *c != '\0'; c++) put(slug, *c);
  }
}

enum um_status um_app_out_folder(struct um_context *context, const struct um_app_options *options,
                                 const char *name, char **out)
{
  struct slug slug = {.hash = UM_CORE_DIGEST_BEGIN};
  if (options->out != NULL) return um_core_strdup(context, options->out, out);
  if (options->nset + options->nwith + options->nwithout == 0)
    return um_core_asprintf(context, out, "out/%s", name);
  put_list(&slug, "--set-", options->set, options->nset);
  put_list(&slug, "--with-", options->with, options->nwith);
  put_list(&slug, "--without-", options->without, options->nwithout);
  if (!slug.lossy) return um_core_asprintf(context, out, "out/%s%s", name, slug.text);
  return um_core_asprintf(context, out, "out/%s%s-%08x", name, slug.text,
                          (unsigned)(slug.hash ^ (slug.hash >> 32)) & 0xffffffffU);
}

void um_app_tell_results(const char *folder)
{
  char path[4096];
  int n = snprintf(path, sizeof path, "%s/%s", folder, UM_PAGE_FILE);
  printf("results in %s\n", folder);
  if (n > 0 && (size_t)n < sizeof path && access(path, R_OK) == 0) printf("to look at: %s\n", path);
}
