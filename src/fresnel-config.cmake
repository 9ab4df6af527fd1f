# fresnel::fresnel, the headers; and fresnel::batch, the library behind fresnel.h, where it was built.
include(${CMAKE_CURRENT_LIST_DIR}/fresnel-targets.cmake)
if(EXISTS ${CMAKE_CURRENT_LIST_DIR}/fresnel-batch-targets.cmake)
    include(CMakeFindDependencyMacro)
    find_dependency(Threads)
    include(${CMAKE_CURRENT_LIST_DIR}/fresnel-batch-targets.cmake)
endif()
