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

file(REMOVE_RECURSE ${place})
run(${CMAKE_COMMAND} --install ${build} --prefix ${place}/installed --component trace)
if(part STREQUAL glint)
    run(${CMAKE_COMMAND} --install ${build} --prefix ${place}/installed --component glint)
endif()
if(sanitize)
    set(flags -fsanitize=${sanitize})
endif()
run(${CMAKE_COMMAND} -S ${program} -B ${place}/build -G ${generator} -DCMAKE_PREFIX_PATH=${place}/installed
    -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_CXX_COMPILER_LAUNCHER=${launcher} -DCMAKE_CXX_FLAGS=${flags})
run(${CMAKE_COMMAND} --build ${place}/build --target consumer)
run(${place}/build/consumer)
