/* umbra render: which picture is meant, by the names of what goes in and comes out, and which
 * options go with it. */
#include "app/app.h"
#include "app/picture.h"
#include "app/target.h"

static const struct format {
  const char *what;
  const char *needs, *takes; /* ids of options, beside the file and those of every command */
  um_app_command *run;
} picture = {"a picture of a scenario (-o FILE.exr, FILE.nc)", "time band",
             "set with without effect-file allow-effects width samples wavelengths tile force",
             um_app_render_picture},
  frame = {"a frame of a sensor (-o FILE.fits)", "time sensor",
           "set with without effect-file allow-effects psf motion frame-star border frame-seed "
           "width samples no-plots force",
           um_app_frame},
  part = {"a part of a factored picture (PICTURE.nc -o FILE.exr)", NULL, "wavelengths tile force",
          um_app_expand};

static const struct format *const formats[] = {&picture, &frame, &part};
#define NFORMAT (sizeof formats / sizeof formats[0])

static bool has(const char *list, const struct um_app_option *option)
{
  const struct um_app_option *o;
  while ((o = um_app_option_next(&list)) != NULL)
    if (o == option) return true;
  return false;
}

static bool goes_with(const struct format *format, const struct um_app_option *option)
{
  return has(format->needs, option) || has(format->takes, option);
}

/* A sensor without a name that tells is meant to be a frame. */
static const struct format *format_of(const struct um_app_options *o)
{
  if (um_app_ends_in(o->positional[0], ".nc")) return &part;
  if (um_app_ends_in(o->out, UM_APP_FRAMES)) return &frame;
  if (um_app_ends_in(o->out, UM_APP_PICTURES)) return &picture;
  return o->sensor != NULL ? &frame : &picture;
}

/* "umbra: --psf goes with a frame of a sensor (-o FILE.fits), not with ..." */
static int refuse(const struct format *format, const struct um_app_option *option)
{
  size_t n = 0;
  fprintf(stderr, "umbra: --%s goes with", option->name);
  for (size_t i = 0; i < NFORMAT; i++)
    if (goes_with(formats[i], option))
      fprintf(stderr, "%s %s", n++ > 0 ? " and" : "", formats[i]->what);
  fprintf(stderr, ", not with %s\n", format->what);
  return UM_APP_MISUSE;
}

int um_app_render(struct um_context *context, const struct um_app_options *options)
{
  const struct format *format = format_of(options);
  const struct um_app_option *o;
  for (size_t i = 0; i < NFORMAT; i++) {
    const char *lists[] = {formats[i]->needs, formats[i]->takes};
    for (size_t k = 0; k < 2; k++)
      while ((o = um_app_option_next(&lists[k])) != NULL)
        if (um_app_option_given(o, options) && !goes_with(format, o)) return refuse(format, o);
  }
  int code = um_app_options_require(options, format->needs);
  return code == UM_APP_DONE ? format->run(context, options) : code;
}
