/* Keys of scenario.yaml: parts: what they are made of, walls, insulation, what is inside; contacts.
 */
#include "model/scenario/scenario_schema_group.h"

static const int one[] = {1, 0};

#define OF struct um_scenario_skin
static const struct um_schema_field skin_fields[] = {
    F(front, UM_SCHEMA_TEXT, NAME, REQUIRED, HELP("material outside, or of the front")),
    F(back, UM_SCHEMA_TEXT, NAME, HELP("material of the back of an open surface")),
};
#undef OF
OBJECT(skin_object, struct um_scenario_skin, "materials of a group", "What a group is made of.",
       FIELDS(skin_fields), .scalar_key = "front");

#define OF struct um_scenario_honeycomb
static const struct um_schema_field honeycomb_fields[] = {
    F(material, UM_SCHEMA_TEXT, NAME, REQUIRED, HELP("record of the faces")),
    F(face_mm, UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e3), HELP("thickness of one face")),
    F(core_mm, UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e4), HELP("height of the core")),
    F(core_density_kg_m3, UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e4),
      HELP("of the core as a block; its share of foil is this over the foil's")),
    F(core_material, UM_SCHEMA_TEXT, NAME,
      HELP("record of the core's foil; default that of the faces")),
};
#undef OF
OBJECT(honeycomb_object, struct um_scenario_honeycomb, "honeycomb",
       "A panel of two faces and a core of cells.", FIELDS(honeycomb_fields));

/* What a layer or a solid is made of. */
#define MATTER                                                                                     \
  F(material, UM_SCHEMA_TEXT, NAME, HELP("record with density, specific heat, conductivity")),     \
      F(density_kg_m3, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e5),                                \
        HELP("instead of the record's")),                                                          \
      F(specific_heat_J_kg_K, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e5),                         \
        HELP("instead of the record's")),                                                          \
      F(conductivity_W_m_K, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e5),                           \
        HELP("instead of the record's"))

#define OF struct um_scenario_layer
static const struct um_schema_field layer_fields[] = {
    F(thickness_mm, UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e4), HELP("of the layer")),
    MATTER,
    F(cells, UM_SCHEMA_INTEGER, DEFAULT(2), BETWEEN(1, 50),
      HELP("into which its thickness is cut, a node between one and the next")),
};
#undef OF
OBJECT(layer_object, struct um_scenario_layer, "layer", "One layer of a wall.",
       FIELDS(layer_fields));

#define OF struct um_scenario_shell
static const struct um_schema_field shell_fields[] = {
    F(areal_heat_capacity_J_m2_K, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e9),
      HELP("of the whole wall; or by material and thickness_mm")),
    F(conductance_W_K, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1e6),
      HELP("in plane, k t; default 0, or by material and thickness_mm")),
    F(through_conductance_W_m2_K, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1e9),
      HELP("between the two sides; default: both sides are one temperature")),
    F(front_share, UM_SCHEMA_NUMBER, DEFAULT(0.5), BETWEEN(0.001, 0.999),
      HELP("share of capacity and conductance in the front layer")),
    F(material, UM_SCHEMA_TEXT, NAME, HELP("record whose thermal properties fill the wall")),
    F(thickness_mm, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e4),
      HELP("of the wall, with material")),
    F(honeycomb, UM_SCHEMA_MAP, .object = &honeycomb_object),
    F(layers, UM_SCHEMA_LIST, MOST(100), .object = &layer_object,
      HELP("front first: nodes in the thickness, of a wall whose two sides radiate; in place of "
           "material, honeycomb and numbers of the wall; in plane conductance_W_K, or theirs")),
};
#undef OF
OBJECT(shell_object, struct um_scenario_shell, "shell", "The wall of a part as a thin sheet.",
       FIELDS(shell_fields));
