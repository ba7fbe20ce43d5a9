/* umbra completion: a script for bash, or for zsh by its bashcompinit, written from the tables of
 * verbs and options, and of the names that the library has. */
#include <stdlib.h>
#include <string.h>

#include "app/client.h"
#include "base/core/json.h"

/* What COMPREPLY becomes for a kind of argument; a line of the script. Names stand in variables. */
static const char *offer(enum um_app_offers offers)
{
  switch (offers) {
  case UM_APP_NOTHING:
    return ":";
  case UM_APP_FILES:
  case UM_APP_VIEWS:
    return "_umbra_files ''";
  case UM_APP_FOLDERS:
  case UM_APP_RESULTS:
    return "_umbra_files /";
  case UM_APP_SCENARIOS:
  case UM_APP_STUDIES:
    return "_umbra_files .yaml";
  case UM_APP_TABLES:
    return "_umbra_files .csv";
  case UM_APP_REPLAYS:
    return "_umbra_files .json";
  case UM_APP_EFFECTS:
    return "_umbra_words \"$effects\"";
  case UM_APP_MATERIALS:
    return "_umbra_words \"$materials\"";
  case UM_APP_SENSORS:
    return "_umbra_words \"$sensors\"";
  case UM_APP_SECTIONS:
    return "_umbra_words \"$sections\"";
  case UM_APP_SHELLS:
    return "_umbra_words \"bash zsh\"";
  case UM_APP_FILTERS:
    return "_umbra_words \"$filters\"";
  case UM_APP_SHIPPED:
    return "_umbra_words \"$shipped\"";
  case UM_APP_THINGS:
    return "_umbra_words \"$things\"";
  case UM_APP_ONE:
    return "_umbra_one \"$first\"";
  case UM_APP_EXPORTS:
    return "_umbra_words \"$exports\"";
  case UM_APP_VERBS:
    return "_umbra_words \"$verbs\"";
  }
  return ":";
}

/* What the script knows by name beside effects and keys. */
struct names {
  struct um_context *context; /* for what the library has no names of */
  const struct umbra *umbra;
  const char *const *material, *const *sensor;
  size_t nmaterial, nsensor;
};

static void put_names(FILE *file, const struct names *names)
{
  const struct umbra *umbra = names->umbra;
  fputs("  local verbs=\"", file);
  for (size_t i = 0; i < um_app_verb_count(); i++)
    fprintf(file, "%s%s", i > 0 ? " " : "", um_app_verb_at(i)->name);
  fputs("\"\n  local exports=\"", file);
  for (size_t i = 0; um_app_export_name(i) != NULL; i++)
    fprintf(file, "%s%s", i > 0 ? " " : "", um_app_export_name(i));
  fputs("\"\n  local effects=\"", file);
  for (size_t i = 0; umbra_effect_at(umbra, i) != NULL; i++)
    fprintf(file, "%s%s", i > 0 ? " " : "", umbra_effect_at(umbra, i)->name);
  fputs("\"\n  local materials=\"", file);
  for (size_t i = 0; i < names->nmaterial; i++)
    fprintf(file, "%s%s", i > 0 ? " " : "", names->material[i]);
  fputs("\"\n  local sensors=\"", file);
  for (size_t i = 0; i < names->nsensor; i++)
    fprintf(file, "%s%s", i > 0 ? " " : "", names->sensor[i]);
  fputs("\"\n  local filters=\"", file);
  um_app_filters_put(names->context, file);
  fputs("\"\n  local shipped=\"", file);
  um_app_scenarios_put(names->context, file);
  fputs("\"\n  local things=\"", file);
  for (size_t i = 0; um_app_thing_at(i) != NULL; i++)
    fprintf(file, "%s%s", i > 0 ? " " : "", um_app_thing_at(i)->word);
  fputs("\"\n  local sections=\"", file);
  for (size_t i = 0; umbra_key_at(umbra, i) != NULL; i++)
    fprintf(file, "%s\n", umbra_key_at(umbra, i)->path);
  fputs("\"\n", file);
}

