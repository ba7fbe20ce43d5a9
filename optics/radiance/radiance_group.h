/* Radiance of surfaces toward the observer at one instant. Light curve and picture share it: the
 * one sums many surfaces of a material before it multiplies by spectra, the other asks for one. */
#ifndef UMBRA_OPTICS_RADIANCE_GROUP_H
#define UMBRA_OPTICS_RADIANCE_GROUP_H

#include "optics/radiance/spectra_impl.h"

/* Sun or Moon at one time, as surfaces reflect it once. */
struct um_optics_lamp {
  enum um_optics_lamp_name name;
  struct um_vec3 body;   /* unit */
  struct um_vec3 half;   /* unit, body frame: between lamp and observer; zero where opposite */
  double cos_half_phase; /* cosine of half the angle between them [1] */
  double radius;         /* angular, of the disc [rad] */
  bool shines;
};

/* What is the same for all surfaces at one time. */
struct um_optics_instant {
  size_t time;                            /* of the scene */
  struct um_vec3 observer_body, sun_body; /* unit */
  struct um_optics_lamp lamp;             /* that is added up: the Sun, unless asked otherwise */
  double sun_radius;                      /* angular, of the disc [rad] */
  double sun;                             /* sunlit fraction (1 au / d)^2 [1] */
  double earthshine, earth_reflection;    /* factors, 0 where they are off [1] */
  bool earth_varies;                      /* every surface has an Earth of its own before it */
  bool sunlight_only;                     /* nothing but the lamp is added up */
  bool earth_lobe;                        /* lobes reflect it, where they look */
  struct um_vec3 nadir_body;              /* unit */
  double h_ratio;                         /* of the geocentre's distance [1] */
  double observer_nadir, observer_sun, nadir_sun; /* cosines [1] */
  /* of the Earth under an overhead Sun, all wavelengths; where it varies, of an albedo of 1
   * [W/m^2/sr] */
  double earth_radiance;
  double mirror_cloud;                    /* added to its cover of cloud where lobes look [1] */
  struct um_environment_earth_seen earth; /* where it varies; axes in the body frame */
};
struct um_optics_instant um_optics_instant(const struct um_optics_scene *scene, size_t time);
/* Does the Moon of an instant give more light than its Sun, at 0.55 um? */
bool um_optics_moon_is_brighter(const struct um_optics_scene *scene,
                                const struct um_optics_instant *now);
/* The same instant with the Moon for a lamp, which shines where the sample has one. */
void um_optics_instant_moon(const struct um_optics_scene *scene, struct um_optics_instant *now);

/* A surface, or a share of one, as seen. Areas are true areas, not projected. */
struct um_optics_sight {
  double area_seen, area_lit;          /* [m^2] */
  double cos_observer, cos_lamp;       /* [1] */
  double cos_half, cos_sun;            /* to the bisector of lamp and observer; to the Sun [1] */
  double cos_nadir;                    /* [1] */
  double temperature;                  /* [K] */
  double albedo;                       /* incident albedo flux [W/m^2] */
  double view_factor;                  /* to the Earth [1] */
  double brightness;                   /* of the Earth, where it varies [K] */
  struct um_vec3 grain, across;        /* body frame, unit, with the normal right-handed; set for
                                          anisotropic lobes and patches */
  struct um_materials_patches patches; /* of a creased surface; n 0: none */
};

/* Sums over surfaces of one material. */
struct um_optics_sum {
  double lambert;     /* sum of area_lit cos_o cos_i [m^2] */
  double lobe;        /* sum of area_lit cos_o cos_i D G/(4 cos_i cos_o) [m^2/sr] */
  double *earthlit;   /* [nbin] sum of area_seen cos_o times the lit Earth in the lobe [m^2] */
  double *masked;     /* [nbin] sum of area_lit cos_o cos_i M(i) M(o) [m^2] */
  double albedo;      /* sum of area_seen cos_o E_albedo [W] */
  double view_factor; /* sum of area_seen cos_o F [m^2], of what reflects the Earth evenly */
  double *emitted; /* [nbin] sum of area_seen cos_o eps B [W/sr/m]; eps = 1 for diffuse emitters */
  double *planet;  /* [nbin] sum of area_seen cos_o times what is reflected of the Earth, of all
                      others [m^2]; where the Earth varies, of all and times B(T_b) [W/sr/m] */
};

