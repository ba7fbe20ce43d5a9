# um_module(NAME thermal SOURCES a.c b.c DEPENDS um_core LIBRARIES foreign::lib)
# A folder is a module: a static library um_<name>. DEPENDS are modules and are visible to users;
# LIBRARIES are foreign and stay private.
function(um_module)
  cmake_parse_arguments(ARG "" "NAME" "SOURCES;DEPENDS;LIBRARIES" ${ARGN})
  add_library(um_${ARG_NAME} STATIC ${ARG_SOURCES})
  set_target_properties(um_${ARG_NAME} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_link_libraries(um_${ARG_NAME} PUBLIC um_options ${ARG_DEPENDS} PRIVATE ${ARG_LIBRARIES} m)
endfunction()

# um_test(NAME unit_core_csv SOURCES csv.c MODULES um_core LABELS unit [TIMEOUT s] [LIBRARIES ...])
# A CMocka program under CTest. A program in which a test called skip() ends with 77
# (tests/support/cmocka_all.h): CTest counts it as skipped, and tools/run-tests fails on it.
function(um_test)
  cmake_parse_arguments(ARG "" "NAME;TIMEOUT" "SOURCES;MODULES;LABELS;LIBRARIES" ${ARGN})
  add_executable(test_${ARG_NAME} ${ARG_SOURCES})
  target_link_libraries(test_${ARG_NAME} PRIVATE um_options um_test_support ${ARG_MODULES}
                        ${ARG_LIBRARIES} PkgConfig::CMOCKA m)
  target_compile_definitions(test_${ARG_NAME} PRIVATE UMBRA_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  add_test(NAME ${ARG_NAME} COMMAND test_${ARG_NAME})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  set_tests_properties(${ARG_NAME} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT ${ARG_TIMEOUT}
                       SKIP_RETURN_CODE 77)
endfunction()
