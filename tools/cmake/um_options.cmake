# Language standard, warnings, sanitizers: one interface target that every module links.
set(CMAKE_C_STANDARD 17)
set(CMAKE_C_STANDARD_REQUIRED ON)
set(CMAKE_C_EXTENSIONS OFF)
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release or RelWithDebInfo" FORCE)
endif()

find_program(CCACHE ccache)
if(CCACHE)
  foreach(language C CXX)
    if(NOT CMAKE_${language}_COMPILER_LAUNCHER)
      set(CMAKE_${language}_COMPILER_LAUNCHER ${CCACHE})
    endif()
  endforeach()
endif()

add_library(um_options INTERFACE)
target_include_directories(um_options INTERFACE "${CMAKE_SOURCE_DIR}")
# POSIX.1-2008 for fork, mkstemp and clocks; no fused multiply-add, so that results do not depend on
# how the compiler contracts expressions.
target_compile_definitions(um_options INTERFACE _POSIX_C_SOURCE=200809L _XOPEN_SOURCE=700)
target_compile_options(um_options INTERFACE -ffp-contract=off -fno-math-errno)
target_compile_options(um_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow
  $<$<COMPILE_LANGUAGE:C>:-Wconversion>
  $<$<COMPILE_LANGUAGE:C>:-Wstrict-prototypes>)
if(UMBRA_WERROR)
  target_compile_options(um_options INTERFACE -Werror)
endif()
if((UMBRA_SANITIZE OR UMBRA_TSAN OR UMBRA_COVERAGE) AND NOT CMAKE_C_COMPILER_ID MATCHES "Clang")
  message(FATAL_ERROR "UMBRA_SANITIZE, UMBRA_TSAN and UMBRA_COVERAGE need clang: cmake --preset sanitize, tsan, coverage")
endif()
# One build serves the unit tests under the sanitizers and the fuzz targets. Undefined behaviour is
# fatal, and so are doubles that no integer can hold.
if(UMBRA_SANITIZE)
  target_compile_options(um_options INTERFACE -fsanitize=fuzzer-no-link,address,undefined
                         -fno-sanitize-recover=all -fno-omit-frame-pointer
                         -Wno-pass-failed) # an instrumented loop is not vectorized
  target_link_options(um_options INTERFACE -fsanitize=fuzzer-no-link,address,undefined)
endif()
if(UMBRA_TSAN)
  target_compile_options(um_options INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
  target_compile_definitions(um_options INTERFACE __SANITIZE_THREAD__=1) # gcc says so, clang does not
  target_link_options(um_options INTERFACE -fsanitize=thread)
endif()
if(UMBRA_COVERAGE)
  target_compile_options(um_options INTERFACE -fprofile-instr-generate -fcoverage-mapping)
  target_link_options(um_options INTERFACE -fprofile-instr-generate)
endif()
