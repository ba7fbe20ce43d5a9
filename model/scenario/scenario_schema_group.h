/* Words of which the schema table of a scenario is written, and its parts: one file to a subject.
 */
#ifndef UMBRA_MODEL_SCENARIO_SCHEMA_GROUP_H
#define UMBRA_MODEL_SCENARIO_SCHEMA_GROUP_H

#include "base/document/schema_words.h"
#include "model/scenario/scenario.h"
#include "orbit/time.h"

#define UTC .length = sizeof(double), .parse = um_orbit_time_parse_hook

extern const struct um_schema_object um_model_orbit_schema;
extern const struct um_schema_object um_model_attitude_schema;
extern const struct um_schema_object um_model_observer_schema;
extern const struct um_schema_object um_model_environment_schema;
extern const struct um_schema_object um_model_part_schema;
extern const struct um_schema_object um_model_contact_schema;
extern const struct um_schema_object um_model_box_schema;
extern const struct um_schema_object um_model_plate_schema;
extern const struct um_schema_object um_model_disc_schema;
extern const struct um_schema_object um_model_sphere_schema;
extern const struct um_schema_object um_model_cylinder_schema;
extern const struct um_schema_object um_model_cone_schema;
extern const struct um_schema_object um_model_paraboloid_schema;
extern const struct um_schema_object um_model_mesh_schema;
extern const struct um_schema_object um_model_pose_schema;
extern const struct um_schema_object um_model_joint_schema;
extern const struct um_schema_object um_model_measurements_schema;
extern const struct um_schema_object um_model_limit_schema;
extern const struct um_schema_object um_model_case_schema;
extern const struct um_schema_object um_model_band_schema;
extern const struct um_schema_object um_model_sensor_schema;
extern const struct um_schema_object um_model_preset_sensor_schema;
extern const struct um_schema_object um_model_preset_schema;

#endif
