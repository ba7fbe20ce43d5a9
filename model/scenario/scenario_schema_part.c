/* Keys of scenario.yaml: parts: what they are made of, walls, insulation, what is inside; contacts.
 */
#include "model/scenario/scenario_schema_group.h"

static const int one[] = {1, 0};

#define F(member, key, type, ...) UM_FIELD(struct um_scenario_skin, member, key, type, __VA_ARGS__)
static const struct um_schema_field skin_fields[] = {
    F(front, "front", UM_SCHEMA_TEXT, NAME, REQUIRED, HELP("material outside, or of the front")),
    F(back, "back", UM_SCHEMA_TEXT, NAME, HELP("material of the back of an open surface")),
};
#undef F
OBJECT(skin_object, struct um_scenario_skin, "materials of a group", "What a group is made of.",
       FIELDS(skin_fields), .scalar_key = "front");

#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_honeycomb, member, key, type, __VA_ARGS__)
static const struct um_schema_field honeycomb_fields[] = {
    F(material, "material", UM_SCHEMA_TEXT, NAME, REQUIRED, HELP("record of the faces")),
    F(face_mm, "face_mm", UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e3), HELP("thickness of one face")),
    F(core_mm, "core_mm", UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e4), HELP("height of the core")),
    F(core_density_kg_m3, "core_density_kg_m3", UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e4),
      HELP("of the core as a block; its share of foil is this over the foil's")),
    F(core_material, "core_material", UM_SCHEMA_TEXT, NAME,
      HELP("record of the core's foil; default that of the faces")),
};
#undef F
OBJECT(honeycomb_object, struct um_scenario_honeycomb, "honeycomb",
       "A panel of two faces and a core of cells.", FIELDS(honeycomb_fields));

#define F(member, key, type, ...) UM_FIELD(struct um_scenario_shell, member, key, type, __VA_ARGS__)
static const struct um_schema_field shell_fields[] = {
    F(areal_heat_capacity_J_m2_K, "areal_heat_capacity_J_m2_K", UM_SCHEMA_NUMBER, NO_DEFAULT,
      POSITIVE(1e9), HELP("of the whole wall; or by material and thickness_mm")),
    F(conductance_W_K, "conductance_W_K", UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1e6),
      HELP("in plane, k t; default 0, or by material and thickness_mm")),
    F(through_conductance_W_m2_K, "through_conductance_W_m2_K", UM_SCHEMA_NUMBER, NO_DEFAULT,
      BETWEEN(0, 1e9), HELP("between the two sides; default: both sides are one temperature")),
    F(front_share, "front_share", UM_SCHEMA_NUMBER, DEFAULT(0.5), BETWEEN(0.001, 0.999),
      HELP("share of capacity and conductance in the front layer")),
    F(material, "material", UM_SCHEMA_TEXT, NAME,
      HELP("record whose thermal properties fill the wall")),
    F(thickness_mm, "thickness_mm", UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e4),
      HELP("of the wall, with material")),
    F(honeycomb, "honeycomb", UM_SCHEMA_MAP, .object = &honeycomb_object),
};
#undef F
OBJECT(shell_object, struct um_scenario_shell, "shell", "The wall of a part as a thin sheet.",
       FIELDS(shell_fields));
static const char *const mli_laws[] = {"constant", "doenecke", "lockheed", NULL};
#define F(member, key, type, ...) UM_FIELD(struct um_scenario_mli, member, key, type, __VA_ARGS__)
static const struct um_schema_field mli_fields[] = {
    F(law, "law", UM_SCHEMA_CHOICE, DEFAULT(0), .choices = mli_laws,
      HELP("how e* goes with the mean temperature of its sides: one number; Doenecke 1993; "
           "Lockheed (NASA CR-134477)")),
    F(effective_emittance, "effective_emittance", UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1),
      HELP("e*, between the outer layer and what it wraps; of law: constant, which needs it")),
    F(factor, "factor", UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(100),
      HELP("f_N f_A f_p of law: doenecke, for number of layers, area and perforation; default 1")),
    F(layers, "layers", UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(1, 1000),
      HELP("shields, of law: lockheed, which needs it")),
    F(layers_per_cm, "layers_per_cm", UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1000),
      HELP("density of shields, of law: lockheed, which needs it")),
    F(shield_emittance, "shield_emittance", UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1),
      HELP("of one shield at 300 K, of law: lockheed; default 0.031")),
    F(seam_length_m, "seam_length_m", UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1e6),
      HELP("of all seams of the groups that it covers")),
    F(seam_conductance_W_m_K, "seam_conductance_W_m_K", UM_SCHEMA_NUMBER, NO_DEFAULT,
      BETWEEN(0, 1e3), HELP("heat conducted past the blanket per length of seam")),
    F(areal_heat_capacity_J_m2_K, "areal_heat_capacity_J_m2_K", UM_SCHEMA_NUMBER, REQUIRED,
      POSITIVE(1e6), HELP("of the outer layer")),
    F(wraps, "wraps", UM_SCHEMA_TEXT, NAME,
      HELP("wall, which is the default, or directly (then there is no wall) interior or one of "
           "interiors")),
};
#undef F
OBJECT(mli_object, struct um_scenario_mli, "mli", "Multi-layer insulation on the outside.",
       FIELDS(mli_fields));