/* Scratch of one thread. */
struct um_optics_work {
  double *planck, *emissivity, *upright; /* [nbin] upright: emissivity before its tilt */
  double *masked_sun, *masked_observer;  /* [nbin] M toward both */
  double *earth, *earth_clear; /* [nbin] the Earth before surfaces and in a lobe, where it varies */
  struct um_optics_planck_sum bodies, far; /* surfaces; the Earth before them, by view factor */
  double
      *earth_row; /* [UM_EARTH_SEEN_NODES][nbin] radiance of an Earth that varies (earth_rows.c) */
  double
      *earth_ratio; /* [nbin] of its mean over a black body's of its brightness temperature [1] */
  double *lobe_all, *lobe_earth; /* [nbin] a lobe, and what of it the Earth fills */
  double *sunlight;              /* [nbin] of the lamp, before the satellite [W/m^2/m]:
                                    um_optics_light */
  double *spectral;              /* [nbin][UM_MECHANISM_COUNT] */
  double *specular;              /* [nskin][nbin] F of the current instant, where known */
  bool *specular_known;          /* [nskin] */
  double *bins;                  /* [4 nskin + 4][nbin] behind the sums */
  struct um_optics_sum *sum;     /* [nskin] */
  struct um_optics_sum single;   /* for one surface */
  double *incoming, *row;        /* [nbin] inter-reflection */
  double *throughput, *mirrored, *gathered; /* [nray][nbin] inter-reflection */
  double *reflected;                        /* [nbin] inter-reflection */
  double *band, *band_variance;             /* [nband] */
  struct um_geometry_ray *ray;              /* [nray] */
  uint8_t *occluded, *hidden;               /* [nray] */
  double *angle;            /* [njoint] of the current instant, where a lobe has a grain [rad] */
  struct um_quat *rotation; /* [npart] body to part, likewise */
};
/* nwork of them; nray: rays of one surface that are traced together. */
enum um_status um_optics_work_create(struct um_context *context,
                                     const struct um_optics_spectra *spectra, size_t nray,
                                     size_t nwork, struct um_optics_work **out);
void um_optics_work_destroy(struct um_context *context, size_t nwork, struct um_optics_work **work);

/* Light of the instant's lamp into the scratch: solar spectrum, distance, what the shadow and the
 * Earth's air leave of each wavelength, and the Moon's reflectance. Forgets what the scratch knows
 * of the lamp before. */
void um_optics_light(const struct um_optics_spectra *spectra, const struct um_optics_scene *scene,
                     const struct um_optics_instant *instant, struct um_optics_work *work);

/* Where lobes have a grain: how parts stand at an instant, into the scratch; then the grain of a
 * surface into its sight. */
void um_optics_turn(const struct um_optics_spectra *spectra, const struct um_optics_scene *scene,
                    const struct um_optics_instant *instant, struct um_optics_work *work);
void um_optics_sight_turn(const struct um_optics_spectra *spectra,
                          const struct um_optics_scene *scene, size_t surface,
                          const struct um_optics_work *work, struct um_optics_sight *sight);

/* Unit vector to the geocentre in the body frame; zero where there is no position. */
struct um_vec3 um_optics_nadir(const struct um_environment_sample *sample);
/* Where the Earth stands at an instant, and what it shows where it varies. */
void um_optics_instant_earth(const struct um_environment *environment,
                             const struct um_environment_sample *sample,
                             struct um_optics_instant *now);
/* earth_rows.c: spectra of an Earth that varies into the scratch, of its nodes and its mean. */
void um_optics_earth_rows(const struct um_optics_spectra *spectra,
                          const struct um_optics_instant *instant, struct um_optics_work *work);
