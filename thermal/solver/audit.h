/* Heat as it is audited. */
#ifndef UMBRA_THERMAL_AUDIT_H
#define UMBRA_THERMAL_AUDIT_H

/* Heat of one node or the whole [W] (history) or [J] (audit). planet: what the Earth emits, and
 * what its atmosphere brings where loads have that. stored = sum of the others. */
struct um_thermal_heat {
  double solar, albedo, planet, internal, conducted, radiated, exchanged, stored;
};
/* Heat over a stretch of time, of the whole satellite. */
struct um_thermal_audit {
  struct um_thermal_heat heat; /* integrals [J] */
  double content;              /* largest heat content at an end of the stretch [J] */
};

#endif
