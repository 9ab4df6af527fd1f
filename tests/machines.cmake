# cmake -DSOURCE=DIR -DTOOLCHAIN=FILE "-DNEEDS=PROGRAM;FILE;..." -DREFERENCE=BITS -DCTEST=... -DGENERATOR=... -DWORK=DIR
#       -P machines.cmake
# The batches built for another machine, and their tests run there: the bits are those of the reference, a program of
# this machine. Nothing is wrong where the compiler or the emulator for it is missing.
foreach(need IN LISTS NEEDS)
    if(NOT EXISTS ${need})
        find_program(found_${need} ${need})
    endif()
    if(NOT EXISTS ${need} AND NOT found_${need})
        message(STATUS "skipped: no ${need}; scripts/setup installs it")
        return()
    endif()
endforeach()

function(run)
    execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

unset(ENV{FRESNEL_ISA})
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK} -G ${GENERATOR} --toolchain ${TOOLCHAIN} -DCMAKE_BUILD_TYPE=Release
    -DFRESNEL_BUILD_APPS=OFF -DFRESNEL_BUILD_BATCH=ON -DFRESNEL_BITS=${REFERENCE})
run(${CMAKE_COMMAND} --build ${WORK} --parallel 2)
run(${CTEST} --test-dir ${WORK} --output-on-failure --no-tests=error)
