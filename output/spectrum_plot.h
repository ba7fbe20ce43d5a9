/* Spectra of material records as people look at them. */
#ifndef UMBRA_OUTPUT_SPECTRUM_PLOT_H
#define UMBRA_OUTPUT_SPECTRUM_PLOT_H

#include "base/core/file.h"
#include "materials/materials.h"

/* NAME.csv of each record, its reflectance at normal incidence and of light from all sides from
 * 0.25 to 25 um, and with `pictures` NAME.png, .svg and .pdf of it, shaded where the record claims
 * no measurement. UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_output_spectra(struct um_context *context,
                                 const struct um_materials_record *const *record, size_t count,
                                 bool pictures, struct um_core_folder *folder);

#endif
