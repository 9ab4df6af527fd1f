# cmake -DNM=... -DOBJDUMP=... "-DOBJECTS=scalar=FILE|sse2=FILE|..." -P instruction_sets.cmake
# What the compiler made of the kernels: packed square roots as wide as the instruction set, the error of a product in one
# packed operation where the set has one, and nothing but kernels: a function beside them would take its batches through
# memory, and be one that two objects share, of which the linker would keep any one.
string(REPLACE "|" ";" objects "${OBJECTS}")

set(root_sse2 "[ \t]sqrtps[ \t]+[^\n]*%xmm")
set(root_avx2 "vsqrtps[ \t]+[^\n]*%ymm")
set(root_avx512 "vsqrtps[ \t]+[^\n]*%zmm")
set(root_neon "fsqrt[ \t]+v[0-9]+\\.4s")
set(root_simd128 "f32x4\\.sqrt")
set(fused_avx2 "vfn?m(add|sub)[0-9]+ps[ \t]+[^\n]*%ymm")
set(fused_avx512 "vfn?m(add|sub)[0-9]+ps[ \t]+[^\n]*%zmm")
set(fused_neon "fml[as][ \t]+v[0-9]+\\.4s")

foreach(object IN LISTS objects)
    string(REGEX MATCH "^([^=]+)=(.+)$" _ "${object}")
    set(name ${CMAKE_MATCH_1})
    set(file ${CMAKE_MATCH_2})

    foreach(operation root fused)
        if(NOT DEFINED ${operation}_${name})
            continue()
        endif()
        execute_process(COMMAND ${OBJDUMP} -d --no-show-raw-insn ${file} OUTPUT_VARIABLE code COMMAND_ERROR_IS_FATAL ANY)
        string(REGEX MATCHALL "${${operation}_${name}}" found "${code}")
        list(LENGTH found count)
        if(count LESS 10)
            message(FATAL_ERROR "${name}: ${count} packed ${operation} operations of its width; expected 10 or more")
        endif()
        message(STATUS "${name}: ${count} packed ${operation} operations")
    endforeach()

    execute_process(COMMAND ${NM} ${file} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCHALL " [Wi] [^\n]+" weak "${symbols}")
    if(weak)
        message(FATAL_ERROR "${name}: not inlined into the kernels: ${weak}")
    endif()
endforeach()
