/* Private to output/: plots.py as it stands, made by CMake. */
#ifndef UMBRA_OUTPUT_PLOTS_IMPL_H
#define UMBRA_OUTPUT_PLOTS_IMPL_H

extern const char um_output_plots_py[];

#endif