#define POWER_FILE                                                                                 \
  "CSV time_utc,power_W, added to power_W: linear between rows, a jump where two rows have one "   \
  "time, 0 before the first and after the last; satellite's own time"
#define INSIDE_CONDUCTIVITY                                                                        \
  "0: one node; above: tetrahedra that fill the part, which is closed, capacity and power spread " \
  "by volume"
#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_interior, member, key, type, __VA_ARGS__)
static const struct um_schema_field interior_fields[] = {
    F(capacity_J_K, "capacity_J_K", UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e12),
      HELP("of everything inside")),
    F(power_W, "power_W", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-1e6, 1e6),
      HELP("dissipated inside")),
    F(power_file, "power_file", UM_SCHEMA_TEXT, NAMES_FILE, HELP(POWER_FILE)),
    F(conductance_W_K, "conductance_W_K", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e6),
      HELP("to the walls, shared by area among groups that state none")),
    F(conductivity_W_m_K, "conductivity_W_m_K", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e5),
      HELP(INSIDE_CONDUCTIVITY)),
    F(tetrahedron_size_m, "tetrahedron_size_m", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e3),
      HELP("of that solid: longest edge wanted; 0: the facet size")),
};
#undef F
OBJECT(interior_object, struct um_scenario_interior, "interior",
       "What is inside the part: one node, or a solid that fills it.", FIELDS(interior_fields));
#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_interior, member, key, type, __VA_ARGS__)
static const struct um_schema_field interiors_fields[] = {
    F(capacity_J_K, "capacity_J_K", UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1e12),
      HELP("0: it balances at every instant (arithmetic node); not needed with temperature_K")),
    F(power_W, "power_W", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-1e6, 1e6),
      HELP("dissipated in it")),
    F(power_file, "power_file", UM_SCHEMA_TEXT, NAMES_FILE, HELP(POWER_FILE)),
    F(conductance_W_K, "conductance_W_K", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e6),
      HELP("to the walls, shared by area among groups that state none for it")),
    F(temperature_K, "temperature_K", UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(5000),
      HELP("given and kept, whatever flows (boundary node)")),
    F(conductivity_W_m_K, "conductivity_W_m_K", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e5),
      HELP(INSIDE_CONDUCTIVITY)),
    F(tetrahedron_size_m, "tetrahedron_size_m", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e3),
      HELP("of that solid: longest edge wanted; 0: the facet size")),
};
#undef F
OBJECT(interiors_object, struct um_scenario_interior, "interiors",
       "A node inside the part with a name: frame, boards, battery. Contacts join them.",
       FIELDS(interiors_fields));
#define F(member, key, type, ...) UM_FIELD(struct um_scenario_solid, member, key, type, __VA_ARGS__)
static const struct um_schema_field solid_fields[] = {
    F(material, "material", UM_SCHEMA_TEXT, NAME,
      HELP("record with density, specific heat, conductivity")),
    F(density_kg_m3, "density_kg_m3", UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e5),
      HELP("instead of the record's")),
    F(specific_heat_J_kg_K, "specific_heat_J_kg_K", UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e5),
      HELP("instead of the record's")),
    F(conductivity_W_m_K, "conductivity_W_m_K", UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e5),
      HELP("instead of the record's")),
    F(tetrahedron_size_m, "tetrahedron_size_m", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e3),
      HELP("longest edge wanted; 0: the facet size")),
    F(power_W, "power_W", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-1e6, 1e6),
      HELP("dissipated inside, spread by volume")),
    F(power_file, "power_file", UM_SCHEMA_TEXT, NAMES_FILE, HELP(POWER_FILE)),
};
#undef F
OBJECT(solid_object, struct um_scenario_solid, "solid",
       "The part is solid: tetrahedra, three-dimensional conduction.", FIELDS(solid_fields),
       .scalar_key = "material");
