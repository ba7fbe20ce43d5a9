# Every foreign library, each found once and named PkgConfig::X or as an imported target.
# tools/install-deps installs them on Debian and Ubuntu.
find_package(PkgConfig REQUIRED)
find_package(OpenMP REQUIRED COMPONENTS C)
find_package(Threads REQUIRED)
find_package(ZLIB REQUIRED)

# MPI is optional: studies on many machines. Its shared memory is not known to ThreadSanitizer. By
# C++ no source calls it; SUNDIALS 7 of Debian asks for the target.
if(UMBRA_MPI STREQUAL "ON")
  find_package(MPI REQUIRED COMPONENTS C CXX)
elseif(UMBRA_MPI STREQUAL "AUTO" AND NOT UMBRA_TSAN)
  find_package(MPI QUIET COMPONENTS C CXX)
endif()
if(TARGET MPI::MPI_C) # said here, because SUNDIALS may bring the target where MPI is OFF
  set(UMBRA_RANKS ON)
endif()

pkg_check_modules(ASSIMP REQUIRED IMPORTED_TARGET assimp)
pkg_check_modules(CFITSIO REQUIRED IMPORTED_TARGET cfitsio)
pkg_check_modules(EXPAT REQUIRED IMPORTED_TARGET expat)
pkg_check_modules(FYAML REQUIRED IMPORTED_TARGET libfyaml)
# the web server of umbra serve
pkg_check_modules(MICROHTTPD REQUIRED IMPORTED_TARGET libmicrohttpd)
pkg_check_modules(ERFA REQUIRED IMPORTED_TARGET erfa)
pkg_check_modules(GSL REQUIRED IMPORTED_TARGET gsl)
pkg_check_modules(NETCDF REQUIRED IMPORTED_TARGET netcdf)
pkg_check_modules(OPENEXR REQUIRED IMPORTED_TARGET OpenEXR)
pkg_check_modules(CMOCKA REQUIRED IMPORTED_TARGET cmocka)

list(APPEND CMAKE_MODULE_PATH /usr/share/cmake/geographiclib)
find_package(GeographicLib REQUIRED)

find_package(embree 3 QUIET)
if(NOT embree_FOUND)
  find_package(embree 4 REQUIRED)
endif()

find_package(SUNDIALS REQUIRED COMPONENTS cvodes kinsol nvecserial sunmatrixsparse)

# SuiteSparse 5 has no package file; 7 has one for each library, but these names do for both.
foreach(library klu cholmod)
  string(TOUPPER ${library} name)
  find_path(${name}_INCLUDE_DIR ${library}.h PATH_SUFFIXES suitesparse REQUIRED)
  find_library(${name}_LIBRARY NAMES ${library} REQUIRED)
  add_library(SuiteSparse::${library} INTERFACE IMPORTED)
  set_target_properties(SuiteSparse::${library} PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${${name}_INCLUDE_DIR}")
endforeach()
set_target_properties(SuiteSparse::klu PROPERTIES INTERFACE_LINK_LIBRARIES "${KLU_LIBRARY}")
# CHOLMOD is opened when a solid wants it, by the name that programs linked with it ask for.
get_filename_component(soname "${CHOLMOD_LIBRARY}" REALPATH)
execute_process(COMMAND ${CMAKE_READELF} -d "${CHOLMOD_LIBRARY}" OUTPUT_VARIABLE dynamic)
if(dynamic MATCHES "SONAME[^[]*\\[([^]]+)\\]")
  set(soname "${CMAKE_MATCH_1}")
endif()
set_target_properties(SuiteSparse::cholmod PROPERTIES INTERFACE_COMPILE_DEFINITIONS "UMBRA_CHOLMOD=\"${soname}\"")

if(UMBRA_TETGEN)
  find_path(TETGEN_INCLUDE_DIR tetgen.h REQUIRED)
  find_library(TETGEN_LIBRARY NAMES tet tetgen REQUIRED)
endif()
