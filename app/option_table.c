/* The options of the command line, once: parsing, usage, help, man page and completion follow. */
#include <stddef.h>
#include <string.h>

#include "app/app.h"

#define TEXT_(x) #x
#define TEXT(x)  TEXT_(x)
#define AT(f)    .at = offsetof(struct um_app_options, f)
#define LIST(f)  .takes = UM_APP_LIST, AT(f), .count = offsetof(struct um_app_options, n##f)

static const struct um_app_option table[] = {
    {"out", "out", "DIR", 'o', UM_APP_TEXT, AT(out), .offers = UM_APP_FOLDERS,
     .default_value = "out/ and the scenario's name; of period out/period, of study out/study",
     .example = "--out out/cold", .help = "Folder of the results. It appears whole or not at all."},
    {"spectra", "out", "DIR", 'o', UM_APP_TEXT, AT(out), .offers = UM_APP_FOLDERS,
     .example = "--out spectra",
     .help = "Of materials: the folder for spectra, a table and a picture of each."},
    {"file", "out", "FILE", 'o', UM_APP_TEXT, AT(out), .offers = UM_APP_FILES,
     .example = "-o measured.csv", .help = "The file to write."},
    {"column-time", "time", "COLUMN", .takes = UM_APP_TEXT, AT(column_time),
     .example = "--time UTC",
     .help =
         "Column of the times: UTC as text, a Julian date, a modified one, or POSIX seconds, which "
         "is found out and said. DATE+TIME where they are two columns. Times are mid-exposure."},
    {"column-magnitude", "magnitude", "COLUMN", .takes = UM_APP_TEXT, AT(column_magnitude),
     .example = "--magnitude V", .help = "Column of magnitudes, exo-atmospheric."},
    {"column-flux", "flux", "COLUMN", .takes = UM_APP_TEXT, AT(column_flux), .example = "--flux F",
     .help = "Column of irradiances at the aperture or of radiant intensities, as --unit says."},
    {"column-counts", "counts", "COLUMN", .takes = UM_APP_TEXT, AT(column_counts),
     .example = "--counts rate", .help = "Column of counts per second of a sensor."},
    {"column-temperature", "temperature", "COLUMN", .takes = UM_APP_TEXT, AT(column_temperature),
     .example = "--temperature T1",
     .help =
         "Column of temperatures of a place, or COLUMN=PLACE,COLUMN=PLACE,... of a table with a "
         "column a sensor: rows of zeros and rows that repeat the one before are then flagged."},
    {"column-band", "band", "BAND", .takes = UM_APP_TEXT, AT(column_band),
     .default_value = "the column's name: V of Vmag", .example = "--band vis",
     .help = "The band of magnitudes or fluxes, as the scenario calls it."},
    {"column-of", "of", "NAME", .takes = UM_APP_TEXT, AT(column_of), .example = "--of panel.front",
     .help = "The place of temperatures, as temperatures.csv calls it, or the sensor of counts."},
    {"column-system", "system", "ab|vega", .takes = UM_APP_TEXT, AT(column_system),
     .default_value =
         "by the band's name: vega of U, B, V, R, I and their like, ab of u, g, r, i, z, y",
     .example = "--system ab", .help = "Of magnitudes."},
    {"column-unit", "unit", "UNIT", .takes = UM_APP_TEXT, AT(column_unit),
     .default_value = "what the column's name ends in, as T_C", .example = "--unit C",
     .help = "Of fluxes W/m2, W/cm2, erg/s/cm2 or W/sr, of temperatures K or C."},
    {"column-sigma", "sigma", "COLUMN", .takes = UM_APP_TEXT, AT(column_sigma),
     .default_value = "none: the scenario's noise", .example = "--sigma Verr",
     .help = "Column of standard deviations, in the unit of the values."},
    {"column-flag", "flag", "COLUMN", .takes = UM_APP_TEXT, AT(column_flag),
     .example = "--flag bad",
     .help = "Column of whole numbers: 0 or empty is used, any other left out."},
    {"column-exposure", "exposure", "COLUMN", .takes = UM_APP_TEXT, AT(column_exposure),
     .example = "--exposure t_exp", .help = "Column of exposures [s]."},
    {"column-track", "track", "COLUMN", .takes = UM_APP_TEXT, AT(column_track),
     .example = "--track pass", .help = "Column of names of what belongs together."},
    {"like", "like", "MEASURED", .takes = UM_APP_TEXT, AT(like), .offers = UM_APP_FILES,
     .example = "--like measured.csv",
     .help =
         "Take the columns as the import that wrote this file did; what else is said goes before."},
    {"format", "format", "mmt|table", .takes = UM_APP_TEXT, AT(format),
     .default_value = "by what stands in the file", .example = "--format mmt",
     .help = "A track of Mini-MegaTORTORA, or a table with a header."},
    {"as", "as", "KIND", .takes = UM_APP_TEXT, AT(as), .offers = UM_APP_EXPORTS,
     .example = "--as mesh", .help = "What to write, one of the kinds below."},
    {"target", "out", "FILE|DIR", 'o', UM_APP_TEXT, AT(out), .offers = UM_APP_FILES,
     .example = "-o satellite.obj", .help = "The file or folder to write, whole or not at all."},
    {"from-mesh", "from", "MESH.obj", .takes = UM_APP_TEXT, AT(from_mesh), .offers = UM_APP_FILES,
     .default_value = "a 3U CubeSat", .example = "--from satellite.obj",
     .help = "Take the parts from the groups of this mesh, which is copied into the folder."},
    {"tle", "tle", "FILE", .takes = UM_APP_TEXT, AT(tle), .offers = UM_APP_FILES,
     .default_value = "a circle at 500 km", .example = "--tle satellite.tle",
     .help =
         "Elements of the orbit, two lines or a message (OMM), copied into the folder; a pass in "
         "the three days behind their epoch is taken."},
    {"one-station", "station", "NAME,LAT,LON,HEIGHT", .takes = UM_APP_TEXT, AT(one_station),
     .default_value = "Graz", .example = "--station Graz,47.067,15.493,495",
     .help = "Where the telescope stands: degrees north and east, metres."},
    {"set", "set", "KEY=VALUE", LIST(set), .example = "--set parts.bus.interior.power_W=50",
     .help = "Change a key of the scenario; names stand where lists have names. A list takes "
             "LIST.+=VALUE at its end. See umbra list keys."},
    {"with", "with", "EFFECT[:TARGET][,NAME=VALUE]...", LIST(with), .offers = UM_APP_EFFECTS,
     .example = "--with internal_power:bus,power_W=20",
     .help = "Switch an effect on, or change its parameters. See umbra list effects."},
    {"without", "without", "EFFECT[:TARGET]", LIST(without), .offers = UM_APP_EFFECTS,
     .example = "--without albedo", .help = "Switch an effect off."},
    {"effect-file", "effect-file", "FILE", LIST(effect_file), .offers = UM_APP_FILES,
     .example = "--effect-file ./mine.so",
     .help =
         "Load effects of your own from a shared object, which runs with the program's rights."},
    {"allow-effects", "allow-effects", .takes = UM_APP_FLAG, AT(allow_effects),
     .help = "Load the shared objects that the scenario's effect_files name, which run with the "
             "program's rights. Without it such a scenario is refused."},
    {"time", "time", "UTC", .takes = UM_APP_TEXT, AT(time_utc),
     .example = "--time 2016-09-21T20:36:40Z",
     .help = "The instant of the picture, between the scenario's start_utc and stop_utc."},
    {"band", "band", "B", .takes = UM_APP_TEXT, AT(band), .example = "--band lwir",
     .help = "The band, as the scenario or the measurements call it."},
    {"width", "width", "N", .takes = UM_APP_NUMBER, AT(width), .most = 8192,
     .default_value = TEXT(UM_APP_RENDER_WIDTH) "; of a frame " TEXT(UM_APP_FRAME_WIDTH),
     .example = "--width 2048", .help = "Pixels of a line, up to 8192."},
    {"samples", "samples", "N", .takes = UM_APP_NUMBER, AT(samples), .most = 65536,
     .default_value = TEXT(UM_APP_RENDER_SAMPLES) "; of a frame " TEXT(UM_APP_FRAME_SAMPLES),
     .example = "--samples 256", .help = "Rays of a pixel, up to 65536."},
    {"wavelengths", "wavelengths", "FROM-TO", .takes = UM_APP_TEXT, AT(wavelengths),
     .default_value = "all of them", .example = "--wavelengths 8-8.1um",
     .help = "Write the bins alone whose centres lie there [um]."},
    {"tile", "tile", "X,Y,WIDTH,HEIGHT", .takes = UM_APP_TEXT, AT(tile),
     .default_value = "the whole picture", .example = "--tile 1000,500,256,256",
     .help = "Write this rectangle alone [pixels], counted from the upper left corner."},
    {"sensor", "sensor", "S", .takes = UM_APP_TEXT, AT(sensor), .example = "--sensor ufo",
     .help = "The sensor, as the scenario calls it."},
    {"psf", "psf", "PSF", .takes = UM_APP_TEXT, AT(psf), .default_value = "gaussian",
     .example = "--psf seeing:0.1",
     .help = "The image of a star: gaussian of the sensor's fwhm_arcsec; moffat:BETA of the same "
             "FWHM; airy, diffraction alone; seeing:R0_M, turbulence of that Fried parameter at "
             "500 nm and the zenith; or a CSV file with radius_arcsec and value."},
    {"motion", "motion", "RATE,ANGLE", .takes = UM_APP_TEXT, AT(motion), .default_value = "0,0",
     .example = "--motion 12,30",
     .help = "Motion of the image on the detector [arcsec/s], [degrees from the right "
             "counter-clockwise]."},
    {"frame-star", "star", "MAG,RIGHT,UP", LIST(star), .example = "--star 8.2,60,-25",
     .help = "Put a star beside the satellite: AB magnitude, place from the frame's middle "
             "[arcsec]. Through the scenario's air and effects; the satellite's motion does not "
             "smear it."},
    {"star", "star", "MAG,X,Y", LIST(star), .example = "--star 8.2,131.5,40",
     .help = "Measure this star instead, again for more: AB magnitude, place [pixels]. The file is "
             "then a table of stars for umbra calibrate."},
    {"border", "border", "N", .takes = UM_APP_NUMBER, AT(border), .most = 2000,
     .default_value = "1", .example = "--border 16",
     .help = "Pixels of sky about what the light fills, for an annulus to be read."},
    {"aperture", "aperture", "R,IN,OUT", .takes = UM_APP_TEXT, AT(aperture),
     .example = "--aperture 6,9,14",
     .help = "Radius of the circle, and from where to where the sky is read about it [pixels]."},
    {"at", "at", "X,Y", .takes = UM_APP_TEXT, AT(at), .default_value = "the middle of the frame",
     .example = "--at 120.5,98", .help = "Where the object is, 1,1 the middle of the first pixel."},
    {"sky", "sky", "mean|median", .takes = UM_APP_TEXT, AT(sky), .default_value = "mean",
     .example = "--sky median", .help = "Of the annulus; the median where a star may stand in it."},
    {"extinction", "extinction", "K", .takes = UM_APP_TEXT, AT(extinction),
     .default_value = "fitted", .example = "--extinction 0.2",
     .help = "What is known of it [mag per airmass], for stars at one airmass."},
    {"frame-seed", "seed", "N", .takes = UM_APP_TEXT, AT(seed),
     .default_value = "no noise: expected counts", .example = "--seed 1",
     .help = "Draw photon and read noise, whole counts; the same seed gives the same noise."},
    {"picture", "picture", "UTC", LIST(picture), .example = "--picture 2016-09-21T20:33:00Z",
     .help = "Leave a picture of every band at the instant nearest to this one as OpenEXR among "
             "the results; first-light: when the Sun's first light is there."},
    {"step", "step", "DEG", .takes = UM_APP_TEXT, AT(step), .default_value = TEXT(UM_APP_MAP_STEP),
     .example = "--step 1", .help = "Of the map in latitude and longitude, a part of 90 deg."},
    {"phase-angles", "phase-angles", "DEG,...", .takes = UM_APP_TEXT, AT(phase_angles),
     .default_value = UM_APP_MAP_PHASE_ANGLES, .example = "--phase-angles 0",
     .help = "Sun - satellite - observer, one map for each, from 0 to below 180 deg, rising."},
    {"planes", "planes", "N", .takes = UM_APP_NUMBER, AT(planes), .most = 180,
     .default_value = TEXT(UM_APP_MAP_PLANES), .example = "--planes 12",
     .help = "In how many planes through the phase vector Sun and observer stand, over half a "
             "turn; pictures show the mean."},
    {"map-tolerance", "tolerance", "SHARE", .takes = UM_APP_TEXT, AT(map_tolerance),
     .default_value = TEXT(UM_APP_MAP_TOLERANCE), .example = "--tolerance 0.1",
     .help =
         "Cells of the map are refined until their middle, and a normal in them, is off by less "
         "than this share of the larger of value and mean; 0: not at all."},
    {"coarse-step", "step", "DEG", .takes = UM_APP_TEXT, AT(step), .default_value = "3",
     .example = "--step 5", .help = "Of the map in latitude and longitude, a part of 90 deg."},
    {"own-phase-angles", "phase-angles", "DEG,...", .takes = UM_APP_TEXT, AT(phase_angles),
     .default_value = "four, from the least to the largest of the measurements",
     .example = "--phase-angles 30,60,90", .help = "Of the map, from 0 to below 180 deg, rising."},
    {"period", "period", "FROM[,TO]", .takes = UM_APP_TEXT, AT(period),
     .default_value = "the scenario's, and a tenth to both sides", .example = "--period 200,220",
     .help = "Of the spin [s], in either sense."},
    {"axis-step", "axis-step", "DEG", .takes = UM_APP_TEXT, AT(axis_step),
     .default_value = TEXT(UM_APP_AXIS_STEP), .example = "--axis-step 10",
     .help = "Between axes that are tried, and of the turn between phases, half of it."},
    {"solutions", "solutions", "N", .takes = UM_APP_NUMBER, AT(solutions), .most = 200,
     .default_value = TEXT(UM_APP_SOLUTIONS), .example = "--solutions 30",
     .help = "Minima of the search that are fitted by direct simulation."},
    {"noise", "noise", "REL[,FLOOR]", .takes = UM_APP_TEXT, AT(noise),
     .default_value = "FLOOR " TEXT(UM_APP_FLOOR), .example = "--noise 0.02,0.005",
     .help = "Noise of light: sigma^2 = (REL x truth)^2 + (FLOOR x peak of the band)^2."},
    {"track-noise", "noise", "REL[,FLOOR]", .takes = UM_APP_TEXT, AT(noise),
     .default_value = "sigma stays empty; FLOOR 0", .example = "--noise 0.02,0.05",
     .help = "Noise of the magnitudes: REL of the flux, and FLOOR in magnitudes."},
    {"seed", "seed", "N", .takes = UM_APP_TEXT, AT(seed), .example = "--seed 1",
     .help = "Of the noise, a whole number: the same seed gives the same noise."},
    {"temperatures", "temperatures", "PLACE,...", .takes = UM_APP_TEXT, AT(temperatures),
     .default_value = "none", .example = "--temperatures bus.+x,array.front",
     .help = "Places whose temperatures are measured too, as temperatures.csv calls them."},
    {"grey-body", "grey-body", .takes = UM_APP_FLAG, AT(grey_body),
     .help = "Characteristic temperature and infrared cross-section of the thermal bands too."},
    {"temperature-sigma", "temperature-sigma", "K", .takes = UM_APP_TEXT, AT(temperature_sigma),
     .default_value = TEXT(UM_APP_TEMPERATURE_SIGMA), .example = "--temperature-sigma 0.2",
     .help = "Noise of temperatures [K]."},
    {"only", "only", "EFFECT[:TARGET]", LIST(only), .offers = UM_APP_EFFECTS,
     .default_value = "every effect on every target", .example = "--only albedo_level",
     .help = "Test these candidates alone."},
    {"data", "data", "MEASURED", .takes = UM_APP_TEXT, AT(data), .offers = UM_APP_FILES,
     .default_value = "the scenario's instants, every band and place", .example = "--data pass.csv",
     .help = "Differentiate what was measured there, at its times (the file of umbra compare)."},
    {"what-if", "what-if", "EFFECT[:TARGET][,NAME=VALUE]...", LIST(what_if),
     .offers = UM_APP_EFFECTS, .example = "--what-if emittance:mli,factor=1.1",
     .help = "The answer by the matrix beside the true one, and how far it is good."},
    {"elasticity", "elasticity", .takes = UM_APP_FLAG, AT(elasticity),
     .help = "Percent of a curve per percent of what a parameter changes, too."},
    {"exclude", "exclude", "EFFECT[:TARGET]", LIST(exclude), .offers = UM_APP_EFFECTS,
     .default_value = "none", .example = "--exclude attitude_offset",
     .help = "Leave these candidates out."},
    {"nuisance", "nuisance", "EFFECT[:TARGET][,sigma=S]", LIST(nuisance), .offers = UM_APP_EFFECTS,
     .default_value = "those of the scenario", .example = "--nuisance zero_point:lwir,sigma=0.05",
     .help =
         "What is uncertain anyway: fitted along and never named. Without a target of each that "
         "there is: area,sigma=0.02 is a size of every part. S is how far it may be from "
         "the scenario's value, or free; without it the width of the effect's prior."},
    {"add", "add", "EFFECT[:TARGET][,NAME=START]...", LIST(add), .offers = UM_APP_EFFECTS,
     .example = "--add emittance:mli", .help = "An effect to fit, from START where it is given."},
    {"posterior", "posterior", .takes = UM_APP_FLAG, AT(posterior),
     .help = "Draw from the posterior of all that is fitted: intervals of 68 and 95 % and the band "
             "of the curves. Each draw is a run."},
    {"draws", "draws", "N", .takes = UM_APP_NUMBER, AT(draws), .most = 1000000,
     .default_value = TEXT(UM_APP_DRAWS), .example = "--draws 4000", .help = "Of --posterior."},
    {"draw-seed", "seed", "N", .takes = UM_APP_TEXT, AT(seed), .default_value = "1",
     .example = "--seed 2",
     .help = "Of --posterior, a whole number: the same seed gives the same draws."},
    {"level", "level", "P", .takes = UM_APP_SHARE, AT(level), .default_value = "0.01",
     .example = "--level 0.001",
     .help = "Probability of accusing a scenario that lacks nothing, over all candidates."},
    {"steps", "steps", "N", .takes = UM_APP_NUMBER, AT(steps), .most = 20, .default_value = "4",
     .example = "--steps 2", .help = "Effects added at most, up to 20."},
    {"passes", "passes", "N", .takes = UM_APP_NUMBER, AT(passes), .most = 100,
     .default_value = "none", .example = "--passes 5",
     .help = "Where more than one effect would do: how well each of the next N passes over each "
             "station would tell them apart, in which band, and how soon. Heat is followed up to "
             "them, in two runs for each effect."},
    {"draft-effect", "draft-effect", "FILE.c", .takes = UM_APP_TEXT, AT(draft_effect),
     .offers = UM_APP_FILES, .example = "--draft-effect mine.c",
     .help = "Write what explains the measurements and no effect of the catalogue has, heat or a "
             "correction of light, as an effect of your own: a C file that says how to compile it. "
             "Needs --force where that file is there."},
    {"days", "days", "N", .takes = UM_APP_TEXT, AT(days), .default_value = "1",
     .example = "--days 7", .help = "How long, up to 400; a part of a day is accepted."},
    {"from", "from", "UTC", .takes = UM_APP_TEXT, AT(time_utc),
     .default_value = "the scenario's start", .example = "--from 2016-09-21T12:00:00Z",
     .help = "Where the days begin."},
    {"station", "station", "NAME,LAT,LON,HEIGHT", LIST(station), .default_value = "the scenario's",
     .example = "--station Graz,47.067,15.493,495",
     .help = "A station in place of the scenario's, again for more: degrees north and east, "
             "metres."},
    {"minimum-elevation", "minimum-elevation", "DEG", .takes = UM_APP_TEXT, AT(minimum_elevation),
     .default_value = "the scenario's", .example = "--minimum-elevation 20",
     .help = "Passes that rise above it, from there to there."},
    {"uncertain", "uncertain", "EFFECT[:TARGET],NAME=SIGMA", LIST(uncertain),
     .offers = UM_APP_EFFECTS, .default_value = "none", .example = "--uncertain emittance:mli=0.05",
     .help = "A parameter that is known to 1 sigma, in its unit, again for more: all that is "
             "predicted gets error bars, to first order. EFFECT[:TARGET]=SIGMA where the effect "
             "has one parameter; KEY=SIGMA of a number that the scenario states. Each costs about "
             "a pass, two where its heat has to be solved."},
    {"times", "times", .takes = UM_APP_FLAG, AT(times),
     .help =
         "The times alone, at once: rise, culmination, set, edges of the shadow, and whether the "
         "station has day or night. Nothing is written. Where no days are said, those of half "
         "a day to both sides of the scenario."},
    {"workers", "workers", "N", .takes = UM_APP_NUMBER, AT(workers), .most = 4096,
     .default_value = "one for each processor; under mpirun or srun, one", .example = "--workers 4",
     .help = "Processes on this machine that compute."},
    {"share", "share", "K/N", .takes = UM_APP_TEXT, AT(share), .default_value = "all of them",
     .example = "--share 3/16",
     .help = "Compute every N-th point alone, from the K-th, and write no results: for job arrays. "
             "Without it --resume then gathers what all shares have on record."},
    {"resume", "resume", .takes = UM_APP_FLAG, AT(resume),
     .help = "Go on with what is on record from a command that was stopped."},
    {"check", "check", .takes = UM_APP_FLAG, AT(study_check),
     .help = "Say how many points, what they share, how long and how much disk, and stop."},
    {"measured", "measured", "FILE", .takes = UM_APP_TEXT, AT(measured), .offers = UM_APP_FILES,
     .example = "--measured pass.csv",
     .help =
         "Weigh the points by these measurements (the file of umbra compare): which fit, and what "
         "is left of each parameter."},
    {"force", "force", .takes = UM_APP_FLAG, AT(force),
     .help = "Replace what stands there, even if Umbra did not write it."},
    {"view", "view", .takes = UM_APP_FLAG, AT(view),
     .help =
         "Write a page that shows the satellite in three dimensions, before anything is solved: "
         "report.html in DIR."},
    {"port", "port", "N", .takes = UM_APP_NUMBER, AT(port), .most = 65535,
     .default_value = "one that is free", .example = "--port 8017",
     .help = "Where the page is served, on this machine alone."},
    {"no-plots", "no-plots", .takes = UM_APP_FLAG, AT(no_plots), .help = "Draw no pictures."},
    {"from-brdf", "from-brdf", "FILE", .takes = UM_APP_TEXT, AT(from_brdf), .offers = UM_APP_FILES,
     .example = "--from-brdf measured.csv",
     .help = "Fit a Lambert term and each kind of lobe to measured BRDFs: CSV "
             "incidence_deg,scattering_deg,brdf_1_sr, and azimuth_deg, surface where there are."},
    {"half-angle", "half-angle", "DEG", .takes = UM_APP_TEXT, AT(half_angle), .default_value = "0",
     .example = "--half-angle 10",
     .help =
         "Leave out rows nearer to the mirror direction than this half angle, where a spike may "
         "stand that no lobe follows."},
    {"from-profile", "from-profile", "FILE", .takes = UM_APP_TEXT, AT(from_profile),
     .offers = UM_APP_FILES, .example = "--from-profile heights.csv",
     .help =
         "Rq, tau and alpha of measured heights: CSV x_um,height_um, or a map x_um,y_um,height_um "
         "in even steps."},
    {"from-reflectance", "from-reflectance", "FILE", .takes = UM_APP_TEXT, AT(from_reflectance),
     .offers = UM_APP_FILES, .example = "--from-reflectance ratio.csv --reference gold",
     .help = "A record of specular reflectance that was measured against a reference mirror: CSV "
             "wavelength_um,ratio. Beside it --from-profile gives the roughness."},
    {"reference", "reference", "MATERIAL", .takes = UM_APP_TEXT, AT(reference),
     .default_value = "gold", .example = "--reference aluminium_bare",
     .help = "What --from-reflectance was measured against: a record with optical constants, of "
             "which Fresnel's reflectance counts, not its finish."},
    {"angle", "angle", "DEG", .takes = UM_APP_TEXT, AT(angle), .default_value = "30",
     .example = "--angle 10", .help = "Angle of incidence of --from-reflectance."},
    {"details", "details", .takes = UM_APP_FLAG, AT(details),
     .help = "Print the tables of diagnosis.txt in place of a short account."},
    {"json", "json", .takes = UM_APP_FLAG, AT(json),
     .help = "Print JSON, for another program to read. umbra help COMMAND --json has its schema."},
    {"thermal", "thermal", .takes = UM_APP_FLAG, AT(thermal), .help = "Only the cases of heat."},
    {"optics", "optics", .takes = UM_APP_FLAG, AT(optics), .help = "Only the cases of light."},
    {"record", "replay", "FILE", .takes = UM_APP_TEXT, AT(replay), .offers = UM_APP_FILES,
     .default_value = "replay.json in a folder of results", .example = "--replay run.json",
     .help = "Write down the command and the files that it read, for umbra replay."},
    {"replayed", "out", "DIR|FILE", 'o', UM_APP_TEXT, AT(out), .offers = UM_APP_FILES,
     .default_value = "of a folder FOLDER, FOLDER--replayed", .example = "--out out/again",
     .help = "Where the results go, whole or not at all."},
    {"replayed-effects", "allow-effects", .takes = UM_APP_FLAG, AT(allow_effects),
     .help =
         "Replay a command that loads effects from shared objects, which run with the program's "
         "rights. Without it such a record is refused."},
    {"threads", "threads", "N", .takes = UM_APP_THREADS, .most = 4096,
     .default_value = "one per processor", .example = "--threads 4",
     .help = "Worker threads; results do not depend on it."},
    {"help", "help", .letter = 'h', .takes = UM_APP_HELP, .help = "Print this page."},
};

