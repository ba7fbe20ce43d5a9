/* Thin clouds of ice before the sky: what their crystals take out of a beam, and what they absorb.
 */
#ifndef UMBRA_ENVIRONMENT_CIRRUS_H
#define UMBRA_ENVIRONMENT_CIRRUS_H

/* Per unit of the optical depth at 0.55 um [1]. */
struct um_environment_ice {
  double extinction; /* scattered and absorbed: what the image of a star or a satellite loses [1] */
  double absorption; /* what glows: heat that is scattered forward comes from sky as cold [1] */
};

/* Ice crystals at a wavelength [m], 7.0 to 14.5 um; below 2 um grey and without absorption, between
 * and beyond the nearest row. General habit mixture, severely roughened, effective radius 20 um:
 * Baum et al. 2014, J. Quant. Spectrosc. Radiat. Transf. 146:123, as distributed with ECMWF's
 * ecRad. Hexagonal columns of the same effective size (Fu et al. 1998, J. Climate 11:2223) have 5
 * to 9 % more of both; effective radii of 10 and 40 um 0.88 and 0.99 in place of 0.97 of
 * extinction, 0.36 and 0.44 in place of 0.41 of absorption, means over 8-12 um. In 0.3-1.16 um the
 * mixture stays within 2 % of grey. Test: environment/cirrus. */
struct um_environment_ice um_environment_ice_at(double wavelength);

#endif
