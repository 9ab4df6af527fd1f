# cmake -DREFERENCE=PROGRAM "-DBITS=[EMULATOR;...]PROGRAM" -DSET=avx2 -P bits.cmake
# With an instruction set, bits prints what the reference, a program of this machine, prints with none.
set(ENV{FRESNEL_ISA} scalar)
execute_process(COMMAND ${REFERENCE} OUTPUT_VARIABLE expected ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)

set(ENV{FRESNEL_ISA} ${SET})
execute_process(COMMAND ${BITS} OUTPUT_VARIABLE actual ERROR_VARIABLE used RESULT_VARIABLE result)
if(result EQUAL 77)
    message(STATUS "skipped: this machine does not run ${SET}")
    return()
endif()
if(NOT result EQUAL 0 OR NOT used STREQUAL "${SET}\n")
    message(FATAL_ERROR "${SET}: exit code ${result}, stderr: ${used}")
endif()

string(REGEX MATCHALL "[^\n]+" expected "${expected}")
string(REGEX MATCHALL "[^\n]+" actual "${actual}")
if(NOT actual STREQUAL expected)
    list(REMOVE_ITEM actual ${expected})
    list(JOIN actual "\n  " different)
    message(FATAL_ERROR "${SET}: other bits than the reference has:\n  ${different}")
endif()
list(LENGTH actual models)
message(STATUS "${SET}: the same bits in ${models} models")