/* Mean of them by weights where[UM_EARTH_SEEN_NODES], row[nbin] overwritten [W/m^2/sr/m]. */
void um_optics_earth_mirrored(const struct um_optics_spectra *spectra, const double *where,
                              const struct um_optics_work *work, double *row);
/* What comes from a direction of the body frame on the Earth: row[nbin] overwritten [W/m^2/sr/m],
 * and the albedo there [1]. */
void um_optics_earth_toward(const struct um_optics_spectra *spectra,
                            const struct um_optics_instant *instant, struct um_vec3 direction,
                            const struct um_optics_work *work, double *row, double *albedo);
/* What the lobe of surfaces that face one way sees of the Earth. */
struct um_optics_earth_shares {
  struct um_optics_earth_lobe lobe;
  double whole; /* view factor of a plate that nothing hides the Earth from [1] */
};
/* Of a surface; nothing is done where no lobe mirrors the Earth. */
void um_optics_earth_shares(const struct um_optics_spectra *spectra,
                            const struct um_optics_instant *instant, size_t skin,
                            const struct um_optics_sight *sight,
                            struct um_optics_earth_shares *shares);
/* Sums over surfaces that face one way: projected area times what each sees of the Earth. */
struct um_optics_earth_seen {
  double view_factor;      /* [m^2] */
  double clear, clear_lit; /* times the share of the Earth before the plate that is not hidden; of
                              surfaces that are lit by it [m^2] */
};
/* Where the Earth varies the first of them goes times B(T_b) into the sum of the work. area:
 * area_seen cos_o [m^2]. */
void um_optics_earth_seen_add(const struct um_optics_spectra *spectra,
                              const struct um_optics_instant *instant,
                              const struct um_optics_earth_shares *shares,
                              const struct um_optics_sight *sight, double area,
                              struct um_optics_work *work, struct um_optics_earth_seen *earth);
/* Does a skin reflect the Earth's own radiation by its view factor alone: no lobe that mirrors it,
 * and 1 - eps the same toward all sides? A diffuse emitter may well have a lobe. */
bool um_optics_reflects_evenly(const struct um_optics_spectra *spectra,
                               const struct um_optics_instant *instant, size_t skin);
/* Earthshine in the lobe into the sum, and the Earth's own radiation reflected. emissivity: [nbin]
 * toward the observer. The lobe is what 1 - eps leaves beside the diffuse parts, so that an Earth
 * all round gives 1 - eps to the last digit. */
void um_optics_add_earth(const struct um_optics_spectra *spectra,
                         const struct um_optics_instant *instant, size_t skin,
                         const struct um_optics_sight *sight,
                         const struct um_optics_earth_shares *shares,
                         const struct um_optics_earth_seen *earth, const double *emissivity,
                         struct um_optics_work *work, struct um_optics_sum *sum);

void um_optics_sum_clear(const struct um_optics_spectra *spectra, struct um_optics_sum *sum);
/* Add surfaces of one skin that face the same way, sight[count]: cosines, grain and patches are
 * those of the first. shares: of all of them (um_optics_earth_shares). */
void um_optics_sum_add(const struct um_optics_spectra *spectra,
                       const struct um_optics_instant *instant, size_t skin,
                       const struct um_optics_sight *sight, size_t count,
                       const struct um_optics_earth_shares *shares, struct um_optics_work *work,
                       struct um_optics_sum *sum);
/* F per bin of a material's lobe at this instant; kept in the work until the next instant. */
const double *um_optics_specular(const struct um_optics_spectra *spectra,
                                 const struct um_optics_scene *scene,
                                 const struct um_optics_instant *instant, size_t skin,
                                 struct um_optics_work *work);
/* Spectral radiant intensity of a sum, spectral[nbin][UM_MECHANISM_COUNT] [W/sr/m], overwritten. */
void um_optics_sum_spectrum(const struct um_optics_spectra *spectra,
                            const struct um_optics_scene *scene,
                            const struct um_optics_instant *instant, size_t skin,
                            const struct um_optics_sum *sum, struct um_optics_work *work,
                            double *spectral);

#endif
