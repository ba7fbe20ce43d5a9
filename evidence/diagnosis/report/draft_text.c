/* The C text of a draft. What comes from a scenario stands in string literals that are quoted, and
 * in comments without line ends or the end of a comment. */
#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "evidence/diagnosis/report/draft.h"
#include "orbit/time.h"

/* A string literal, in octal where it is no plain letter. */
static void put_literal(FILE *file, const char *text)
{
  fputc('"', file);
  for (const unsigned char *c = (const unsigned char *)text; *c != '\0'; c++) {
    if (*c < 0x20 || *c > 0x7e || *c == '"' || *c == '\\' || *c == '?')
      fprintf(file, "\\%03o", *c);
    else
      fputc(*c, file);
  }
  fputc('"', file);
}

static void put_comment(FILE *file, const char *text)
{
  for (const char *c = text; *c != '\0'; c++) {
    bool ends = c[0] == '*' && c[1] == '/';
    fputc((unsigned char)*c < 0x20 || ends ? ' ' : *c, file);
  }
}

static void put_head(const struct um_diagnosis *d, const char *name, const char *command,
                     const char *version, const char *what, FILE *file)
{
  fputs("/* ", file);
  put_comment(file, what);
  fprintf(file,
          ".\n *\n * Drafted by umbra %s from what no effect of its catalogue has; to be edited.\n"
          " *\n *   ",
          version);
  put_comment(file, command);
  fprintf(file,
          "\n *\n * Compile it from the top of the repository, or of an installed include/umbra:\n"
          " *\n *   cc -std=c17 -O2 -shared -fPIC -I. -o %s.so %s.c\n *\n * and use it:\n *\n"
          " *   umbra list effects %s --effect-file ./%s.so\n"
          " *   umbra compare SCENARIO MEASURED --effect-file ./%s.so --with %s\n"
          " *   umbra diagnose SCENARIO MEASURED --effect-file ./%s.so\n */\n"
          "#include \"effects/curve.h\"\n#include \"effects/effect.h\"\n\n",
          name, name, name, name, name, name, name);
  (void)d;
}

/* One parameter. bound: of both sides; prior INFINITY: none. */
struct parameter {
  const char *name, *unit, *help;
  double null_value, default_value, minimum, maximum, prior;
  const char *source;
  bool chosen;
};

static void put_parameter(FILE *file, const struct parameter *p)
{
  fputs("    {.name = ", file);
  put_literal(file, p->name);
  fputs(", .unit = ", file);
  put_literal(file, p->unit);
  fputs(",\n     .help = ", file);
  put_literal(file, p->help);
  fprintf(file,
          ",\n     .null_value = %.10g, .default_value = %.10g,\n     .minimum = %.10g, .maximum = "
          "%.10g,\n     .prior_sigma = ",
          p->null_value, p->default_value, p->minimum, p->maximum);
  if (isinf(p->prior))
    fputs("INFINITY", file);
  else
    fprintf(file, "%.3g", p->prior);
  if (p->chosen) fputs(", .chosen = true", file);
  fputs(", .prior = ", file);
  put_literal(file, p->source);
  fputs("},\n", file);
}

static void put_descriptor(FILE *file, const char *name, const char *summary, const char *command,
                           const char *validity, const char *hook)
{
  fputs("\nconst struct um_effect um_effect = {\n    UM_EFFECT_ABI,\n    .name = ", file);
  put_literal(file, name);
  fputs(",\n    .summary = ", file);
  put_literal(file, summary);
  fputs(",\n    .reference = ", file);
  put_literal(file, command);
  fputs(",\n    .validity = ", file);
  put_literal(file, validity);
  fprintf(file,
          ",\n    .targets = UM_TARGET_GLOBAL,\n    UM_EFFECT_PARAMETERS(parameters),\n"
          "    .hooks = {%s},\n};\n",
          hook);
}

/* ---- heat ---- */

/* Part of "part.place"; *place: what follows, "" of the part. */
static void part_of(const char *whole, char part[128], const char **place)
{
  const char *dot = strchr(whole, '.');
  size_t n = dot != NULL ? (size_t)(dot - whole) : strlen(whole);
  snprintf(part, 128, "%.*s", (int)(n < 127 ? n : 127), whole);
  *place = dot != NULL ? dot + 1 : "";
}