static const char *const mli_laws[] = {"constant", "doenecke", "lockheed", NULL};
#define OF struct um_scenario_mli
static const struct um_schema_field mli_fields[] = {
    F(law, UM_SCHEMA_CHOICE, DEFAULT(0), .choices = mli_laws,
      HELP("how e* goes with the mean temperature of its sides: one number; Doenecke 1993; "
           "Lockheed (NASA CR-134477)")),
    F(effective_emittance, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1),
      HELP("e*, between the outer layer and what it wraps; of law: constant, which needs it")),
    F(factor, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(100),
      HELP("f_N f_A f_p of law: doenecke, for number of layers, area and perforation; default 1")),
    F(layers, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(1, 1000),
      HELP("shields, of law: lockheed, which needs it")),
    F(layers_per_cm, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1000),
      HELP("density of shields, of law: lockheed, which needs it")),
    F(shield_emittance, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1),
      HELP("of one shield at 300 K, of law: lockheed; default 0.031")),
    F(seam_length_m, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1e6),
      HELP("of all seams of the groups that it covers")),
    F(seam_conductance_W_m_K, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1e3),
      HELP("heat conducted past the blanket per length of seam")),
    F(areal_heat_capacity_J_m2_K, UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e6),
      HELP("of the outer layer")),
    F(sheets, UM_SCHEMA_INTEGER, DEFAULT(0), BETWEEN(0, 50),
      HELP("under the outer layer that store heat, alike and in a row; e* is shared evenly by the "
           "gaps on the way in, one more than sheets")),
    F(sheets_areal_heat_capacity_J_m2_K, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e6),
      HELP("of all sheets together, which need it; 6 um of Mylar has 10")),
    F(wraps, UM_SCHEMA_TEXT, NAME,
      HELP("wall, which is the default, or directly (then there is no wall) interior or one of "
           "interiors")),
};
#undef OF
OBJECT(mli_object, struct um_scenario_mli, "mli", "Multi-layer insulation on the outside.",
       FIELDS(mli_fields));
#define POWER_FILE                                                                                 \
  "CSV time_utc,power_W, added to power_W: linear between rows, a jump where two rows have one "   \
  "time, 0 before the first and after the last; satellite's own time"
#define INSIDE_CONDUCTIVITY                                                                        \
  "0: one node; above: tetrahedra that fill the part, which is closed, capacity and power spread " \
  "by volume"
#define OF struct um_scenario_interior
static const struct um_schema_field interior_fields[] = {
    F(capacity_J_K, UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e12), HELP("of everything inside")),
    F(power_W, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-1e6, 1e6), HELP("dissipated inside")),
    F(power_file, UM_SCHEMA_TEXT, NAMES_FILE, HELP(POWER_FILE)),
    F(conductance_W_K, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e6),
      HELP("to the walls, shared by area among groups that state none")),
    F(conductivity_W_m_K, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e5),
      HELP(INSIDE_CONDUCTIVITY)),
    F(tetrahedron_size_m, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e3),
      HELP("of that solid: longest edge wanted; 0: the facet size")),
};
#undef OF
OBJECT(interior_object, struct um_scenario_interior, "interior",
       "What is inside the part: one node, or a solid that fills it.", FIELDS(interior_fields));
#define OF struct um_scenario_interior
static const struct um_schema_field interiors_fields[] = {
    F(capacity_J_K, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1e12),
      HELP("0: it balances at every instant (arithmetic node); not needed with temperature_K")),
    F(power_W, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-1e6, 1e6), HELP("dissipated in it")),
    F(power_file, UM_SCHEMA_TEXT, NAMES_FILE, HELP(POWER_FILE)),
    F(conductance_W_K, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e6),
      HELP("to the walls, shared by area among groups that state none for it")),
    F(temperature_K, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(5000),
      HELP("given and kept, whatever flows (boundary node)")),
    F(conductivity_W_m_K, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e5),
      HELP(INSIDE_CONDUCTIVITY)),
    F(tetrahedron_size_m, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e3),
      HELP("of that solid: longest edge wanted; 0: the facet size")),
};
#undef OF
OBJECT(interiors_object, struct um_scenario_interior, "interiors",
       "A node inside the part with a name: frame, boards, battery. Contacts join them.",
       FIELDS(interiors_fields));
#define OF struct um_scenario_solid
static const struct um_schema_field solid_fields[] = {
    MATTER,
    F(tetrahedron_size_m, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e3),
      HELP("longest edge wanted; 0: the facet size")),
    F(power_W, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-1e6, 1e6),
      HELP("dissipated inside, spread by volume")),
    F(power_file, UM_SCHEMA_TEXT, NAMES_FILE, HELP(POWER_FILE)),
};
#undef OF
OBJECT(solid_object, struct um_scenario_solid, "solid",
       "The part is solid: tetrahedra, three-dimensional conduction.", FIELDS(solid_fields),
       .scalar_key = "material");
