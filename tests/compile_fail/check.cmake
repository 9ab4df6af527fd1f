# cmake -DCOMPILER=... -DINCLUDE=... -DSOURCE=... -P check.cmake
# The source's first line says what the compiler has to do: "// accepted", or "// refused: " and a regular
# expression that its message must match.
file(STRINGS ${SOURCE} first LIMIT_COUNT 1)
execute_process(
    COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C ${COMPILER} -std=c++20 -fsyntax-only -I${INCLUDE} ${SOURCE}
    RESULT_VARIABLE status ERROR_VARIABLE message)
if(first STREQUAL "// accepted")
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "${SOURCE} should compile:\n${message}")
    endif()
    return()
endif()

if(NOT first MATCHES "^// refused: (.+)$")
    message(FATAL_ERROR "${SOURCE} begins with neither '// accepted' nor '// refused: '")
endif()
set(expected "${CMAKE_MATCH_1}")
if(status EQUAL 0)
    message(FATAL_ERROR "${SOURCE} should be refused, but compiles")
endif()
if(NOT message MATCHES "${expected}")
    message(FATAL_ERROR "${SOURCE} is refused for another reason than '${expected}':\n${message}")
endif()