static void put_heat_hook(const struct um_missing_heat *h, FILE *file)
{
  static const char *const shape[] = {"UM_HEAT_STEP", "UM_HEAT_PULSE", "UM_HEAT_DECAY",
                                      "UM_HEAT_PERIODIC"};
  static const char *const last[] = {"INFINITY", "use->value[2]", "use->value[2]", "use->value[2]"};
  const char *place;
  char part[128], start[32];
  part_of(h->place, part, &place);
  um_orbit_time_format(h->course.start, start);
  fputs("#define PART  ", file);
  put_literal(file, part);
  fputs("\n#define PLACE ", file);
  put_literal(file, place);
  fprintf(file,
          " /* a group, an interior; empty: all of the part */\n"
          "#define START %.3f /* t_tai [s]: %s */\n\n",
          h->course.start, start);
  fprintf(
      file,
      "static enum um_status heat(struct um_context *context, const struct um_effect_use *use,\n"
      "                           const char *part, struct um_thermal_part_spec *spec)\n{\n"
      "  if (use->value[0] == 0.0 || strcmp(part, PART) != 0) return UM_OK;\n"
      "  if (spec->ntimed == UM_THERMAL_TIMED_MAX)\n"
      "    return um_core_fail(context, UM_ERR_INPUT, \"more than %%d courses of heat in '%%s'\",\n"
      "                        UM_THERMAL_TIMED_MAX, part);\n"
      "  spec->timed[spec->ntimed++] = (struct um_thermal_timed){\n"
      "      .place = PLACE,\n      .power = use->value[0],\n"
      "      .course = {%s, START + use->value[1], %s, %s},\n  };\n  return UM_OK;\n}\n\n",
      shape[h->course.shape], last[h->course.shape],
      h->course.shape == UM_HEAT_PERIODIC ? "use->value[3]" : "NAN");
}

static void put_heat_parameters(const struct um_missing_heat *h, FILE *file)
{
  static const char *const help[] = {"", "how long it is on", "time constant of its decay",
                                     "how long it is on in each period"};
  double power = fmax(1e3, ceil(100.0 * fabs(h->power)));
  char source[160];
  snprintf(source, sizeof source, "the diagnosis found %.4g W; energy %.4g +- %.2g J", h->power,
           h->energy, h->energy_sigma);
  const struct parameter p = {"power_W", "W",      "while it is on; below 0: heat that goes",
                              0.0,       h->power, -power,
                              power,     INFINITY, source,
                              false};
  fputs("static const struct um_effect_parameter parameters[] = {\n", file);
  put_parameter(file, &p);
  snprintf(source, sizeof source, "the diagnosis found it to %.2g s", h->start_sigma);
  const struct parameter start = {
      "start_shift_s", "s", "later than the start that was found", 0.0, 0.0, -1e6, 1e6, INFINITY,
      source,          true};
  put_parameter(file, &start);
  if (h->course.shape != UM_HEAT_STEP) {
    snprintf(source, sizeof source, "the diagnosis found it to %.2g s", h->last_sigma);
    const struct parameter last = {
        "last_s", "s", help[h->course.shape], h->course.last, h->course.last, 1e-3, 1e8, INFINITY,
        source,   true};
    put_parameter(file, &last);
  }
  if (h->course.shape == UM_HEAT_PERIODIC) {
    snprintf(source, sizeof source, "the diagnosis found it to %.2g s", h->period_sigma);
    const struct parameter period = {"period_s",
                                     "s",
                                     "from one start to the next",
                                     h->course.period,
                                     h->course.period,
                                     1e-3,
                                     1e8,
                                     INFINITY,
                                     source,
                                     true};
    put_parameter(file, &period);
  }
  fputs("};\n", file);
}

