/* The one Sun and the one Earth of both halves: solar spectrum, shadow, albedo and Earth IR. */
#ifndef UMBRA_ENVIRONMENT_ENVIRONMENT_H
#define UMBRA_ENVIRONMENT_ENVIRONMENT_H

#include <stdbool.h>
#include <stddef.h>

#include "base/core/context.h"
#include "base/core/vec.h"
#include "environment/angular_moments.h"
#include "environment/clear_sky.h"
#include "environment/ground.h"
#include "materials/materials.h"

struct um_environment_limb;
struct um_environment_daylight;
struct um_environment_umbra_scatter;

enum um_environment_spectrum { UM_SPECTRUM_E490, UM_SPECTRUM_BLACK_BODY };
enum um_environment_shadow {
  UM_SHADOW_NONE,
  UM_SHADOW_CYLINDER,
  UM_SHADOW_SPHERE,
  UM_SHADOW_OBLATE
};
enum um_environment_disc { UM_DISC_POINT, UM_DISC_UNIFORM, UM_DISC_LIMB_DARKENED };

/* Plain configuration; copy and change freely (effects do). Set defaults first. */
struct um_environment {
  double solar_irradiance; /* [W/m^2] at 1 au */
  enum um_environment_spectrum spectrum;
  double solar_temperature; /* [K] of the black body */
  enum um_environment_earth earth;
  const struct um_environment_map *map;  /* borrowed, never written; NULL: there is none */
  double albedo;                         /* [1] Lambert, of the uniform Earth */
  double outgoing_longwave;              /* OLR [W/m^2], Lambert, of the uniform Earth */
  double brightness_temperature;         /* [K] in the LWIR window, of the uniform Earth */
  double albedo_factor, longwave_factor; /* of an Earth that is not uniform [1] */
  double brightness_shift;               /* added to its brightness temperature [K] */
  /* of an Earth that is not uniform: infrared by wavelength and angle (earth_infrared.h), or of a
   * Lambert black body */
  bool earth_spectrum_on;
  /* the same of sunlight that it reflects (daylight.h), or as a Lambert surface does; daylight is
   * borrowed, never written; NULL: as a Lambert surface */
  bool earth_anisotropy_on;
  const struct um_environment_daylight *daylight;
  double mirror_cloud;                 /* added to the cover of cloud where lobes look [1] */
  struct um_environment_region region; /* where, and when, the level is another */
  double earth_radius;                 /* [m] of the sphere that loads and reflects */
  enum um_environment_shadow shadow;
  double
      shadow_radius; /* [m] CYLINDER and SPHERE; equatorial radius of OBLATE (WGS-84 flattening) */
  enum um_environment_disc disc;
  double limb_darkening; /* u of 1 - u (1 - mu) [1] */
  /* the Earth's air before the Sun (shadow_light.h); limb is borrowed, never written; NULL: none */
  bool shadow_refraction_on;
  const struct um_environment_limb *limb;
  /* sunlight that the air scatters into the shadow (umbra_scatter.h), in the optics; borrowed,
   * never written; NULL: none */
  bool umbra_scatter_on;
  const struct um_environment_umbra_scatter *umbra_scatter;
  double air_factor;   /* of the air's depth, not of its refraction [1] */
  double ozone_dobson; /* vertical column [Dobson units]; NaN: by latitude (limb_profile.h) */
  double ozone_factor; /* of it [1] */
  double haze;         /* vertical optical depth of tropospheric aerosol at 0.55 um [1] */
  double aerosol;      /* of the stratosphere's [1] */
  /* height below which clouds hide more than half of what passes [m], NaN: by latitude; and what
   * is added to it [m] */
  double cloud_top, cloud_shift;
  bool albedo_on, planet_on; /* heat loads */
  bool earthshine_on;        /* sunlight reflected by the Earth, in the optics */
  bool earth_reflection_on;  /* Earth's own radiation reflected by the satellite, in the optics */
  bool moonlight_on;         /* sunlight reflected by the Moon, in the optics */
  double earthshine_factor, earth_reflection_factor; /* of those two [1] */
  bool earthlight_lobe_on; /* lobes reflect the Earth where they look; or as diffuse surfaces do */
  bool multiple_scattering_on; /* what facets keep back of a lobe goes on to other facets */
  bool inter_reflection_on;    /* surfaces light each other, in the optics */
  /* heat between surfaces of the satellite: of their own emission, of sunlight that they reflect */
  bool mutual_radiation_on, solar_reflection_on;
  bool specular_exchange_on; /* of both, what smooth surfaces reflect goes on as from a mirror */
  /* how surfaces take what comes: at normal incidence for all angles and with the emittance of
   * 300 K, or as their spectra say */
  bool absorptance_by_angle, emittance_by_temperature;
  double
      gas_density_factor; /* of the heat that the atmosphere brings, accommodation included [1] */
  struct um_environment_clear_sky sky; /* between a station and space */
  bool bulk_by_temperature; /* heat capacity and conductivity as their records say, or of 300 K */
};
void um_environment_defaults(struct um_environment *out);
/* Does the Earth differ from place to place, or in time? Then a globe is wanted. */
bool um_environment_earth_varies(const struct um_environment *environment);
/* Does its infrared go by wavelength and angle? Such an Earth varies. */
bool um_environment_earth_is_spectral(const struct um_environment *environment);
/* Does what it reflects go by angle? Such an Earth varies, and has its daylight. */
bool um_environment_earth_is_anisotropic(const struct um_environment *environment);

