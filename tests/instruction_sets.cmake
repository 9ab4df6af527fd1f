# cmake -DNM=... -DOBJDUMP=... "-DOBJECTS=scalar=FILE|sse2=FILE|..." -P instruction_sets.cmake
# What the compiler made of the kernels: packed square roots as wide as the instruction set, and no function that two
# objects share, of which the linker would keep any one.
string(REPLACE "|" ";" objects "${OBJECTS}")

set(root_sse2 "[ \t]sqrtps [^\n]*%xmm")
set(root_avx2 "vsqrtps [^\n]*%ymm")
set(root_avx512 "vsqrtps [^\n]*%zmm")
set(root_neon "fsqrt[ \t]+v[0-9]+\\.4s")
set(root_simd128 "f32x4\\.sqrt")

foreach(object IN LISTS objects)
    string(REGEX MATCH "^([^=]+)=(.+)$" _ "${object}")
    set(name ${CMAKE_MATCH_1})
    set(file ${CMAKE_MATCH_2})

    if(DEFINED root_${name})
        execute_process(COMMAND ${OBJDUMP} -d --no-show-raw-insn ${file} OUTPUT_VARIABLE code COMMAND_ERROR_IS_FATAL ANY)
        string(REGEX MATCHALL "${root_${name}}" roots "${code}")
        list(LENGTH roots count)
        if(count LESS 10)
            message(FATAL_ERROR "${name}: ${count} packed square roots of its width; expected 10 or more")
        endif()
        message(STATUS "${name}: ${count} packed square roots")
    endif()

    execute_process(COMMAND ${NM} ${file} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCHALL " [Wi] [^\n]+" weak "${symbols}")
    foreach(symbol IN LISTS weak)
        if(NOT symbol MATCHES "isa_${name}")
            message(FATAL_ERROR "${name}: the function${symbol} does not carry the name of its instruction set")
        endif()
    endforeach()
endforeach()