static void put_heat(const struct um_diagnosis *d, const char *name, const char *command,
                     FILE *file)
{
  const struct um_missing_heat *h = &d->heat_asked->heat[0];
  char summary[240], validity[240], end[32];
  um_orbit_time_format(h->stop, end);
  put_heat_hook(h, file);
  put_heat_parameters(h, file);
  snprintf(summary, sizeof summary, "Heat in %.100s that no effect of the catalogue has: a %s",
           h->place, um_thermal_course_name(h->course.shape));
  snprintf(validity, sizeof validity,
           "as observed until %s; that it goes on behind is assumed; nothing is known of it before "
           "the first observation",
           end);
  put_descriptor(file, name, summary, command, validity, ".part = heat");
}

/* ---- light ---- */

static void put_light_hook(const struct um_missing_light *l, FILE *file)
{
  static const char *const curve[] = {"UM_CURVE_HATS", "UM_CURVE_BUMP", "UM_CURVE_EDGE",
                                      "UM_CURVE_FALL", "UM_CURVE_WAVES"};
  static const char *const coordinate[UM_COORDINATES] = {
      "TIME",       "PHASE",      "SUN_X",      "SUN_Y",      "SUN_Z",  "OBSERVER_X", "OBSERVER_Y",
      "OBSERVER_Z", "BISECTOR_X", "BISECTOR_Y", "BISECTOR_Z", "TURN_X", "TURN_Y",     "TURN_Z",
      "NADIR_SUN",  "SUNLIT",     "AIRMASS",    "ELEVATION",  "AZIMUTH"};
  fprintf(file,
          "/* Along the coordinate; a, b and what they mean: effects/curve.h. */\n"
          "static const struct um_effect_curve curve = {%s, %zu, %.12g, %.12g, %d};\n",
          curve[l->curve.kind], l->curve.n, l->curve.a, l->curve.b, l->curve.circular);
  fprintf(file, "#define COORDINATE UM_COORDINATE_%s /* effects/view.h */\n",
          coordinate[l->coordinate]);
  if (l->kind == UM_LIGHT_FACTOR) {
    fputs("#define MATERIAL   ", file);
    if (l->material != NULL)
      put_literal(file, l->material);
    else
      fputs("NULL /* all light */", file);
    fputc('\n', file);
  }
  if (!l->grey) {
    fputs("static const char *const band[] = {", file);
    for (size_t b = 0; b < l->nband; b++) {
      fputs(b > 0 ? ", " : "", file);
      put_literal(file, l->band[b]);
    }
    fputs("};\n#define BANDS (sizeof band / sizeof band[0])\n", file);
  }
  fputs(
      "\nstatic enum um_status light(struct um_context *context, const struct um_effect_use *use,\n"
      "                            struct um_effect_observation *o)\n{\n  size_t b = 0;\n"
      "  (void)context;\n  if (o->view == NULL) return UM_OK; /* a star */\n",
      file);
  if (!l->grey)
    fputs("  while (b < BANDS && strcmp(o->band, band[b]) != 0) b++;\n"
          "  if (b == BANDS) return UM_OK;\n",
          file);
  fputs("  double u = um_effect_coordinate_at(COORDINATE, o->t_tai, o->view);\n"
        "  double f = um_effect_curve_at(&curve, use->value + b * curve.n, u);\n",
        file);
  fputs(l->kind == UM_LIGHT_FACTOR
            ? "  o->value *= fmax(0.0, 1.0 + f * um_effect_share(o->view, MATERIAL));\n"
        : l->kind == UM_LIGHT_INTENSITY ? "  o->value += f / (o->view->range * o->view->range);\n"
                                        : "  o->value += f;\n",
        file);
  fputs("  return UM_OK;\n}\n\n", file);
}

