/* What the analyst has: two passes of one satellite, the same with a core switch left out, and
 * small sets of measurements that lack the tie-breaker of a pair of effects, or have it. */
#include <string.h>

#include "tests/lab/lab.h"

#define DUSK .folder = "dusk", .relative = 0.01, .floor = 1e-3
#define DAWN .folder = "dawn", .relative = 0.01, .floor = 1e-3, .kelvin = 0.5
#define PLACES                                                                                     \
  .place = {"bus.interior", "bus.-x", "array.front"}, .filter = {.temperatures_every = 10}
#define GLINTS                                                                                     \
  .folder = "dusk", .relative = 0.005, .floor = 1e-3,                                              \
  .nuisance = "specular_level:cell,sigma=free",                                                    \
  .set = {"attitude.0.spin.period_s=20",                                                           \
          "attitude.0.spin.at_utc=2026-03-20T18:37:30Z",                                           \
          "time.start_utc=2026-03-20T18:44:00Z",                                                   \
          "time.stop_utc=2026-03-20T18:46:50Z",                                                    \
          "time.step_s=1",                                                                         \
          "time.exposure_s=0.3",                                                                   \
          "thermal.start=isothermal",                                                              \
          "thermal.orbits_before=0"}
#define AIR "observer.air={profile: mid_latitude_summer, water_mm: 15}"
#define CAMERA                                                                                     \
  "sensors={camera: {band: vis, aperture_m: 0.3, pixel_arcsec: 1, exposure_s: 1, "                 \
  "saturation_e: 30000}}"
#define WITHOUT(s)                                                                                 \
  {.name = "dusk-" s, DUSK, .without = s}, { .name = "dawn-" s, DAWN, PLACES, .without = s }
#define SPECTRA                                                                                    \
  .set = {"parts.bus.outside=mli_kapton", "parts.array.front=cell_silicon", "parts.array.back=cfrp"}
#define EARTH                                                                                      \
  "environment.earth=knocke", "parts.bus.outside=mli_kapton", "parts.array.front=cell_silicon",    \
      "parts.array.back=cfrp"
/* The array close to the bus: they shade and warm parts of each other, so that one temperature a
 * face and the usual samples would cost the analyst a chi-square of 1100 where hidden light between
 * white walls is worth 360. On facets it is 17. */
#define CLOSE                                                                                      \
  "parts.array.pose.position_m=[0, 1.4, 0]", "parts.bus.lumped=false", "parts.array.lumped=false", \
      "thermal.facet_size_m=0.7", "optics.samples=25"
#define CREASES  "parts.bus.creases={tilt_rms_deg: 5, patch_m: 0.1}"
#define FLATNESS "parts.array.flatness={tilt_rms_deg: 1.5, patch_m: 0.5}"
#define SPECTRAL(s)                                                                                \
  {                                                                                                \
    .name = "dusk-" s, DUSK, .without = s, SPECTRA                                                 \
  }