#define OF struct um_scenario_network
static const struct um_schema_field network_fields[] = {
    F(nodes, UM_SCHEMA_TEXT, NAMES_FILE, REQUIRED,
      HELP("CSV name,kind,capacity_J_K,T0_K,power_W; kind diffusive, arithmetic or boundary. Or a "
           "network of ESATAN, a file .d, without conductors beside it. A node of the name of each "
           "group, and GROUP.back, carries its surfaces; all others are inside")),
    F(conductors, UM_SCHEMA_TEXT, NAMES_FILE,
      HELP("CSV kind,a,b,value; kind GL [W/K] or GR [m2], GR also to space")),
};
#undef OF
OBJECT(network_object, struct um_scenario_network, "network",
       "Nodes and conductors in place of walls and interiors; shape and materials stay for light "
       "and radiation.",
       FIELDS(network_fields));
#define OF struct um_scenario_inner_conductance
static const struct um_schema_field inner_conductance_fields[] = {
    F(conductance_W_K, UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(0, 1e6),
      HELP("of the whole group to that interior")),
};
#undef OF
OBJECT(inner_conductance_object, struct um_scenario_inner_conductance, "conductance to an interior",
       "How a group holds one of the interiors.", FIELDS(inner_conductance_fields),
       .scalar_key = "conductance_W_K");
#define OF struct um_scenario_heat_pipe
static const struct um_schema_field heat_pipe_fields[] = {
    F(conductance_W_K, UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e9),
      HELP("of all evaporators and condensers, between wall and vapour, by area")),
    F(capacity_J_K, UM_SCHEMA_NUMBER, DEFAULT(50.0), POSITIVE(1e9),
      HELP("of the fluid: some 10 g of ammonia")),
};
#undef OF
OBJECT(heat_pipe_object, struct um_scenario_heat_pipe, "heat pipe",
       "Heat pipes in the wall of a group: their vapour is one temperature.",
       FIELDS(heat_pipe_fields), .scalar_key = "conductance_W_K");
#define OF struct um_scenario_creases
static const struct um_schema_field creases_fields[] = {
    F(tilt_rms_deg, UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(0, 30),
      HELP("of the patches about each of two axes in the surface, root mean square")),
    F(patch_m, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 10),
      HELP("edge of a patch; 0: too small to tell apart, the lobe is as wide as their mean")),
    F(seed, UM_SCHEMA_INTEGER, DEFAULT(1), BETWEEN(0, 1e9),
      HELP("another number, other patches of the same kind")),
};
#undef OF
OBJECT(creases_object, struct um_scenario_creases, "creases",
       "A blanket or a panel of flat patches, each tilted a little.", FIELDS(creases_fields));
#define OF struct um_scenario_group
static const struct um_schema_field group_fields[] = {
    F(shell, UM_SCHEMA_MAP, .object = &shell_object),
    F(mli, UM_SCHEMA_MAP, .object = &mli_object),
    F(heat_pipe, UM_SCHEMA_MAP, .object = &heat_pipe_object),
    F(creases, UM_SCHEMA_MAP, .object = &creases_object),
    F(flatness, UM_SCHEMA_MAP, .object = &creases_object,
      HELP("where it has neither MLI nor creases")),
    F(bare, UM_SCHEMA_BOOL, DEFAULT(0), HELP("no MLI here although the part has one")),
    F(interior_conductance_W_K, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1e6),
      HELP("of the whole group to the interior")),
    F_AS(conductances, "conductances_W_K", UM_SCHEMA_DICT, MOST(1000), .behind = true,
         .object = &inner_conductance_object,
         HELP("of the whole group to each of interiors, by its name")),
    F(power_W, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-1e6, 1e6),
      HELP("dissipated in the wall of the group, both layers")),
    F(power_file, UM_SCHEMA_TEXT, NAMES_FILE, HELP(POWER_FILE)),
    F(inside_emittance, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1),
      HELP("of the inner face; default the part's")),
};
#undef OF
OBJECT(group_object, struct um_scenario_group, "group", "What differs thermally on one group.",
       FIELDS(group_fields));

