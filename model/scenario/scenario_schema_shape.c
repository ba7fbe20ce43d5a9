/* Keys of scenario.yaml: shapes of parts, where they stand and how they turn. */
#include "model/scenario/scenario_schema_group.h"

#define OF struct um_scenario_box
static const struct um_schema_field box_fields[] = {
    F(size_m, UM_SCHEMA_VECTOR, REQUIRED, .length = 3, POSITIVE(1e4), HELP("x, y, z")),
};
#undef OF
SHARED_OBJECT(um_model_box_schema, struct um_scenario_box, "box",
              "Closed; groups +x -x +y -y +z -z.", FIELDS(box_fields));
#define OF struct um_scenario_plate
static const struct um_schema_field plate_fields[] = {
    F(size_m, UM_SCHEMA_VECTOR, REQUIRED, .length = 2, POSITIVE(1e4),
      HELP("x, y; the front looks to +z")),
};
#undef OF
SHARED_OBJECT(um_model_plate_schema, struct um_scenario_plate, "plate",
              "Open, two sides; group plate.", FIELDS(plate_fields));
#define OF     struct um_scenario_round
#define RADIUS F(radius_m, UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e4), HELP("radius"))
#define HEIGHT F(height_m, UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e4), HELP("along z"))
static const struct um_schema_field radius_fields[] = {RADIUS};
static const struct um_schema_field cylinder_fields[] = {RADIUS, HEIGHT};
static const struct um_schema_field cone_fields[] = {
    RADIUS, HEIGHT,
    F(radius_top_m, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e4), HELP("at +z; 0 is a point"))};
static const struct um_schema_field paraboloid_fields[] = {
    RADIUS, F(focal_length_m, UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e5), HELP("z = r^2/(4 f)"))};
#undef OF
SHARED_OBJECT(um_model_disc_schema, struct um_scenario_round, "disc",
              "Open, front to +z; group disc.", FIELDS(radius_fields));
SHARED_OBJECT(um_model_sphere_schema, struct um_scenario_round, "sphere", "Closed; group sphere.",
              FIELDS(radius_fields));
SHARED_OBJECT(um_model_cylinder_schema, struct um_scenario_round, "cylinder",
              "Closed; groups side top bottom.", FIELDS(cylinder_fields));
SHARED_OBJECT(um_model_cone_schema, struct um_scenario_round, "cone",
              "Closed; groups side top bottom.", FIELDS(cone_fields));
SHARED_OBJECT(um_model_paraboloid_schema, struct um_scenario_round, "paraboloid",
              "Dish, open, concave front to +z; group dish.", FIELDS(paraboloid_fields));

#define OF struct um_scenario_mesh
static const struct um_schema_field mesh_fields[] = {
    F(file, UM_SCHEMA_TEXT, REQUIRED, NAMES_FILE, HELP("Wavefront OBJ; its groups are the groups")),
    F(scale, UM_SCHEMA_NUMBER, DEFAULT(1.0), POSITIVE(1e6),
      HELP("metres per unit of the file; 0.001: it is drawn in millimetres")),
    F(groups, UM_SCHEMA_TEXTS, MOST(2000), NAME,
      HELP("these groups of the file alone, so that one file serves several parts; default all")),
};
#undef OF
SHARED_OBJECT(um_model_mesh_schema, struct um_scenario_mesh, "mesh", "A mesh from a file.",
              FIELDS(mesh_fields), .scalar_key = "file");
#define OF struct um_scenario_pose
static const struct um_schema_field pose_fields[] = {
    F(position_m, UM_SCHEMA_VECTOR, DEFAULT(0.0), .length = 3,
      HELP("of the part's origin in its parent")),
    F(rotation_deg, UM_SCHEMA_VECTOR, DEFAULT(0.0), .length = 3,
      HELP("the part is turned about the parent's z, then its new y, then its new x: [x, y, z]")),
};
#undef OF
SHARED_OBJECT(um_model_pose_schema, struct um_scenario_pose, "pose",
              "Where a part sits in its parent.", FIELDS(pose_fields));
static const char *const track_choices[] = {"none", "sun", NULL};
#define OF struct um_scenario_joint
static const struct um_schema_field joint_fields[] = {
    F(axis, UM_SCHEMA_VECTOR, REQUIRED, .length = 3, HELP("in the part, through its origin")),
    F(angle_deg, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-360, 360),
      HELP("fixed turn, or added to what tracking or schedule say")),
    F(track, UM_SCHEMA_CHOICE, DEFAULT(0), .choices = track_choices, HELP("what to follow")),
    F(normal, UM_SCHEMA_VECTOR, DEFAULT(0.0), .length = 3,
      HELP("direction of the part turned toward what is tracked")),
    F(schedule, UM_SCHEMA_TEXT, NAMES_FILE,
      HELP("CSV time_utc,angle_deg: linear between rows, a jump where two rows have one time, the "
           "first and the last held outside; not when tracking")),
};
#undef OF
SHARED_OBJECT(um_model_joint_schema, struct um_scenario_joint, "joint", "One-axis joint.",
              FIELDS(joint_fields));