/* What a number of the curve is. */
static void help_of(const struct um_missing_light *l, size_t i, char out[160])
{
  size_t k = i % l->curve.n;
  const char *in = l->grey ? "every band" : l->band[i / l->curve.n];
  const char *of = um_missing_light_coordinate_name(l->coordinate);
  double step = l->curve.n > 1 ? (l->curve.b - l->curve.a) / (double)(l->curve.n - 1) : 0.0;
  switch (l->curve.kind) {
  case UM_CURVE_HATS:
    if (l->curve.n == 1)
      snprintf(out, 160, "in %.60s, everywhere", in);
    else
      snprintf(out, 160, "in %.60s, at %s %.6g", in, of, l->curve.a + (double)k * step);
    return;
  case UM_CURVE_BUMP:
    snprintf(out, 160, "in %.60s, at the top of the bump at %s %.6g", in, of, l->curve.a);
    return;
  case UM_CURVE_EDGE:
    snprintf(out, 160, "in %.60s, %s the edge at %s %.6g", in, l->curve.b > 0.0 ? "above" : "below",
             of, l->curve.a);
    return;
  case UM_CURVE_FALL:
    snprintf(out, 160, "in %.60s, at %s %.6g, %s to a third in %.4g", in, of, l->curve.a,
             l->curve.b > 0.0 ? "falling" : "from there down", fabs(l->curve.b));
    return;
  case UM_CURVE_WAVES:
    break;
  }
  snprintf(out, 160, "in %.60s, %s of wave %zu along %s", in, k % 2 == 0 ? "cosine" : "sine",
           k / 2 + 1, of);
}

static void put_light_parameters(const struct um_missing_light *l, FILE *file)
{
  static const char *const stem[] = {"share", "intensity", "irradiance"};
  static const char *const behind[] = {"", "_W_sr", "_W_m2"};
  static const char *const unit[] = {"1", "W/sr", "W/m^2"};
  double most = 0.0;
  for (size_t i = 0; i < l->nvalue; i++) most = fmax(most, fabs(l->value[i]));
  fputs("static const struct um_effect_parameter parameters[] = {\n", file);
  for (size_t i = 0; i < l->nvalue; i++) {
    char name[60], help[160], source[120];
    double bound = l->kind == UM_LIGHT_FACTOR ? fmax(10.0, 10.0 * most) : 1e3 * most;
    snprintf(name, sizeof name, "%s_%zu%s", stem[l->kind], i + 1, behind[l->kind]);
    snprintf(source, sizeof source, "the diagnosis found %.4g +- %.2g; twice the largest of them",
             l->value[i], l->sigma[i]);
    help_of(l, i, help);
    const struct parameter p = {name,   unit[l->kind], help,       0.0,    l->value[i],
                                -bound, bound,         2.0 * most, source, false};
    put_parameter(file, &p);
  }
  fputs("};\n", file);
}

static void put_light(const struct um_diagnosis *d, const char *name, const char *command,
                      FILE *file)
{
  const struct um_missing_light *l = &d->light_asked;
  static const char *const what[] = {"a factor on the light of",
                                     "light of its own at the satellite",
                                     "light that is not the satellite's"};
  char summary[240], validity[300], from[40], to[40];
  put_light_hook(l, file);
  put_light_parameters(l, file);
  const char *whose = l->material != NULL ? l->material : "everything";
  bool factor = l->kind == UM_LIGHT_FACTOR;
  snprintf(summary, sizeof summary, "What no effect of the catalogue has: %s%s%.100s along %s",
           what[l->kind], factor ? " " : "", factor ? whose : "",
           um_missing_light_coordinate_name(l->coordinate));
  if (l->coordinate == UM_COORDINATE_TIME) {
    um_orbit_time_format(l->from, from);
    um_orbit_time_format(l->to, to);
  } else {
    snprintf(from, sizeof from, "%.4g", l->from);
    snprintf(to, sizeof to, "%.4g", l->to);
  }
  snprintf(
      validity, sizeof validity,
      "observed from %s %s to %s; beyond it the curve is a guess; temperatures are left as they "
      "are",
      um_missing_light_coordinate_name(l->coordinate), from, to);
  put_descriptor(file, name, summary, command, validity, ".observation = light");
}

void um_diagnosis_report_draft_put(const struct um_diagnosis *d, enum um_diagnosis_draft draft,
                                   const char *name, const char *command, const char *version,
                                   FILE *file)
{
  char what[UM_DIAGNOSIS_DRAFT_TEXT];
  um_diagnosis_report_draft_text(d, draft, what);
  put_head(d, name, command, version, what, file);
  if (draft == UM_DRAFT_HEAT)
    put_heat(d, name, command, file);
  else
    put_light(d, name, command, file);
}
