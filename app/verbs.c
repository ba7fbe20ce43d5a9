/* The verbs of the command: what each takes, says and does. */
#include <string.h>

#include "app/app.h"
#include "base/core/suggestions.h"

#define CHANGES "set with without effect-file allow-effects"
#define RESULTS "force no-plots"

static const struct um_app_verb verbs[] = {
    {"new", "NAME", "a folder with a commented scenario to begin with",
     .accepts = "from-mesh tle one-station",
     .about = "A 3U CubeSat that leaves the Earth's shadow over a telescope, ready to run; with "
              "--from the parts are those of a mesh, with --tle the orbit is that of a satellite. "
              "NAME must not exist. docs/obj.md says how meshes are read.",
     .examples = "umbra new mine\n"
                 "umbra new mine --from satellite.obj --tle satellite.tle --station "
                 "Graz,47.067,15.493,495\n",
     .run = um_app_new, .group = UM_APP_SIMULATE, .unrecorded = true},
    {"run", "SCENARIO", "light curves and temperatures of a scenario",
     .accepts = "out " CHANGES " picture " RESULTS,
     .about = "Computes the geometry, the heat and the light of every instant and writes tables, "
              "netCDF and pictures.",
     .examples = "umbra run scenarios/envisat-graz-2016\n"
                 "umbra run scenarios/envisat-graz-2016 --without albedo --out out/dark-earth\n",
     .run = um_app_run, .group = UM_APP_SIMULATE},
    {"check", "SCENARIO", "read a scenario and report what was understood",
     .accepts = CHANGES " view out force",
     .about =
         "Parts, areas, watertightness, materials and nodes; nothing is solved. --view writes a "
         "page that shows the satellite.",
     .examples = "umbra check scenarios/cube\numbra check scenarios/envisat-graz-2016 --view\n",
     .run = um_app_check, .group = UM_APP_SIMULATE},
    {"cases", "SCENARIO", "hot, cold and other cases, against limits of temperature",
     .accepts = "out " CHANGES " " RESULTS,
     .about = "The scenario's cases, each with its changes: extremes of an orbit, balance under an "
              "orbit's mean heat, or balance of an instant. A table of margins, limits.csv and a "
              "picture. Exit status 4 where a limit is exceeded.",
     .examples = "umbra cases scenarios/cube\n", .run = um_app_cases, .group = UM_APP_SIMULATE},
    {"export", "SCENARIO", "meshes, orbits, heat networks of a scenario for other programs",
     .needs = "as", .accepts = "target " CHANGES " force",
     .about = "The environment variable UMBRA_CACHE names a folder where view factors are kept "
              "between runs.",
     .examples =
         "umbra export scenarios/envisat-graz-2016 --as mesh -o envisat.obj\n"
         "umbra export scenarios/envisat-graz-2016 --as trajectory -o out/envisat-trajectory\n"
         "umbra export scenarios/cube --as network -o out/network\n",
     .listed = "Kinds", .list = um_app_export_list, .run = um_app_export, .group = UM_APP_SIMULATE},
    {"forecast", "SCENARIO", "passes over days: when, how bright, how warm",
     .accepts = "times out days from station minimum-elevation uncertain " CHANGES
                " workers share resume " RESULTS,
     .about =
         "Computes every pass of the station, or of several, and writes passes.csv, curves.csv, "
         "a calendar (passes.ics) and a picture: rise, culmination, set, shadow, magnitude, "
         "infrared signal, temperatures, and whether the sky is dark. With --times it prints the "
         "times alone, in a second; with --uncertain each with "
         "its error bar. Passes that are done are "
         "on record beside the results until these are written, so that --resume goes on. "
         "Under mpirun or srun all processes compute.",
     .examples = "umbra forecast scenarios/envisat-graz-2016 --times\n"
                 "umbra forecast scenarios/envisat-graz-2016 --days 3 --set time.step_s=10\n"
                 "umbra forecast scenarios/envisat-graz-2016 --station Graz,47.067,15.493,495 "
                 "--station Zimmerwald,46.877,7.465,951\n"
                 "umbra forecast scenarios/envisat-graz-2016 --uncertain emittance:mli_kapton=0.05 "
                 "--uncertain internal_power:bus=20\n"
                 "mpirun -n 4 umbra forecast scenarios/envisat-graz-2016 --days 30\n",
     .run = um_app_forecast, .group = UM_APP_OBSERVE},
    {"render", "SCENARIO|PICTURE.nc", "a picture of one instant: OpenEXR, factored, or FITS",
     .needs = "file",
     .accepts = "time band sensor " CHANGES
                " width samples wavelengths tile psf motion frame-star border frame-seed no-plots "
                "force",
     .about =
         "The names say what is made.\n"
         "FILE.exr, with --time and --band: spectral radiance of every wavelength, and a preview "
         "in "
         "red, green and blue.\n"
         "FILE.nc, with the same: factored, what pixels see apart from the spectra of it. 5000 x "
         "5000 pixels at 2000 wavelengths take some megabytes.\n"
         "FILE.fits, with --time and --sensor: what a detector records, with the counts of umbra "
         "run, spread by optics and air, smeared by motion, with sky, noise and saturation.\n"
         "FILE.exr of a PICTURE.nc: that picture, or wavelengths or a tile of it.\n"
         "What a picture in .exr or .nc will cost is said first.",
     .examples =
         "umbra render scenarios/envisat-graz-2016 --time 2016-09-21T20:40:00Z --band lwir -o "
         "envisat.exr\n"
         "umbra render scenarios/envisat-graz-2016 --time 2016-09-21T20:40:00Z --band lwir --width "
         "5000 --set bands.lwir.bins=2000 -o envisat.nc\n"
         "umbra render envisat.nc --wavelengths 8-8.1um -o short.exr\n"
         "umbra render envisat.nc --tile 2000,1500,512,512 -o array.exr\n"
         "umbra render scenarios/flying-laptop --time 2019-07-23T20:47:00Z --sensor ufo --seed 1 "
         "-o ufo.fits\n",
     .run = um_app_render, .group = UM_APP_OBSERVE},
    {"photometry", "FRAME...", "counts of an object, or of stars, on FITS frames",
     .needs = "aperture file", .accepts = "at sky star force",
     .about = "What a circle holds above the sky of a ring about it, with the error of the CCD "
              "equation, as a measurement file with a count_rate of every frame.",
     .examples =
         "umbra photometry night-*.fits --aperture 6,9,14 -o measured.csv\n"
         "umbra photometry night-*.fits --aperture 6,9,14 --star 8.2,131.5,40 -o stars.csv\n",
     .run = um_app_photometry, .group = UM_APP_OBSERVE},
    {"calibrate", "SCENARIO STARS [MEASURED]", "a telescope's factor and extinction from stars",
     .needs = "sensor", .accepts = "file extinction " CHANGES " force",
     .about = "Applied to measured counts. Counts of stars beside those that the scenario's sensor "
              "predicts, fitted against "
              "airmass: -2.5 log10(measured/predicted) = -2.5 log10 kappa + k X. count_rate of the "
              "sensor in MEASURED is divided by that factor at its own airmass.",
     .examples = "umbra calibrate scenarios/flying-laptop stars.csv measured.csv --sensor ufo -o "
                 "calibrated.csv\n",
     .run = um_app_calibrate, .group = UM_APP_OBSERVE},
    {"compare", "SCENARIO [MEASURED...]", "a scenario beside measurements: how far off, and when",
     .accepts = "out " CHANGES " " RESULTS,
     .about =
         "Metrics per channel and segment, residuals and what they correlate with, the worst "
         "intervals and pictures. "
         "docs/files.md lists the columns of the measurement file. Several files are sets of one "
         "satellite.",
     .examples = "umbra compare scenarios/hidden-effect/dawn measured.csv\n", .run = um_app_compare,
     .group = UM_APP_COMPARE},
    {"study", "STUDY", "many points of a scenario: parameters, designs, surrogates",
     .accepts = "out check measured workers share resume " CHANGES " force",
     .about = "STUDY is a study.yaml: which keys, properties of materials or parameters of effects "
              "are moved, between which values, and what is wanted. docs/files.md has its keys. "
              "Geometry, view factors and heat are computed once for all points that have them in "
              "common. Finished points are safe beside DIR, in DIR.points, until the results are "
              "written: after an end of any kind --resume goes on.",
     .examples = "umbra study scenarios/envisat-graz-2016/study.yaml --check\n"
                 "umbra study scenarios/envisat-graz-2016/study.yaml --out out/cells --workers 2\n",
     .run = um_app_study, .group = UM_APP_EXPLORE},
    {"sensitivity", "SCENARIO", "how light and temperatures move with every parameter",
     .accepts = "out " CHANGES " only exclude data what-if elasticity " RESULTS,
     .about = "Of every effect: the matrix of derivatives of every band and place at every "
              "instant, each with its "
              "error: a table of the largest effects and who leads in each minute, "
              "sensitivity.nc, parameters.csv, sensitivity.csv and a picture.",
     .examples = "umbra sensitivity scenarios/hidden-effect/dawn\n"
                 "umbra sensitivity scenarios/hidden-effect/dawn --only emittance --what-if "
                 "emittance:mli,factor=1.1\n",
     .run = um_app_sensitivity, .group = UM_APP_EXPLORE},
    {"diagnose", "SCENARIO [MEASURED...]",
     "which effect the scenario lacks, or that it cannot be told",
     .accepts = "out " CHANGES
                " only exclude nuisance level steps passes draft-effect resume details " RESULTS,
     .about =
         "The verdict is complete, found, not_identifiable or unexplained, with what else it could "
         "be and what to measure next. Several files are sets of one satellite: what is done to "
         "measurements is a matter of each, as zero_point:vis@night1. What is computed is kept on "
         "record beside the results until "
         "these are written: after an end of any kind --resume goes on.",
     .examples = "umbra diagnose scenarios/hidden-effect/dawn measured.csv --nuisance "
                 "zero_point:lwir,sigma=0.05\n",
     .run = um_app_diagnose, .group = UM_APP_COMPARE},
    {"fit", "SCENARIO [MEASURED...]", "parameters of chosen effects, fitted to measurements",
     .needs = "add",
     .accepts = "out " CHANGES " nuisance posterior draws draw-seed resume details " RESULTS,
     .about = "Values with their uncertainty, and a scenario with them in improved/. Where what is "
              "left is not noise of the stated sigma, the noise is estimated and said. With "
              "--posterior posterior.csv has draws of all values together, the picture posterior "
              "shows them, and posterior_curves.csv has where the curves lie.",
     .examples = "umbra fit scenarios/hidden-effect/dawn measured.csv --add albedo_level\n"
                 "umbra fit scenarios/hidden-effect/dawn measured.csv --add albedo_level "
                 "--posterior\n",
     .run = um_app_fit, .group = UM_APP_COMPARE},
    {"retrieve", "SCENARIO MEASURED", "a grey body fitted to three thermal bands or more",
     .accepts = "out " CHANGES " force",
     .about =
         "Temperature and infrared cross-section (emissivity times area) of band_irradiance and "
         "radiant_intensity in bands of 3 to 40 um, time by time: one "
         "grey body, and from five bands on two. Range and bands are the scenario's; what the "
         "air takes is not put back.",
     .examples = "umbra retrieve scenarios/envisat-graz-2016 measured.csv\n",
     .run = um_app_retrieve, .group = UM_APP_COMPARE},
    {"map", "SCENARIO [MEASURED]", "what the body reflects, by direction in its own axes",
     .accepts = "out step phase-angles planes map-tolerance " CHANGES " " RESULTS,
     .about =
         "By the direction of the phase vector, which halves the angle between Sun and observer. "
         "map.csv and map.exr hold "
         "the reflectivity [m^2/sr] of every band, refined.csv the nodes added where lobes are "
         "narrow, error.csv how far looking up is off, pass.csv the pass looked up there and "
         "computed, measured.csv the measurements as reflectivity. Sunlight alone: no Earth, "
         "no heat.",
     .examples = "umbra map scenarios/flying-laptop --phase-angles 0\n"
                 "umbra map scenarios/envisat-graz-2016 measured.csv --step 1\n",
     .run = um_app_map, .group = UM_APP_COMPARE},
    {"attitude", "SCENARIO MEASURED", "spins that agree with measured light, every solution",
     .accepts =
         "out period axis-step solutions coarse-step own-phase-angles planes map-tolerance " CHANGES
         " force",
     .about =
         "The scenario's law is one spin about an axis of the body; axis_gcrs or axis_lvlh with "
         "its sense, period_s and phase_deg are sought over all directions, by look-up on a "
         "reflectivity "
         "map, and the best fitted with the whole model: sunlight, the Earth's light, light "
         "between surfaces, air. attitude.csv lists what agrees, with how many sigma it stands "
         "apart from the best. Bands that end by 2.5 um, where heat does not show.",
     .examples = "umbra attitude scenarios/envisat-graz-2016 measured.csv --period 210,216\n",
     .run = um_app_attitude, .group = UM_APP_COMPARE},
    {"report", "RESULTS...", "pages of results beside each other, in one page", .needs = "file",
     .accepts = "force",
     .about = "umbra run, compare, study, sensitivity, diagnose and fit write report.html into the "
              "folder of their results. This takes several into one page, where their curves stand "
              "beside each other.",
     .examples = "umbra report out/cold out/hot -o both.html\n", .run = um_app_report,
     .group = UM_APP_COMPARE},
    {"serve", "SCENARIO", "the page of sensitivities in a browser, with a model behind it",
     .accepts = CHANGES " only exclude data port",
     .about =
         "Computes the matrix of umbra sensitivity, then serves its page on this machine alone, "
         "at an address with a token. A slider that leaves the interval in which a straight "
         "line is good has the model computed. Ctrl-C ends it.",
     .examples = "umbra serve scenarios/hidden-effect/dawn --only emittance\n", .run = um_app_serve,
     .group = UM_APP_EXPLORE, .unrecorded = true},
    {"replay", "RECORD", "a command again, from the record beside its results",
     .accepts = "replayed force replayed-effects",
     .about =
         "Every folder of results holds replay.json: the command, the folder in which it was run "
         "and the files that it read. --replay FILE of any command writes the same beside a single "
         "file. Inputs that have changed or are missing are named, and a program of another "
         "version. The results that are there stay. A record from somebody else is a command "
         "of theirs: look at it first.",
     .examples = "umbra replay out/cube\n"
                 "umbra replay measured-replay.json -o measured-again.csv\n",
     .run = um_app_replay, .group = UM_APP_EXPLORE, .unrecorded = true},
    {"synth", "SCENARIO", "measurements made from a scenario, with noise",
     .needs = "noise seed file",
     .accepts = "temperatures temperature-sigma grey-body " CHANGES " force",
     .examples = "umbra synth scenarios/hidden-effect/dawn --with albedo_level,factor=1.2 "
                 "--noise 0.02 --seed 1 -o measured.csv\n",
     .run = um_app_synth, .group = UM_APP_EXPLORE},
    {"period", "MEASURED", "periods of measured light curves",
     .about = "By Lomb-Scargle, and the curves folded at the best.", .accepts = "band out " RESULTS,
     .examples = "umbra period measured.csv --band vis\n", .run = um_app_period,
     .group = UM_APP_COMPARE},
    {"import", "TABLE", "light curves and temperatures of any table as a measurement file",
     .needs = "file",
     .accepts = "column-time column-magnitude column-flux column-counts column-temperature "
                "column-band column-of column-system column-unit column-sigma column-flag "
                "column-exposure column-track like format track-noise force",
     .about = "TABLE has a header of any names, and fields parted by commas, semicolons, tabs or "
              "blanks; options say which column is what, and the file written remembers them for "
              "--like. Without options, a guess of them is printed. Tracks of Mini-MegaTORTORA are "
              "read without options, too.",
     .examples = "umbra import lc.csv --time UTC --magnitude V --sigma Verr -o measured.csv\n"
                 "umbra import tomorrow.csv --like measured.csv -o tomorrow-measured.csv\n"
                 "umbra import telemetry.csv --time t --temperature T_panel_C --of panel.front -o "
                 "panel.csv\n"
                 "umbra import track.txt -o measured.csv --noise 0.02\n",
     .run = um_app_import, .group = UM_APP_OBSERVE},
    {"list", "WHAT [ITEM]", "materials, filters, sensors, effects, keys or scenarios",
     .accepts = "effect-file spectra " RESULTS,
     .about = "What comes with the program, or with effects of your own. With ITEM the "
              "page of one. Of keys ITEM is a path as --set takes it, without names and numbers of "
              "elements or with; --json gives the JSON Schema.",
     .examples = "umbra list scenarios\n"
                 "umbra list materials mli_kapton --out spectrum\n"
                 "umbra list effects panel_extraction\n"
                 "umbra list keys parts.shell\n",
     .run = um_app_list, .group = UM_APP_LOOK_UP},
    {"material", "[MATERIAL]", "a material from measured reflectance or roughness",
     .accepts = "from-brdf half-angle from-profile from-reflectance reference angle",
     .about = "With --from-brdf a fit of measured BRDFs, by kind of lobe, with its error; with "
              "--from-profile the roughness of measured heights; with --from-reflectance a new "
              "record, called MATERIAL, to be written to a file.",
     .examples = "umbra material --from-brdf scenarios/starlink-v15/brdf.csv --half-angle 10\n"
                 "umbra material panel --from-reflectance ratio.csv --reference gold "
                 "--from-profile heights.csv > panel.yaml\n",
     .run = um_app_material, .group = UM_APP_LOOK_UP},
    {"validate", "", "analytic and published cases, expected and computed",
     .accepts = "thermal optics", .about = "Exit status 4 where a case misses its tolerance.",
     .examples = "umbra validate --thermal\n", .run = um_app_validate, .group = UM_APP_LOOK_UP},
    {"completion", "SHELL", "completion of commands, options and names for bash or zsh",
     .examples = "umbra completion bash > ~/.local/share/bash-completion/completions/umbra\n"
                 "source <(umbra completion bash)\n",
     .run = um_app_completion, .group = UM_APP_LOOK_UP, .unrecorded = true},
    {"help", "[COMMAND]", "this list, or a command's options", .examples = "umbra help run\n",
     .run = um_app_help_command, .group = UM_APP_LOOK_UP, .unrecorded = true},
};