/* Solar irradiance [W/m^2] at a distance [m] from the Sun. */
double um_environment_solar_irradiance(const struct um_environment *environment, double distance);
/* Solar spectral irradiance at 1 au [W/m^2/m] at a wavelength [m], the spectrum scaled so that its
 * integral is solar_irradiance; and its exact integral over a band [W/m^2]. */
double um_environment_solar_spectrum(const struct um_environment *environment, double wavelength);
/* A library of materials under the Sun of um_environment_defaults, with the program's own records
 * or empty; the caller destroys. Errors of um_materials_library_read_folder. */
enum um_status um_environment_library_create(struct um_context *context, bool records,
                                             struct um_materials_library **out);
double um_environment_solar_band(const struct um_environment *environment, double from, double to);

/* The same Sun for materials: shares of its energy in bands of equal width in log wavelength,
 * 0.1195 to 1000 um, at their geometric means. Absorptances over it agree with the whole table of
 * E490 to 5e-4 (tests/materials/integrals.c). */
void um_environment_sun_shares(const struct um_environment *environment,
                               struct um_materials_sun *out);

/* Sunlit fraction of the solar disc, 0..1 (limb-darkened: of its flux), at a GCRS point r [m]:
 * sun = unit vector to the Sun from the point, distance [m]; pole = Earth's pole in GCRS (OBLATE).
 * Exactly 0 in the umbra and exactly 1 in full sunlight. Exact contour of the limb of sphere or
 * ellipsoid on the disc, as if by infinitely many rays; Montenbruck & Gill 2000 3.4.2 (plane
 * circles) is within 2.3e-4 of it, and is used beyond 450 000 km. CYLINDER and POINT are 0 or 1;
 * NaN gives NaN. Test: environment/shadow. */
double um_environment_sunlit_fraction(const struct um_environment *environment, struct um_vec3 r,
                                      struct um_vec3 sun, double distance, struct um_vec3 pole);
/* Signed measure of the same geometry, smooth through an eclipse edge: apparent angle [rad] of the
 * centre of the Sun above the limb, at right angles to the limb; penumbra begins and ends at +- the
 * Sun's angular radius asin(UM_SOLAR_RADIUS/distance). For root finding. NONE gives pi, a point
 * inside the Earth -pi/2. */
double um_environment_limb_angle(const struct um_environment *environment, struct um_vec3 r,
                                 struct um_vec3 sun, double distance, struct um_vec3 pole);

/* Does the Earth (WGS-84 ellipsoid about the unit pole) stand between a point r [m] and one that is
 * `range` [m] from it in a unit direction? All in one frame centred on the Earth. A far end on the
 * ground, down to 1 km below the ellipsoid, does not stand in its own way; one deeper down does.
 * Test: environment/line_of_sight. */
bool um_environment_earth_between(struct um_vec3 r, struct um_vec3 direction, double range,
                                  struct um_vec3 pole);

enum um_environment_event_kind {
  UM_EVENT_PENUMBRA_ENTRY, /* fraction falls below 1 */
  UM_EVENT_HALF_ENTRY,     /* centre of the disc on the limb, falling: fraction 1/2 to 3e-4 */
  UM_EVENT_UMBRA_ENTRY,    /* fraction reaches 0 */
  UM_EVENT_UMBRA_EXIT,     /* fraction rises above 0 */
  UM_EVENT_HALF_EXIT,
  UM_EVENT_PENUMBRA_EXIT /* fraction reaches 1 */
};
struct um_environment_event {
  double t_tai;
  enum um_environment_event_kind kind;
};
/* Geometry at a time, for the event search: r [m], Sun unit vector and distance [m], pole. */
typedef enum um_status (*um_environment_geometry)(void *self, double t_tai, struct um_vec3 *r,
                                                  struct um_vec3 *sun, double *distance,
                                                  struct um_vec3 *pole);
