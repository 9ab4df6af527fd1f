# cmake -DNM=... "-DOBJECTS=FILE;FILE;..." -P core_calls.cmake
# The C functions allocate nothing, throw nothing and need no runtime library of C++: beside each other, the kernels
# and what a sanitizer or a linker adds, they call only the functions of C listed here.
set(allowed "getenv|strlen|bcmp|_*mem(cmp|cpy|move|set)(_chk)?|__cpu_model|__cpu_indicator_init|__stack_chk_fail")
set(ours "_ZN7fresnel[A-Za-z0-9_]+|_ZNK7fresnel[A-Za-z0-9_]+")
set(tools "__[atu]*san_[a-z0-9_]+|_GLOBAL_OFFSET_TABLE_|__(stack_pointer|indirect_function_table)")

foreach(object IN LISTS OBJECTS)
    execute_process(COMMAND ${NM} -u ${object} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCHALL "[Uw] [^\n]+" symbols "${symbols}")
    foreach(symbol IN LISTS symbols)
        if(NOT symbol MATCHES "^. (${allowed}|${ours}|${tools})$")
            message(FATAL_ERROR "${object} calls ${symbol}")
        endif()
    endforeach()
endforeach()