static const struct lab_world worlds[] = {
    {.name = "dusk", DUSK},
    {.name = "dawn", DAWN, PLACES},
    WITHOUT("albedo"),
    WITHOUT("earth_ir"),
    WITHOUT("earthshine"),
    WITHOUT("reflected_earth_ir"),
    WITHOUT("penumbra"),
    WITHOUT("oblateness"),
    WITHOUT("shadow_refraction"),
    WITHOUT("mutual_radiation"),
    WITHOUT("solar_multiple_reflection"),

    /* Air that is stated; the truth has it, and the analyst no air, or less water and no haze. */
    {.name = "dusk-atmosphere", DUSK, .set = {AIR}, .without = "atmosphere"},
    {.name = "dawn-atmosphere", DAWN, PLACES, .set = {AIR}, .without = "atmosphere"},
    {.name = "dusk-air", DUSK, .set = {AIR}},
    {.name = "dawn-air", DAWN, PLACES, .set = {AIR}},

    /* Counts of a camera whose pixels are full at the glints. */
    {.name = "dusk-camera", DUSK, .set = {CAMERA}},
    {.name = "dusk-saturation", DUSK, .set = {CAMERA}, .without = "saturation"},

    /* Only materials with spectra go with angle and temperature. */
    SPECTRAL("absorptance_angle"),
    SPECTRAL("emittance_temperature"),

    /* Grey records emit, and so reflect in 8-12 um, alike toward all sides. */
    SPECTRAL("earthlight_lobe"),
    {.name = "dawn-earthlight_lobe", DAWN, PLACES, .without = "earthlight_lobe", SPECTRA},

    /* Mirrors beside each other: a bus of silvered FEP. */
    {.name = "dawn-specular_exchange",
     DAWN,
     PLACES,
     .without = "specular_exchange",
     .set = {"parts.bus.outside=fep_silver", CLOSE}},

    /* White walls beside each other, as of paint. */
    {.name = "dawn-inter_reflection",
     DAWN,
     PLACES,
     .without = "inter_reflection",
     .set = {"optics.interreflection_samples=32", "parts.bus.outside=white_paint",
             "parts.array.back=white_paint", CLOSE}},

    /* A night after full Moon, the whole pass in the umbra. */
    {.name = "dusk-moonlight",
     DUSK,
     .without = "moonlight",
     .set = {"time.start_utc=2026-03-04T22:37:30Z", "time.stop_utc=2026-03-04T22:49:54Z"}},

    /* The umbra from behind its edge on, where the Moon is not up. */
    {.name = "dusk-umbra_scatter",
     .folder = "dusk",
     .relative = 0.01,
     .floor = 1e-3,
     .without = "umbra_scatter",
     .set = {"time.start_utc=2026-03-20T18:47:30Z", "time.stop_utc=2026-03-20T18:49:54Z"}},

    /* Rough metal, whose facets throw light at each other. */
    {.name = "dusk-multiple_scattering",
     DUSK,
     .without = "multiple_scattering",
     .set = {"parts.array.front=aluminium_bare", "parts.array.back=copper"}},

    /* Only records with tables store by temperature: an array of sheet aluminium. */
    {.name = "dusk-bulk_temperature",
     DUSK,
     .without = "bulk_temperature",
     .set = {"parts.array.shell={material: aluminium_bare, thickness_mm: 1.6, "
             "through_conductance_W_m2_K: 60}"}},

    /* The truth has Knocke's Earth, the analyst a uniform one. */
    {.name = "dusk-earth_map", DUSK, .set = {"environment.earth=knocke"}, .without = "earth_map"},
    {.name = "dawn-earth_map",
     DAWN,
     PLACES,
     .set = {"environment.earth=knocke"},
     .without = "earth_map"},

    /* An Earth with its own spectrum, of mean cloud to the analyst. */
    {.name = "dusk-earth_spectrum", DUSK, .set = {EARTH}, .without = "earth_spectrum"},
    {.name = "dawn-earth_spectrum", DAWN, PLACES, .set = {EARTH}, .without = "earth_spectrum"},
    {.name = "dusk-earth_anisotropy", DUSK, .set = {EARTH}, .without = "earth_anisotropy"},
    {.name = "dawn-earth_anisotropy", DAWN, PLACES, .set = {EARTH}, .without = "earth_anisotropy"},
    {.name = "dusk-clouds", DUSK, .set = {EARTH}},
    {.name = "dawn-clouds", DAWN, PLACES, .set = {EARTH}},

    /* To the analyst there is hardly anything inside that stores heat. */
    {.name = "dusk-hollow", DUSK, .set = {"parts.bus.interior.capacity_J_K=3000"}},
    {.name = "dawn-hollow", DAWN, PLACES, .set = {"parts.bus.interior.capacity_J_K=3000"}},

    /* Cells that are stated to give something may give less. */
    {.name = "dusk-cells", DUSK, .set = {"parts.array.electrical_extraction=0.18"}},
    {.name = "dawn-cells", DAWN, PLACES, .set = {"parts.array.electrical_extraction=0.18"}},
    {.name = "cells without",
     DUSK,
     .set = {"parts.array.electrical_extraction=0.18"},
     .filter = {.channels = "lwir"}},

    /* A blanket that is known to hang in patches hangs in flatter or steeper ones. At dawn no face
     * mirrors the Sun near the station: only patches of a film that is a narrow mirror and hardly
     * scatters, as real ones are, glint that far away. Of `mli` chi-square would be 0.3 and less.
     */
    {.name = "dusk-creases", DUSK, .set = {CREASES}},
    {.name = "dawn-creases", DAWN, PLACES, .set = {CREASES, "parts.bus.outside=mli_kapton"}},

    /* Panels that are known to be off their plane are flatter or steeper: cells under glass, as of
     * an array that was aligned badly. */
    {.name = "dusk-panels", DUSK, .set = {FLATNESS, "parts.array.front=cell_silicon"}},
    {.name = "dawn-panels", DAWN, PLACES, .set = {FLATNESS, "parts.array.front=cell_silicon"}},

    /* Of a body that has no axis of its own (inertia_ratio 1) nutation is a tip that stays, which
     * is an attitude offset. One that is flat along its axis nutates faster than it turns. */
    {.name = "dusk-nutation", DUSK, .set = {"attitude.0.spin.inertia_ratio=1.5"}},

    /* Films are parts of records with optical constants. */
    {.name = "dusk-films", DUSK, SPECTRA},
    {.name = "dawn-films", DAWN, PLACES, SPECTRA},

    /* A thermostat is seen by its switching: temperatures as often as light. */
    {.name = "dusk-dense", DUSK, .kelvin = 0.3, .place = {"bus.interior", "bus.-x"}},
    {.name = "dawn-dense",
     .folder = "dawn",
     .relative = 0.01,
     .floor = 1e-3,
     .kelvin = 0.3,
     .place = {"bus.interior", "bus.-x"}},

    /* Where there is air. */
    {.name = "dusk-low",
     DUSK,
     .set = {"orbit={circular: {altitude_km: 300}}",
             "observer={direction: {unit_gcrs: [0.6, 0.8, 0], range_km: 1000}}"}},

    /* What grows from day to day, seen six times a day from one direction. */
    {.name = "days",
     DUSK,
     .set = {"observer={direction: {unit_gcrs: [0.6, 0.8, 0], range_km: 1000}}",
             "time.start_utc=2026-03-20T18:40:00Z", "time.stop_utc=2026-03-24T18:40:00Z",
             "time.step_s=14000", "time.exposure_s=0", "thermal.start=isothermal",
             "thermal.orbits_before=0.5", "thermal.step_s=120"}},

    /* Internal power or MLI emittance: the skin of the MLI, alone and in one attitude, warms with
     * both; the interior warms with power and cools with a leak, and a radiator shows it. */
    {.name = "power-mli without",
     DAWN,
     .place = {"bus.-y"},
     .filter = {.channels = "bus.-y", .sunlit_to = 0.001, .from_s = 0, .to_s = 200}},
    {.name = "power-mli with",
     DAWN,
     .place = {"bus.-y", "bus.interior", "bus.-x"},
     .filter = {.channels = "bus.-y,bus.interior,bus.-x,lwir"}},

    /* Absorptance or extraction: heat alone cannot tell, light can. */
    {.name = "absorptance-extraction without", DUSK, .filter = {.channels = "lwir"}},

    /* Emittance or capacity: a panel of which nobody knows how warm it went into the shadow cools
     * there by their ratio; in sunlight and in the light itself they differ. */
    {.name = "emittance-capacity without",
     DUSK,
     .place = {"array.front"},
     .kelvin = 0.5,
     .nuisance = "solar_absorptance:cell,sigma=free",
     .filter = {.channels = "array.front", .sunlit_to = 0.001, .from_s = 660, .to_s = 1e4}},
    {.name = "emittance-capacity with",
     DUSK,
     .place = {"array.front"},
     .kelvin = 0.5,
     .nuisance = "solar_absorptance:cell,sigma=free",
     .filter = {.channels = "array.front,lwir"}},

    /* Extinction or zero point: only the range of airmass tells. */
    {.name = "extinction-zero without",
     DUSK,
     .filter = {.channels = "lwir", .elevation_from_deg = 50.0}},

    /* Roughness or smear: three frames of one glint, whose level is not known, are widened by both;
     * glints that are passed at other distances from their centre are not. */
    {.name = "roughness-smear without",
     GLINTS,
     .filter = {.channels = "vis", .from_s = 72.5, .to_s = 75.5}},
    {.name = "roughness-smear with", GLINTS, .filter = {.channels = "vis"}},

    {.name = "pulse dawn", DAWN, .place = {"bus.interior", "bus.-x", "array.front"}},
};