bool um_app_verb_takes_more(const struct um_app_verb *verb)
{
  size_t n = strlen(verb->arguments);
  if (n > 0 && verb->arguments[n - 1] == ']') n--;
  return n > 3 && strncmp(verb->arguments + n - 3, "...", 3) == 0;
}

const char *um_app_verb_common(const struct um_app_verb *verb)
{
  return verb->unrecorded ? "json threads help" : "json threads record help";
}

size_t um_app_verb_count(void) { return sizeof verbs / sizeof verbs[0]; }

const struct um_app_verb *um_app_verb_at(size_t index) { return &verbs[index]; }

const struct um_app_verb *um_app_verb_find(const char *name)
{
  for (size_t i = 0; i < um_app_verb_count(); i++)
    if (strcmp(verbs[i].name, name) == 0) return &verbs[i];
  return NULL;
}

void um_app_verb_unknown(const char *name, char out[UM_APP_UNKNOWN])
{
  char hint[UM_CORE_WORDS_HINT];
  struct um_core_words_guess guess = {.written = name};
  for (size_t i = 0; i < um_app_verb_count(); i++) um_core_words_consider(&guess, verbs[i].name);
  snprintf(out, UM_APP_UNKNOWN, "unknown command '%.60s'%s", name,
           um_core_words_hint(&guess, hint));
}
