/* Names that the writer and the reader of cubes share. */
#ifndef UMBRA_OUTPUT_CUBE_IMPL_H
#define UMBRA_OUTPUT_CUBE_IMPL_H

#define UM_CUBE_TITLE "Umbra factored picture 1"

#define UM_CUBE_WAVELENGTH   "wavelength"
#define UM_CUBE_WIDTH        "bin_width"
#define UM_CUBE_TRANSMISSION "transmission"
#define UM_CUBE_FROM         "line_from"
#define UM_CUBE_PIXELS       "line_pixels"
#define UM_CUBE_SHARES       "pixel_shares"
#define UM_CUBE_SPECTRUM     "share_spectrum"
#define UM_CUBE_SEEN         "share_seen"
#define UM_CUBE_LIT          "share_lit"
#define UM_CUBE_LINE_SHARES  "line_shares"
#define UM_CUBE_SURFACE      "surface"
#define UM_CUBE_DARK         "radiance_dark"
#define UM_CUBE_SUN          "radiance_sun"

#endif
