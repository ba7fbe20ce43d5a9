# find_package(umbra): the target umbra::umbra, the shared library and its header.
include("${CMAKE_CURRENT_LIST_DIR}/umbra-targets.cmake")