/* All eclipse events in [from, to], ascending, each to 1 ms; scan step `step` [s] (<= 60 suggested;
 * grazing eclipses shorter than it are caught by a minimum search). For CYLINDER and POINT the
 * three events of an edge coincide. The caller frees *out with um_core_free. UM_ERR_INPUT (end
 * before start, step), UM_ERR_NUMERIC (geometry not finite), errors of `geometry`; *out is then
 * NULL. Test: environment/events. */
enum um_status um_environment_events_find(struct um_context *context,
                                          const struct um_environment *environment,
                                          um_environment_geometry geometry, void *self, double from,
                                          double to, double step, struct um_environment_event **out,
                                          size_t *count);

/* What the Earth sends to plates at one place. Unobstructed, per plate normal. */
struct um_environment_earth_flux {
  double albedo;      /* reflected sunlight [W/m^2] */
  double planet;      /* emitted, all wavelengths [W/m^2] */
  double view_factor; /* plate-Earth view factor [1] */
  double brightness;  /* brightness temperature in 8-12 um of the Earth that it sees [K] */
};
/* r [m], unit sun, distance [m] to the Sun, unit normals[n], all in one frame centred on the Earth
 * (GCRS), as is the globe; it may be NULL where um_environment_earth_varies is false. Albedo
 * integrates a S max(cos SZA, 0) over the visible cap (Earth-central half-angle acos(R/r)); it acts
 * in eclipse too. View factors are exact (Howell; Juul 1979). Switches albedo_on/planet_on do NOT
 * act here: the caller applies them. Accuracy of the albedo, relative to a nadir plate at the same
 * place: 3e-5 for any plate from 200 km up (3e-6 from 765 km), 1e-9 for plates that see the whole
 * cap; test: environment/earth. About 0.4 us a plate. What differs from place to place is summed
 * over 512 cells of the cap: 1e-3 of the difference for smooth fields; test:
 * environment/earth_varied. The brightness temperature is that of the mean radiance at 10 um over
 * what the plate sees; of an Earth that is spectral with its limb (um_environment_earth_limb), and
 * its infrared with um_environment_earth_anisotropy. out[n]. */
void um_environment_earth_flux(const struct um_environment *environment,
                               const struct um_environment_globe *globe, struct um_vec3 r,
                               struct um_vec3 sun, double distance, const struct um_vec3 *normals,
                               size_t n, struct um_environment_earth_flux *out);
/* The same, and at which angles it arrives: angular moments of both (angular_moments.h), accurate
 * to 7e-5 of what a plate gets that faces the Earth with the Sun overhead, 2e-4 (at GEO
 * 1e-3) where the terminator crosses the cap, from 200 km up. moments[n]; NULL: as above. Test:
 * environment/earth_moments. */
struct um_environment_earth_moments {
  double albedo[UM_ANGULAR_MOMENTS], planet[UM_ANGULAR_MOMENTS]; /* E_1 to E_5 [W/m^2] */
};
void um_environment_earth_flux_by_angle(const struct um_environment *environment,
                                        const struct um_environment_globe *globe, struct um_vec3 r,
                                        struct um_vec3 sun, double distance,
                                        const struct um_vec3 *normals, size_t n,
                                        struct um_environment_earth_flux *out,
                                        struct um_environment_earth_moments *moments);
/* The same cap as directions, for what a plate cannot see because the satellite is in the way:
 * ndir unit directions from the satellite with solid-angle weights [sr], reflected solar radiance
 * and emitted radiance [W/m^2/sr]. capacity >= UM_EARTH_CAP_POINTS. Returns the number. */
#define UM_EARTH_CAP_POINTS 128
struct um_environment_cap_point {
  struct um_vec3 direction; /* [1] */
  double solid_angle;       /* [sr] */
  double albedo_radiance;   /* [W/m^2/sr] */
  double planet_radiance;   /* [W/m^2/sr] */
};
size_t um_environment_earth_cap(const struct um_environment *environment,
                                const struct um_environment_globe *globe, struct um_vec3 r,
                                struct um_vec3 sun, double distance,
                                struct um_environment_cap_point *out);
/* Closed-form plate-Earth view factor; h_ratio = r/R >= 1, tilt of the normal from nadir [rad]. */
double um_environment_plate_view_factor(double h_ratio, double tilt);
double um_environment_sphere_view_factor(double h_ratio);

#endif