#define OF struct um_scenario_part
static const struct um_schema_field part_fields[] = {
    F(name, UM_SCHEMA_TEXT, NAME, REQUIRED, HELP("unique; no dots, no slashes")),
    F(parent, UM_SCHEMA_TEXT, NAME, HELP("part that carries this one; default: the body frame")),
    F(box, UM_SCHEMA_MAP, .object = &um_model_box_schema, .alternative = 1),
    F(plate, UM_SCHEMA_MAP, .object = &um_model_plate_schema, .alternative = 1),
    F(disc, UM_SCHEMA_MAP, .object = &um_model_disc_schema, .alternative = 1),
    F(cylinder, UM_SCHEMA_MAP, .object = &um_model_cylinder_schema, .alternative = 1),
    F(cone, UM_SCHEMA_MAP, .object = &um_model_cone_schema, .alternative = 1),
    F(sphere, UM_SCHEMA_MAP, .object = &um_model_sphere_schema, .alternative = 1),
    F(paraboloid, UM_SCHEMA_MAP, .object = &um_model_paraboloid_schema, .alternative = 1),
    F(mesh, UM_SCHEMA_MAP, .object = &um_model_mesh_schema, .alternative = 1),
    F(pose, UM_SCHEMA_MAP, .object = &um_model_pose_schema),
    F(joint, UM_SCHEMA_MAP, .object = &um_model_joint_schema),
    F(grain, UM_SCHEMA_VECTOR, DEFAULT(0.0), .length = 3,
      HELP("direction of brushing, rolling or tows, in the part, projected on each facet; lobes "
           "with "
           "alpha_across are wider across it; default x, where that stands upright y")),
    F(outside, UM_SCHEMA_TEXT, NAME, HELP("material of a closed part")),
    F(front, UM_SCHEMA_TEXT, NAME, HELP("material of the front of an open part")),
    F(back, UM_SCHEMA_TEXT, NAME, HELP("material of the back of an open part")),
    F(materials, UM_SCHEMA_DICT, MOST(10000), .behind = true, .object = &skin_object,
      HELP("material by group, before outside/front/back")),
    F(groups, UM_SCHEMA_DICT, MOST(10000), .behind = true, .object = &group_object,
      HELP("thermal properties by group, before the part's own")),
    F(shell, UM_SCHEMA_MAP, .object = &shell_object),
    F(mli, UM_SCHEMA_MAP, .object = &mli_object),
    F(creases, UM_SCHEMA_MAP, .object = &creases_object,
      HELP("of all its groups but those that are bare")),
    F(flatness, UM_SCHEMA_MAP, .object = &creases_object,
      HELP("of its groups that have neither MLI nor creases: panels, walls")),
    F(interior, UM_SCHEMA_MAP, .object = &interior_object),
    F(interiors, UM_SCHEMA_DICT, MOST(1000), .behind = true, .object = &interiors_object,
      HELP("several nodes inside the part by name, beside interior; places PART.NAME")),
    F(solid, UM_SCHEMA_MAP, .object = &solid_object),
    F(network, UM_SCHEMA_MAP, .object = &network_object),
    F(lumped, UM_SCHEMA_BOOL, DEFAULT(0), HELP("one isothermal node per group and side")),
    F(facet_size_m, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e4),
      HELP("longest facet edge; default thermal.facet_size_m")),
    F(start_temperature_K, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(5000),
      HELP("default thermal.start_temperature_K")),
    F(electrical_extraction, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1),
      HELP("share of direct sunlight on the front that leaves as electricity")),
    F(inside_emittance, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1),
      HELP("of the inner faces of a closed part, which then heat each other; a wall with "
           "through_conductance_W_m2_K then has an inner layer; what stands inside takes part by "
           "radiative contacts; 0: they do not radiate")),
};
#undef OF
SHARED_OBJECT(um_model_part_schema, struct um_scenario_part, "part", "One piece of the satellite.",
              FIELDS(part_fields), .exactly_one = one);

#define OF struct um_scenario_contact
static const struct um_schema_field contact_fields[] = {
    F(a, UM_SCHEMA_TEXT, NAME, REQUIRED,
      HELP("part, part.group, part.front, part.back, part.interior or part.NAME of interiors")),
    F(b, UM_SCHEMA_TEXT, NAME, REQUIRED, HELP("the other end")),
    F(conductance_W_K, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1e9),
      HELP("of the whole contact; or one that radiates:")),
    F(exchange_area_m2, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1e9),
      HELP("radiative conductance: sigma times it times T_a^4 - T_b^4 flows from a to b")),
    F(area_m2, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1e9),
      HELP("with exchange_factor: the same as their product")),
    F(exchange_factor, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1),
      HELP("of grey surfaces, 1 / (1/e_a + 1/e_b - 1) between plates close together")),
};
#undef OF
SHARED_OBJECT(um_model_contact_schema, struct um_scenario_contact, "contact",
              "Heat conducted or radiated between two places.", FIELDS(contact_fields));
