# What every room, program and test is built with, in one place.
#
#   glint_room(NAME [SOURCES …] [DEPS room…] [LIBS target…])   a static library `glint_NAME` of src/NAME
#   glint_test(NAME SOURCES … [DEPS room…] [LIBS target…])     a GoogleTest program, one CTest entry a TEST,
#                                                              labelled NAME
#   glint_embed(OUT VARIABLE "TYPE NAME" HEADER file [ROOT folder] FILES file… [WITHOUT_DIRECTIVES name|name])
#                                                              sets OUT to a source with the text of files below
#                                                              ROOT, src unless it is given
#   glint_find_openexr()                                       imports OpenEXR::OpenEXR

# Of all this an installed glint passes only C++20 and its folder of headers on.
add_library(glint_flags INTERFACE)
target_compile_features(glint_flags INTERFACE cxx_std_20)
target_include_directories(glint_flags INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
# -ffp-contract=off: a fused multiply-add rounds once where the code says twice, so the picture would
# depend on the compiler and the triangle test would leak (docs/design.md, "One picture, one hash").
target_compile_options(glint_flags INTERFACE
    "$<BUILD_INTERFACE:-ffp-contract=off;-fno-fast-math;-Wall;-Wextra;-Wpedantic;-Wconversion;-Wshadow>")
# g++ 12 vectorises a double rounded to float and taken back to double as no change at all: other bits than
# clang's, and wrong ones.
target_compile_options(glint_flags INTERFACE
    $<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:GNU>:-fno-tree-vectorize>>)
# In a unity build g++ takes the sources for headers, where types in unnamed namespaces would be a fault.
target_compile_options(glint_flags INTERFACE
    "$<BUILD_INTERFACE:$<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wno-subobject-linkage>>")
target_include_directories(glint_flags INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>)
set(glint_definitions GLM_FORCE_PURE GLM_FORCE_XYZW_ONLY GLM_FORCE_SILENT_WARNINGS)
target_compile_definitions(glint_flags INTERFACE "$<BUILD_INTERFACE:${glint_definitions}>")
if(GLINT_SANITIZE)
    # Without recovery a finding ends the program, and so fails the test that made it.
    target_compile_options(glint_flags INTERFACE
        "$<BUILD_INTERFACE:-fsanitize=${GLINT_SANITIZE};-fno-sanitize-recover=all;-fno-omit-frame-pointer;-g1>")
    target_link_options(glint_flags INTERFACE $<BUILD_INTERFACE:-fsanitize=${GLINT_SANITIZE}>)
endif()
if(GLINT_WERROR)
    target_compile_options(glint_flags INTERFACE $<BUILD_INTERFACE:-Werror>)
endif()

function(glint_room name)
    cmake_parse_arguments(ROOM "" "" "SOURCES;DEPS;LIBS" ${ARGN})
    list(TRANSFORM ROOM_DEPS PREPEND glint_)
    if(ROOM_SOURCES)
        add_library(glint_${name} STATIC ${ROOM_SOURCES})
        # For shared libraries that contain glint, as plug-ins do: these export nothing of it.
        set_target_properties(glint_${name} PROPERTIES
            POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
        target_link_libraries(glint_${name} PUBLIC glint_flags ${ROOM_DEPS} PRIVATE ${ROOM_LIBS})
    else()
        add_library(glint_${name} INTERFACE)
        target_link_libraries(glint_${name} INTERFACE glint_flags ${ROOM_DEPS} ${ROOM_LIBS})
    endif()
    set_target_properties(glint_${name} PROPERTIES EXPORT_NAME ${name})
endfunction()

function(glint_test name)
    cmake_parse_arguments(TEST "" "" "SOURCES;DEPS;LIBS" ${ARGN})
    list(TRANSFORM TEST_DEPS PREPEND glint_)
    add_executable(${name} ${TEST_SOURCES})
    target_link_libraries(${name} PRIVATE glint_flags ${TEST_DEPS} ${TEST_LIBS} GTest::gtest_main)
    target_compile_definitions(${name} PRIVATE GLINT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    gtest_discover_tests(${name} NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600 LABELS ${name})
endfunction()

function(glint_embed out)
    cmake_parse_arguments(EMBED "" "VARIABLE;HEADER;ROOT;WITHOUT_DIRECTIVES" "FILES" ${ARGN})
    if(NOT EMBED_ROOT)
        set(EMBED_ROOT src)
    endif()
    set(root ${PROJECT_SOURCE_DIR}/${EMBED_ROOT})
    set(script ${PROJECT_SOURCE_DIR}/cmake/EmbedText.cmake)
    set(text ${CMAKE_CURRENT_BINARY_DIR}/${out}.cpp)
    list(TRANSFORM EMBED_FILES PREPEND ${root}/ OUTPUT_VARIABLE paths)
    add_custom_command(OUTPUT ${text}
        COMMAND ${CMAKE_COMMAND} -DOUTPUT=${text} -DROOT=${root} "-DFILES=${EMBED_FILES}"
            "-DVARIABLE=${EMBED_VARIABLE}" -DHEADER=${EMBED_HEADER} "-DWITHOUT=${EMBED_WITHOUT_DIRECTIVES}" -P ${script}
        DEPENDS ${script} ${paths} VERBATIM)
    set(${out} ${text} PARENT_SCOPE)
endfunction()

# Finds OpenEXR for the directory that asks. Debian's Imath remarks on Python parts that it does not bring; that is
# kept from the reader.
macro(glint_find_openexr)
    set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
    find_package(OpenEXR CONFIG REQUIRED)
    unset(CMAKE_MESSAGE_LOG_LEVEL)
endmacro()