static void put_list(FILE *file, const char *list)
{
  const struct um_app_option *o;
  while ((o = um_app_option_next(&list)) != NULL) {
    fprintf(file, " --%s", o->name);
    if (o->letter != 0) fprintf(file, " -%c", o->letter);
  }
}

/* A value follows such an option, for instance "run:--out|run:-o)". */
static void put_values(FILE *file, const struct um_app_verb *verb, const char *list)
{
  const struct um_app_option *o;
  while ((o = um_app_option_next(&list)) != NULL) {
    if (o->argument == NULL) continue;
    fprintf(file, "    %s:--%s", verb->name, o->name);
    if (o->letter != 0) fprintf(file, "|%s:-%c", verb->name, o->letter);
    fprintf(file, ") %s; return ;;\n", offer(o->offers));
  }
}

static void put_verb(FILE *file, const struct um_app_verb *verb)
{
  const char *list = verb->arguments;
  char name[32];
  bool optional;
  fprintf(file, "    %s) options=\"", verb->name);
  put_list(file, verb->needs);
  put_list(file, verb->accepts);
  put_list(file, um_app_verb_common(verb));
  fputs("\"; kinds=(", file);
  while (um_app_argument_next(&list, name, &optional))
    fprintf(file, " '%s'", offer(um_app_argument_offers(name)));
  fputs(um_app_verb_takes_more(verb) ? " ); more=yes ;;\n" : " ) ;;\n", file);
}

static const char helpers[] =
    "_umbra_words() { COMPREPLY=($(compgen -W \"$1\" -- \"$word\")); }\n"
    "# Files that end in $1, and folders; $1 = /: folders alone. A name a line, blanks kept.\n"
    "_umbra_files() {\n"
    "  local name\n"
    "  COMPREPLY=()\n"
    "  while IFS= read -r name; do\n"
    "    if [ -d \"$name\" ]; then COMPREPLY+=(\"$name/\")\n"
    "    elif [ \"$1\" != / ] && [ \"${name%\"$1\"}$1\" = \"$name\" ]; then "
    "COMPREPLY+=(\"$name\"); fi\n"
    "  done < <(compgen -f -- \"$word\")\n"
    "  [ ${#COMPREPLY[@]} -ne 1 ] || [ \"${COMPREPLY[0]%/}\" = \"${COMPREPLY[0]}\" ] || "
    "compopt -o nospace 2>/dev/null || :\n"
    "}\n"
    "# Is the option $1 followed by a value?\n";

static const char body[] =
    "  local word=\"${COMP_WORDS[COMP_CWORD]}\" before=\"${COMP_WORDS[COMP_CWORD-1]}\"\n"
    "  local verb=\"${COMP_WORDS[1]}\" options=\"\" first=\"\" more=\"\" place=0 i\n"
    "  local -a kinds=()\n"
    "  COMPREPLY=()\n"
    "  # --option=value comes as three words\n"
    "  if [ \"$word\" = = ]; then word=\"\"\n"
    "  elif [ \"$before\" = = ]; then before=\"${COMP_WORDS[COMP_CWORD-2]}\"; fi\n"
    "  if [ \"$COMP_CWORD\" -eq 1 ]; then _umbra_words \"$verbs --help --version\"; return; fi\n"
    "  case \"$verb:$before\" in\n";

static const char tail[] =
    "  if [ \"${word#-}\" != \"$word\" ]; then _umbra_words \"$options\"; return; fi\n"
    "  for ((i = 2; i < COMP_CWORD; i++)); do\n"
    "    case \"${COMP_WORDS[i]}\" in\n"
    "      -*) if _umbra_takes_value \"${COMP_WORDS[i]}\"; then i=$((i + 1)); fi ;;\n"
    "      *) [ $place -gt 0 ] || first=\"${COMP_WORDS[i]}\"; place=$((place + 1)) ;;\n"
    "    esac\n"
    "  done\n"
    "  if [ -n \"$more\" ] && [ $place -ge ${#kinds[@]} ]; then place=$((${#kinds[@]} - 1)); fi\n"
    "  if [ $place -lt ${#kinds[@]} ]; then eval \"${kinds[@]:$place:1}\"; fi\n"
    "}\n";

