/* Physical constants, SI, once. */
#ifndef UMBRA_CORE_CONSTANTS_H
#define UMBRA_CORE_CONSTANTS_H

#define UM_PI     3.14159265358979323846
#define UM_DEG    (UM_PI / 180.0)    /* [rad] per degree */
#define UM_ARCSEC (UM_PI / 648000.0) /* [rad] per arc second */

#define UM_PLANCK           6.62607015e-34 /* h [J s], SI 2019 exact */
#define UM_LIGHT_SPEED      299792458.0    /* c [m/s], SI exact */
#define UM_BOLTZMANN        1.380649e-23   /* k [J/K], SI 2019 exact */
#define UM_STEFAN_BOLTZMANN 5.670374419e-8 /* sigma [W/m^2/K^4], CODATA 2018 */
/* from the exact constants: 2 h c^2 [W m^2 / sr] and h c / k [m K] */
#define UM_RADIATION_C1L 1.19104297239718838e-16
#define UM_RADIATION_C2  1.43877687750393387e-2

#define UM_SOLAR_IRRADIANCE  1361.0         /* at 1 au [W/m^2], Kopp & Lean 2011 */
#define UM_SOLAR_RADIUS      695700.0e3     /* nominal [m], IAU 2015 B3 */
#define UM_SOLAR_TEMPERATURE 5772.0         /* effective [K], IAU 2015 B3 */
#define UM_AU                149597870700.0 /* [m], IAU 2012 B2 */
#define UM_LUNAR_RADIUS      1737.4e3 /* mean [m], Archinal et al. 2011, Celest. Mech. 109:101 */

#define UM_EARTH_RADIUS     6378137.0             /* WGS-84 a [m] */
#define UM_EARTH_FLATTENING (1.0 / 298.257223563) /* WGS-84 f */
#define UM_EARTH_GM         3.986004418e14        /* [m^3/s^2], WGS-84 */
#define UM_EARTH_ROTATION   7.29211514670698e-5   /* [rad/s], IERS, LOD = 0 */

/* Sunlight below, heat from here on: below lie 97 % of the Sun's power and 6e-6 of that of a black
 * body of 300 K. */
#define UM_INFRARED_FROM 2.5e-6 /* [m] */

/* What a record or a network states holds here: emittances, capacities, conductances. By
 * convention, near the room temperature at which they are measured. */
#define UM_REFERENCE_TEMPERATURE 300.0 /* [K] */

#define UM_ZERO_CELSIUS      273.15 /* 0 C [K], SI exact */
#define UM_SPACE_TEMPERATURE 2.7    /* deep space [K], Fixsen 2009 rounded */
#define UM_LN10              2.30258509299404568402
#define UM_POGSON            (2.5 / UM_LN10) /* one unit of ln(flux) [mag], Pogson 1856 */
#define UM_AB_ZERO_JY        3631.0          /* AB zero point [Jy], Oke & Gunn 1983 */

/* What is called umbra, penumbra and sunlight, by the sunlit fraction [1]. The Earth's air has no
 * edge: from both sides it leads to exactly 0 and 1 over half a minute of next to nothing. */
#define UM_UMBRA_MOST     1e-3
#define UM_SUNLIGHT_LEAST 0.999

#endif
