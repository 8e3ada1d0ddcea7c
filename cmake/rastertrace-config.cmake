# find_package(rastertrace) gives the libraries rastertrace::core and rastertrace::trace.
include(CMakeFindDependencyMacro)
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
find_dependency(glm CONFIG)
find_dependency(GMP)
find_dependency(Unistring)
find_dependency(fmt CONFIG)
list(POP_BACK CMAKE_MODULE_PATH)
include(${CMAKE_CURRENT_LIST_DIR}/rastertrace-targets.cmake)
