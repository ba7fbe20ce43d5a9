/* Published models, data and libraries that a run may rest on, and whether it does. */
#include "library/sources_impl.h"

static bool always(const struct um_model *model)
{
  (void)model;
  return true;
}

static bool has_elements(const struct um_model *model)
{
  const struct um_scenario_orbit *orbit = model->scenario->orbit;
  return orbit->tle != NULL || orbit->tle_file != NULL || orbit->elements != NULL;
}

static bool has_station(const struct um_model *model)
{
  return model->has_observer && model->observer.kind == UM_OBSERVER_STATION;
}

static bool has_light(const struct um_model *model) { return model->has_observer; }

static bool has_table_of_sun(const struct um_model *model)
{
  return model->environment.spectrum == UM_SPECTRUM_E490;
}

static bool follows_heat(const struct um_model *model) { return !model->points; }

/* Parts that are filled with tetrahedra. */
static bool has_solid(const struct um_model *model)
{
  const struct um_scenario_part *part = model->scenario->parts.items;
  for (size_t p = 0; p < model->scenario->parts.count; p++) {
    const struct um_scenario_interior *several = part[p].interiors.items;
    if (part[p].solid != NULL) return true;
    if (part[p].interior != NULL && part[p].interior->conductivity_W_m_K > 0.0) return true;
    for (size_t i = 0; i < part[p].interiors.count; i++)
      if (several[i].conductivity_W_m_K > 0.0) return true;
  }
  return false;
}

static const struct um_library_citation sources[] = {
    {"SGP4 (Vallado et al. 2006)",
     "@inproceedings{vallado2006,\n  author = {Vallado, D. A. and Crawford, P. and Hujsak, R. and "
     "Kelso, T. S.},\n  title = {Revisiting Spacetrack Report \\#3},\n  booktitle = {AIAA/AAS "
     "Astrodynamics Specialist Conference},\n  note = {AIAA 2006-6753},\n  year = {2006}\n}\n",
     has_elements},
    {"the time scales, frames and ephemerides of ERFA after SOFA (IAU SOFA Board)",
     "@software{erfa,\n  title = {ERFA, Essential Routines for Fundamental Astronomy, derived from "
     "the IAU's SOFA},\n  author = {{NumFOCUS Foundation} and {IAU SOFA Board}},\n  url = "
     "{https://github.com/liberfa/erfa}\n}\n",
     always},
    {"the ellipsoid of GeographicLib (Karney)",
     "@software{geographiclib,\n  title = {GeographicLib},\n  author = {Karney, C. F. F.},\n  url "
     "= "
     "{https://geographiclib.sourceforge.io}\n}\n",
     has_station},
    {"the solar spectrum of ASTM E490",
     "@techreport{astm_e490,\n  title = {E490-00a, Standard Solar Constant and Zero Air Mass Solar "
     "Spectral Irradiance Tables},\n  institution = {ASTM International},\n  year = {2000}\n}\n",
     has_table_of_sun},
    {"the rays of Embree (Wald et al. 2014)",
     "@article{wald2014,\n  author = {Wald, I. and Woop, S. and Benthin, C. and Johnson, G. S. and "
     "Ernst, M.},\n  title = {Embree: A Kernel Framework for Efficient CPU Ray Tracing},\n  "
     "journal "
     "= {ACM Transactions on Graphics},\n  volume = {33},\n  number = {4},\n  pages = {143},\n  "
     "year = {2014}\n}\n",
     always},
    {"light after Cook and Torrance (1982)",
     "@article{cook1982,\n  author = {Cook, R. L. and Torrance, K. E.},\n  title = {A Reflectance "
     "Model for Computer Graphics},\n  journal = {ACM Transactions on Graphics},\n  volume = "
     "{1},\n  number = {1},\n  pages = {7--24},\n  year = {1982}\n}\n",
     has_light},
    {"the integrator of SUNDIALS (Hindmarsh et al. 2005)",
     "@article{hindmarsh2005,\n  author = {Hindmarsh, A. C. and Brown, P. N. and Grant, K. E. and "
     "Lee, S. L. and Serban, R. and Shumaker, D. E. and Woodward, C. S.},\n  title = {SUNDIALS: "
     "Suite of Nonlinear and Differential/Algebraic Equation Solvers},\n  journal = {ACM "
     "Transactions on Mathematical Software},\n  volume = {31},\n  number = {3},\n  pages = "
     "{363--396},\n  year = {2005}\n}\n",
     follows_heat},
    {"the sparse equations of KLU (Davis and Palamadai Natarajan 2010)",
     "@article{davis2010,\n  author = {Davis, T. A. and Palamadai Natarajan, E.},\n  title = "
     "{Algorithm 907: KLU, A Direct Sparse Solver for Circuit Simulation Problems},\n  journal = "
     "{ACM Transactions on Mathematical Software},\n  volume = {37},\n  number = {3},\n  pages = "
     "{36},\n  year = {2010}\n}\n",
     follows_heat},
    {"the tetrahedra of TetGen (Si 2015)",
     "@article{si2015,\n  author = {Si, H.},\n  title = {TetGen, a Delaunay-Based Quality "
     "Tetrahedral Mesh Generator},\n  journal = {ACM Transactions on Mathematical Software},\n  "
     "volume = {41},\n  number = {2},\n  pages = {11},\n  year = {2015}\n}\n",
     has_solid},
};

const struct um_library_citation *um_library_source_at(size_t index)
{
  return index < sizeof sources / sizeof *sources ? &sources[index] : NULL;
}
