# What find_package(glint) finds, in two parts that can be installed apart (cmake --install … --component trace):
#
#   trace   glint::trace, tracing alone: glint/trace.h, glint/kernels.h and the rooms below it
#   glint   glint::glint, all of the library
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/glint)

set_target_properties(glint_flags PROPERTIES EXPORT_NAME flags)
install(TARGETS glint_flags glint_math glint_parallel glint_geometry glint_bvh glint_trace
    EXPORT glint-trace ARCHIVE COMPONENT trace)
install(EXPORT glint-trace NAMESPACE glint:: DESTINATION ${package} COMPONENT trace)
install(FILES include/glint/kernels.h include/glint/trace.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/glint COMPONENT trace)

# GLM stands in the headers of scenes: with the same settings as here.
add_library(glint_glint INTERFACE)
target_link_libraries(glint_glint INTERFACE glint_render glint_formats glint_gpu $<INSTALL_INTERFACE:glm::glm>)
target_compile_definitions(glint_glint INTERFACE "$<INSTALL_INTERFACE:${glint_definitions}>")
set_target_properties(glint_glint PROPERTIES EXPORT_NAME glint)
install(TARGETS glint_glint glint_errors glint_imaging glint_shading glint_scene glint_render glint_formats glint_gpu
    EXPORT glint-glint ARCHIVE COMPONENT glint)
install(EXPORT glint-glint NAMESPACE glint:: DESTINATION ${package} COMPONENT glint)
install(DIRECTORY include/glint DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT glint PATTERN kernels.h EXCLUDE
    PATTERN trace.h EXCLUDE)

# The pages, in which links to sources become plain text.
file(GLOB pages RELATIVE ${PROJECT_SOURCE_DIR} docs/*.md)
foreach(page IN LISTS pages ITEMS README.md CHANGELOG.md)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${page})
    file(READ ${page} text)
    string(REGEX REPLACE "\\[([^]]*)\\]\\((\\.\\./)?(apps|bench|examples|include|scenes|src|tests|tools)(/[^)]*)?\\)" "\\1"
        text "${text}")
    file(WRITE ${PROJECT_BINARY_DIR}/pages/${page} "${text}")
endforeach()
install(DIRECTORY ${PROJECT_BINARY_DIR}/pages/ TYPE DOC)
install(DIRECTORY docs/images DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)
install(FILES LICENSE TYPE DOC)

configure_package_config_file(cmake/glint-config.cmake.in glint-config.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(glint-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/glint-config.cmake ${PROJECT_BINARY_DIR}/glint-config-version.cmake
    DESTINATION ${package} COMPONENT trace)