#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_network, member, key, type, __VA_ARGS__)
static const struct um_schema_field network_fields[] = {
    F(nodes, "nodes", UM_SCHEMA_TEXT, NAMES_FILE, REQUIRED,
      HELP(
          "CSV name,kind,capacity_J_K,T0_K,power_W; kind diffusive, arithmetic or boundary. A node "
          "of the name of each group, and GROUP.back, carries its surfaces; all others are "
          "inside")),
    F(conductors, "conductors", UM_SCHEMA_TEXT, NAMES_FILE, REQUIRED,
      HELP("CSV kind,a,b,value; kind GL [W/K] or GR [m2], GR also to space")),
};
#undef F
OBJECT(network_object, struct um_scenario_network, "network",
       "Nodes and conductors in place of walls and interiors; shape and materials stay for light "
       "and radiation.",
       FIELDS(network_fields));
#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_inner_conductance, member, key, type, __VA_ARGS__)
static const struct um_schema_field inner_conductance_fields[] = {
    F(conductance_W_K, "conductance_W_K", UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(0, 1e6),
      HELP("of the whole group to that interior")),
};
#undef F
OBJECT(inner_conductance_object, struct um_scenario_inner_conductance, "conductance to an interior",
       "How a group holds one of the interiors.", FIELDS(inner_conductance_fields),
       .scalar_key = "conductance_W_K");
#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_heat_pipe, member, key, type, __VA_ARGS__)
static const struct um_schema_field heat_pipe_fields[] = {
    F(conductance_W_K, "conductance_W_K", UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e9),
      HELP("of all evaporators and condensers, between wall and vapour, by area")),
    F(capacity_J_K, "capacity_J_K", UM_SCHEMA_NUMBER, DEFAULT(50.0), POSITIVE(1e9),
      HELP("of the fluid: some 10 g of ammonia")),
};
#undef F
OBJECT(heat_pipe_object, struct um_scenario_heat_pipe, "heat pipe",
       "Heat pipes in the wall of a group: their vapour is one temperature.",
       FIELDS(heat_pipe_fields), .scalar_key = "conductance_W_K");
#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_creases, member, key, type, __VA_ARGS__)
static const struct um_schema_field creases_fields[] = {
    F(tilt_rms_deg, "tilt_rms_deg", UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(0, 30),
      HELP("of the patches about each of two axes in the surface, root mean square")),
    F(patch_m, "patch_m", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 10),
      HELP("edge of a patch; 0: too small to tell apart, the lobe is as wide as their mean")),
    F(seed, "seed", UM_SCHEMA_INTEGER, DEFAULT(1), BETWEEN(0, 1e9),
      HELP("another number, other creases of the same kind")),
};
#undef F
OBJECT(creases_object, struct um_scenario_creases, "creases",
       "A blanket that hangs in flat patches, each tilted a little.", FIELDS(creases_fields));
#define F(member, key, type, ...) UM_FIELD(struct um_scenario_group, member, key, type, __VA_ARGS__)
static const struct um_schema_field group_fields[] = {
    F(shell, "shell", UM_SCHEMA_MAP, .object = &shell_object),
    F(mli, "mli", UM_SCHEMA_MAP, .object = &mli_object),
    F(heat_pipe, "heat_pipe", UM_SCHEMA_MAP, .object = &heat_pipe_object),
    F(creases, "creases", UM_SCHEMA_MAP, .object = &creases_object),
    F(bare, "bare", UM_SCHEMA_BOOL, DEFAULT(0), HELP("no MLI here although the part has one")),
    F(interior_conductance_W_K, "interior_conductance_W_K", UM_SCHEMA_NUMBER, NO_DEFAULT,
      BETWEEN(0, 1e6), HELP("of the whole group to the interior")),
    F(conductances, "conductances_W_K", UM_SCHEMA_DICT, MOST(1000), .behind = true,
      .object = &inner_conductance_object,
      HELP("of the whole group to each of interiors, by its name")),
    F(power_W, "power_W", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-1e6, 1e6),
      HELP("dissipated in the wall of the group, both layers")),
    F(power_file, "power_file", UM_SCHEMA_TEXT, NAMES_FILE, HELP(POWER_FILE)),
    F(inside_emittance, "inside_emittance", UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1),
      HELP("of the inner face; default the part's")),
};
#undef F
OBJECT(group_object, struct um_scenario_group, "group", "What differs thermally on one group.",
       FIELDS(group_fields));