const char *const lab_fine[LAB_FINE] = {
    "parts.bus.lumped=false",
    "parts.array.lumped=false",
    "thermal.facet_size_m=0.5",
    "thermal.samples=16",
    "thermal.relative_tolerance=1e-8",
    "thermal.absolute_tolerance_K=1e-6",
    "optics.samples=25",
    "time.exposure_samples=5",
    "bands.vis.bins=30",
    "bands.lwir.bins=60",
};

const struct lab_world *lab_worlds(size_t *count)
{
  *count = sizeof worlds / sizeof worlds[0];
  return worlds;
}

const struct lab_world *lab_world_find(const char *name)
{
  for (size_t i = 0; i < sizeof worlds / sizeof worlds[0]; i++)
    if (strcmp(worlds[i].name, name) == 0) return &worlds[i];
  return NULL;
}

void lab_world_path(const struct lab_world *world, char out[LAB_TEXT * 4])
{
  snprintf(out, LAB_TEXT * 4, "%s/scenarios/hidden-effect/%s", UMBRA_SOURCE_DIR, world->folder);
}

void lab_world_analyst(const struct lab_world *world, struct lab_analyst *out)
{
  *out = (struct lab_analyst){0};
  size_t n = 0;
  while (n < LAB_KEYS && world->set[n] != NULL) {
    out->override[n] = world->set[n];
    n++;
  }
  out->without[0] = world->without;
  out->options = (struct um_model_options){.overrides = out->override,
                                           .noverride = n,
                                           .without = out->without,
                                           .nwithout = world->without == NULL ? 0 : 1};
}