static void put_takes_value(FILE *file)
{
  const struct um_app_option *o;
  fputs("_umbra_takes_value() {\n  case \"$1\" in\n    -o", file);
  for (size_t i = 0; (o = um_app_option_at(i)) != NULL; i++)
    if (o->argument != NULL) fprintf(file, "|--%s", o->name);
  fputs(") return 0 ;;\n  esac\n  return 1\n}\n", file);
}

/* What is offered for the second argument of umbra list, by the first. */
static void put_one(FILE *file)
{
  const struct um_app_thing *thing;
  fputs("_umbra_one() {\n  case \"$1\" in\n", file);
  for (size_t i = 0; (thing = um_app_thing_at(i)) != NULL; i++)
    fprintf(file, "    %s) %s ;;\n", thing->word, offer(thing->offers));
  fputs("  esac\n}\n", file);
}

static void put_script(FILE *file, const struct names *names)
{
  fputs(helpers, file);
  put_takes_value(file);
  put_one(file);
  fputs("_umbra() {\n", file);
  put_names(file, names);
  fputs(body, file);
  for (size_t i = 0; i < um_app_verb_count(); i++) {
    put_values(file, um_app_verb_at(i), um_app_verb_at(i)->needs);
    put_values(file, um_app_verb_at(i), um_app_verb_at(i)->accepts);
    put_values(file, um_app_verb_at(i), um_app_verb_common(um_app_verb_at(i)));
  }
  fputs("  esac\n  case \"$verb\" in\n", file);
  for (size_t i = 0; i < um_app_verb_count(); i++) put_verb(file, um_app_verb_at(i));
  fputs("  esac\n", file);
  fputs(tail, file);
}

static void print(FILE *file, const struct names *names, bool zsh)
{
  if (zsh) fputs("#compdef umbra\nautoload -U +X bashcompinit && bashcompinit\n", file);
  fprintf(file, "# Completion of umbra %s, written by: umbra completion\n", umbra_version());
  put_script(file, names);
  /* zsh loads the file when it is first wanted: that time it has to answer too */
  fputs(zsh ? "complete -o nospace -F _umbra umbra\n"
              "if (( ${+compstate} )); then _bash_complete -o nospace -F _umbra; fi\n"
            : "complete -F _umbra umbra\n",
        file);
}

/* false: no memory. */
static bool print_json(const struct names *names, const char *shell)
{
  char *script = NULL;
  size_t n;
  FILE *file = open_memstream(&script, &n);
  if (file == NULL) return false;
  print(file, names, strcmp(shell, "zsh") == 0);
  bool whole = fclose(file) == 0;
  if (whole) {
    um_core_json_text(stdout, "{", "shell", shell);
    um_core_json_text(stdout, ", ", "script", script);
    printf("}\n");
  }
  free(script);
  return whole;
}

int um_app_completion(struct um_context *context, const struct um_app_options *options)
{
  const char *shell = options->positional[0];
  bool zsh = strcmp(shell, "zsh") == 0;
  struct names names;
  struct umbra *umbra;
  if (!zsh && strcmp(shell, "bash") != 0) {
    fprintf(stderr, "umbra: no completion for '%.60s'; accepted: bash, zsh\n", shell);
    return UM_APP_MISUSE;
  }
  int code = um_app_session_open(&umbra);
  if (code != UM_APP_DONE) return code;
  names.context = context;
  names.umbra = umbra;
  if (umbra_data_names(umbra, UMBRA_MATERIALS, &names.material, &names.nmaterial) != UMBRA_OK ||
      umbra_data_names(umbra, UMBRA_SENSORS, &names.sensor, &names.nsensor) != UMBRA_OK)
    code = um_app_session_fail(umbra);
  else if (!options->json)
    print(stdout, &names, zsh);
  else if (!print_json(&names, shell))
    code = UM_APP_FAILED;
  umbra_close(&umbra);
  return code;
}
