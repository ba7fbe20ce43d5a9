# What `cmake --install` puts in place, beside the headers (effects/), the material records
# (materials/) and the library (library/): the program, scenarios, documents, man pages, completions. The tree may be moved: the
# program finds its files from its own folder (base/core/data.h).
include(GNUInstallDirs)

install(TARGETS umbra RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(DIRECTORY scenarios/ COMPONENT runtime DESTINATION "${CMAKE_INSTALL_DATADIR}/umbra/scenarios"
  PATTERN "__pycache__" EXCLUDE)
install(FILES README.md CHANGELOG.md CITATION.cff LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(DIRECTORY docs examples DESTINATION "${CMAKE_INSTALL_DOCDIR}")

# Completions and man pages are written by the program that was built.
set(umbra_env ${CMAKE_COMMAND} -E env ASAN_OPTIONS=detect_leaks=0) # in a build with sanitizers
set(umbra_pages ${CMAKE_BINARY_DIR}/pages)
set(umbra_completions ${umbra_pages}/umbra.bash ${umbra_pages}/_umbra)
add_custom_command(OUTPUT ${umbra_completions} DEPENDS umbra
  COMMAND ${CMAKE_COMMAND} -E make_directory ${umbra_pages}
  COMMAND ${umbra_env} $<TARGET_FILE:umbra> completion bash > ${umbra_pages}/umbra.bash
  COMMAND ${umbra_env} $<TARGET_FILE:umbra> completion zsh > ${umbra_pages}/_umbra
  COMMENT "Completions for bash and zsh" VERBATIM)
set(umbra_man ${umbra_pages}/man1/umbra.1) # and a page of each verb beside it
add_custom_command(OUTPUT ${umbra_man} DEPENDS umbra ${CMAKE_SOURCE_DIR}/tools/write-manual
  COMMAND ${umbra_env} sh ${CMAKE_SOURCE_DIR}/tools/write-manual $<TARGET_FILE:umbra> ${umbra_pages}/man1
  COMMENT "Man pages" VERBATIM)
install(DIRECTORY ${umbra_pages}/man1 DESTINATION "${CMAKE_INSTALL_MANDIR}")
add_custom_target(umbra_pages ALL DEPENDS ${umbra_completions} ${umbra_man})
add_custom_target(program DEPENDS umbra umbra_pages umbra_shared umbra_static) # all that is installed
install(FILES ${umbra_pages}/umbra.bash RENAME umbra
  DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions")
install(FILES ${umbra_pages}/_umbra DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/site-functions")
