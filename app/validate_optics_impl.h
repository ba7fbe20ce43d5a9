/* Groups of optical cases, one per file. */
#ifndef UMBRA_APP_VALIDATE_OPTICS_IMPL_H
#define UMBRA_APP_VALIDATE_OPTICS_IMPL_H

#include "app/validate.h"

enum um_status um_app_validate_radiometry(struct um_context *context, struct um_app_report *report);
enum um_status um_app_validate_surfaces(struct um_context *context, struct um_app_report *report);
enum um_status um_app_validate_bodies(struct um_context *context, struct um_app_report *report);

#endif
