# um_module(NAME thermal SOURCES a.c b.c DEPENDS um_core LIBRARIES foreign::lib)
# A folder is a module: a static library um_<name>. DEPENDS are modules and are visible to users;
# LIBRARIES are foreign and stay private.
function(um_module)
  cmake_parse_arguments(ARG "" "NAME" "SOURCES;DEPENDS;LIBRARIES" ${ARGN})
  add_library(um_${ARG_NAME} STATIC ${ARG_SOURCES})
  set_target_properties(um_${ARG_NAME} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_link_libraries(um_${ARG_NAME} PUBLIC um_options ${ARG_DEPENDS} PRIVATE ${ARG_LIBRARIES} m)
endfunction()

# um_test_run(NAME): how a test runs. tests/costs.txt has what a test takes alone [s], where that is 3 s
# or more: such tests start first, so that the last to end is a short one. A test may take ten times as
# long, fifty times under sanitizers, and a quarter of an hour at least: no test fails because a machine
# is busy. Threads that wait do not spin, since tests run beside each other.
file(STRINGS ${CMAKE_SOURCE_DIR}/tests/costs.txt um_test_costs REGEX "^[a-z]")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/costs.txt)
function(um_test_run name)
  set(cost 1)
  if("${um_test_costs}" MATCHES "(^|;)${name} +([0-9]+)")
    set(cost ${CMAKE_MATCH_2})
  endif()
  set(limit 10)
  if(UMBRA_SANITIZE OR UMBRA_TSAN OR UMBRA_COVERAGE)
    set(limit 50)
  endif()
  math(EXPR timeout "${limit} * ${cost}")
  if(timeout LESS 900)
    set(timeout 900)
  endif()
  set_tests_properties(${name} PROPERTIES COST ${cost} TIMEOUT ${timeout}
                       ENVIRONMENT "OMP_WAIT_POLICY=passive")
endfunction()

# um_test(NAME unit_core_csv SOURCES csv.c MODULES um_core LABELS unit [LIBRARIES ...])
# A CMocka program under CTest. A program in which a test called skip() ends with 77
# (tests/support/cmocka_all.h): CTest counts it as skipped, and tools/run-tests fails on it.
function(um_test)
  cmake_parse_arguments(ARG "" "NAME" "SOURCES;MODULES;LABELS;LIBRARIES" ${ARGN})
  add_executable(test_${ARG_NAME} ${ARG_SOURCES})
  target_link_libraries(test_${ARG_NAME} PRIVATE um_options um_test_support ${ARG_MODULES}
                        ${ARG_LIBRARIES} PkgConfig::CMOCKA m)
  target_compile_definitions(test_${ARG_NAME} PRIVATE UMBRA_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  add_test(NAME ${ARG_NAME} COMMAND test_${ARG_NAME})
  set_tests_properties(${ARG_NAME} PROPERTIES LABELS "${ARG_LABELS}" SKIP_RETURN_CODE 77)
  um_test_run(${ARG_NAME})
endfunction()

# um_test_own_effect(NAME): a test that loads the example of a user's own effect, PILEUP, which calls
# functions of the program.
function(um_test_own_effect name)
  target_compile_definitions(test_${name} PRIVATE PILEUP="$<TARGET_FILE:effect_object_pileup>")
  add_dependencies(test_${name} effect_object_pileup)
  set_target_properties(test_${name} PROPERTIES ENABLE_EXPORTS ON)
endfunction()