#define F(member, key, type, ...) UM_FIELD(struct um_scenario_part, member, key, type, __VA_ARGS__)
static const struct um_schema_field part_fields[] = {
    F(name, "name", UM_SCHEMA_TEXT, NAME, REQUIRED, HELP("unique; no dots, no slashes")),
    F(parent, "parent", UM_SCHEMA_TEXT, NAME,
      HELP("part that carries this one; default: the body frame")),
    F(box, "box", UM_SCHEMA_MAP, .object = &um_model_box_schema, .alternative = 1),
    F(plate, "plate", UM_SCHEMA_MAP, .object = &um_model_plate_schema, .alternative = 1),
    F(disc, "disc", UM_SCHEMA_MAP, .object = &um_model_disc_schema, .alternative = 1),
    F(cylinder, "cylinder", UM_SCHEMA_MAP, .object = &um_model_cylinder_schema, .alternative = 1),
    F(cone, "cone", UM_SCHEMA_MAP, .object = &um_model_cone_schema, .alternative = 1),
    F(sphere, "sphere", UM_SCHEMA_MAP, .object = &um_model_sphere_schema, .alternative = 1),
    F(paraboloid, "paraboloid", UM_SCHEMA_MAP, .object = &um_model_paraboloid_schema,
      .alternative = 1),
    F(mesh, "mesh", UM_SCHEMA_MAP, .object = &um_model_mesh_schema, .alternative = 1),
    F(pose, "pose", UM_SCHEMA_MAP, .object = &um_model_pose_schema),
    F(joint, "joint", UM_SCHEMA_MAP, .object = &um_model_joint_schema),
    F(grain, "grain", UM_SCHEMA_VECTOR, DEFAULT(0.0), .length = 3,
      HELP("direction of brushing, rolling or tows, in the part, projected on each facet; lobes "
           "with "
           "alpha_across are wider across it; default x, where that stands upright y")),
    F(outside, "outside", UM_SCHEMA_TEXT, NAME, HELP("material of a closed part")),
    F(front, "front", UM_SCHEMA_TEXT, NAME, HELP("material of the front of an open part")),
    F(back, "back", UM_SCHEMA_TEXT, NAME, HELP("material of the back of an open part")),
    F(materials, "materials", UM_SCHEMA_DICT, MOST(10000), .behind = true, .object = &skin_object,
      HELP("material by group, before outside/front/back")),
    F(groups, "groups", UM_SCHEMA_DICT, MOST(10000), .behind = true, .object = &group_object,
      HELP("thermal properties by group, before the part's own")),
    F(shell, "shell", UM_SCHEMA_MAP, .object = &shell_object),
    F(mli, "mli", UM_SCHEMA_MAP, .object = &mli_object),
    F(creases, "creases", UM_SCHEMA_MAP, .object = &creases_object,
      HELP("of all its groups but those that are bare")),
    F(interior, "interior", UM_SCHEMA_MAP, .object = &interior_object),
    F(interiors, "interiors", UM_SCHEMA_DICT, MOST(1000), .behind = true,
      .object = &interiors_object,
      HELP("several nodes inside the part by name, beside interior; places PART.NAME")),
    F(solid, "solid", UM_SCHEMA_MAP, .object = &solid_object),
    F(network, "network", UM_SCHEMA_MAP, .object = &network_object),
    F(lumped, "lumped", UM_SCHEMA_BOOL, DEFAULT(0), HELP("one isothermal node per group and side")),
    F(facet_size_m, "facet_size_m", UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e4),
      HELP("longest facet edge; default thermal.facet_size_m")),
    F(start_temperature_K, "start_temperature_K", UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(5000),
      HELP("default thermal.start_temperature_K")),
    F(electrical_extraction, "electrical_extraction", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1),
      HELP("share of direct sunlight on the front that leaves as electricity")),
    F(inside_emittance, "inside_emittance", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1),
      HELP("of the inner faces of a closed part, which then heat each other; a wall with "
           "through_conductance_W_m2_K then has an inner layer; what stands inside takes part by "
           "radiative contacts; 0: they do not radiate")),
};
#undef F
SHARED_OBJECT(um_model_part_schema, struct um_scenario_part, "part", "One piece of the satellite.",
              FIELDS(part_fields), .exactly_one = one);

#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_contact, member, key, type, __VA_ARGS__)
static const struct um_schema_field contact_fields[] = {
    F(a, "a", UM_SCHEMA_TEXT, NAME, REQUIRED,
      HELP("part, part.group, part.front, part.back, part.interior or part.NAME of interiors")),
    F(b, "b", UM_SCHEMA_TEXT, NAME, REQUIRED, HELP("the other end")),
    F(conductance_W_K, "conductance_W_K", UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1e9),
      HELP("of the whole contact; or one that radiates:")),
    F(exchange_area_m2, "exchange_area_m2", UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1e9),
      HELP("radiative conductance: sigma times it times T_a^4 - T_b^4 flows from a to b")),
    F(area_m2, "area_m2", UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1e9),
      HELP("with exchange_factor: the same as their product")),
    F(exchange_factor, "exchange_factor", UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1),
      HELP("of grey surfaces, 1 / (1/e_a + 1/e_b - 1) between plates close together")),
};
#undef F
SHARED_OBJECT(um_model_contact_schema, struct um_scenario_contact, "contact",
              "Heat conducted or radiated between two places.", FIELDS(contact_fields));
