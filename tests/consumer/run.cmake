# cmake -D … -P run.cmake: installs a part of glint, builds a program with it in a folder of its own, and runs it.
#
#   part       trace: the example with tracing alone; glint: a program that uses all of the library
#   build      the build folder of glint
#   program    the program's sources
#   place      where to work
#   generator, compiler, launcher, sanitize: as glint was built
function(run)
    execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Every link of an installed page leads to something that is installed.
function(check_links folder)
    file(GLOB_RECURSE pages ${folder}/*.md)
    if(NOT pages)
        message(FATAL_ERROR "no pages in ${folder}")
    endif()
    foreach(page IN LISTS pages)
        cmake_path(GET page PARENT_PATH from)
        file(READ ${page} text)
        # Brackets would join the elements of a list.
        string(REPLACE "](" "@(" text "${text}")
        string(REGEX MATCHALL "@\\([^):#]+[)#]" links "${text}")
        foreach(link IN LISTS links)
            string(REGEX REPLACE "..(.*)." "\\1" target "${link}")
            if(NOT EXISTS ${from}/${target})
                message(FATAL_ERROR "${page} links to ${target}, which is not installed")
            endif()
        endforeach()
    endforeach()
endfunction()

# A shared library that contains glint exports none of what only its rooms declare.
function(check_exports library)
    execute_process(COMMAND nm --dynamic --defined-only --demangle ${library} OUTPUT_VARIABLE symbols
        COMMAND_ERROR_IS_FATAL ANY)
    if(NOT symbols MATCHES "use_glint")
        message(FATAL_ERROR "${library} exports nothing")
    endif()
    if(symbols MATCHES "[^\n]* glint::(math|parallel|geometry|bvh|imaging|trace|shading|scene|rendering|formats|gpu)::[^\n]*")
        message(FATAL_ERROR "${library} exports ${CMAKE_MATCH_0}")
    endif()
endfunction()

file(REMOVE_RECURSE ${place})
if(part STREQUAL glint)
    run(${CMAKE_COMMAND} --install ${build} --prefix ${place}/installed)
    check_links(${place}/installed/share/doc/glint)
else()
    run(${CMAKE_COMMAND} --install ${build} --prefix ${place}/installed --component trace)
endif()
if(sanitize)
    set(flags -fsanitize=${sanitize})
endif()
run(${CMAKE_COMMAND} -S ${program} -B ${place}/build -G ${generator} -DCMAKE_PREFIX_PATH=${place}/installed
    -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_CXX_COMPILER_LAUNCHER=${launcher} -DCMAKE_CXX_FLAGS=${flags})
run(${CMAKE_COMMAND} --build ${place}/build --target consumer)
run(${place}/build/consumer)
if(part STREQUAL glint)
    check_exports(${place}/build/libplugin.so)
endif()