const struct um_app_option *um_app_option_find(const char *id)
{
  for (size_t i = 0; i < sizeof table / sizeof table[0]; i++)
    if (strcmp(table[i].id, id) == 0) return &table[i];
  return NULL;
}

const struct um_app_option *um_app_option_at(size_t index)
{
  return index < sizeof table / sizeof table[0] ? &table[index] : NULL;
}

const struct um_app_option *um_app_option_next(const char **list)
{
  char id[32];
  size_t n;
  if (*list == NULL) return NULL;
  *list += strspn(*list, " ");
  n = strcspn(*list, " ");
  if (n == 0 || n >= sizeof id) return NULL;
  memcpy(id, *list, n);
  id[n] = '\0';
  *list += n;
  return um_app_option_find(id);
}

bool um_app_argument_next(const char **list, char name[32], bool *optional)
{
  *list += strspn(*list, " ");
  *optional = **list == '[';
  if (*optional) (*list)++;
  size_t n = strcspn(*list, " ]");
  if (n == 0 || n >= 32) return false;
  memcpy(name, *list, n);
  name[n] = '\0';
  *list += n + (*optional ? 1 : 0);
  return true;
}

enum um_app_offers um_app_argument_offers(const char *name)
{
  static const struct {
    const char *name;
    enum um_app_offers offers;
  } kinds[] = {{"SCENARIO", UM_APP_SCENARIOS}, {"STUDY", UM_APP_STUDIES},
               {"MEASURED", UM_APP_TABLES},    {"MEASURED...", UM_APP_TABLES},
               {"TABLE", UM_APP_FILES},        {"SCENARIO|PICTURE.nc", UM_APP_VIEWS},
               {"FRAME...", UM_APP_FILES},     {"RESULTS...", UM_APP_RESULTS},
               {"RECORD", UM_APP_REPLAYS},     {"STARS", UM_APP_TABLES},
               {"EFFECT", UM_APP_EFFECTS},     {"MATERIAL", UM_APP_MATERIALS},
               {"SENSOR", UM_APP_SENSORS},     {"PATH", UM_APP_SECTIONS},
               {"SHELL", UM_APP_SHELLS},       {"COMMAND", UM_APP_VERBS},
               {"WHAT", UM_APP_THINGS},        {"ITEM", UM_APP_ONE}};
  for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++)
    if (strcmp(kinds[i].name, name) == 0) return kinds[i].offers;
  return UM_APP_NOTHING;
}
