# cmake -DFRESNEL=... -DBUILT=... -DCOMPILER=... -DC_COMPILER=... -DC_FLAGS=... -DGENERATOR=... -DWORK=... -P check.cmake
# Installs the headers into a fresh prefix under WORK, then configures, builds and runs the consumer in this
# folder against that prefix and against the source tree; then the same with all that BUILT installs, and from C.
cmake_minimum_required(VERSION 3.25)
set(generator -G "${GENERATOR}" -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_C_COMPILER=${C_COMPILER})

function(run)
    execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT status EQUAL 0)
        list(JOIN ARGV " " command)
        message(FATAL_ERROR "${command}\nfailed with ${status}:\n${output}")
    endif()
endfunction()

function(build_and_run name)
    run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK}/${name} ${generator} ${ARGN})
    run(${CMAKE_COMMAND} --build ${WORK}/${name})
    run(${WORK}/${name}/consumer)
endfunction()

# Headers fit every machine, a compiled library those with pointers of its size: here a machine with others asks.
function(expect_for_another_machine prefix expected)
    file(GLOB_RECURSE version ${prefix}/*/fresnel-config-version.cmake)
    set(CMAKE_SIZEOF_VOID_P 2)
    set(PACKAGE_FIND_VERSION_COUNT 0)
    include(${version})
    set(answer accepted)
    if(PACKAGE_VERSION_UNSUITABLE)
        set(answer refused)
    endif()
    if(NOT answer STREQUAL expected)
        message(FATAL_ERROR "${version}: another machine is ${answer}; expected ${expected}")
    endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} -S ${FRESNEL} -B ${WORK}/headers ${generator} -DFRESNEL_BUILD_APPS=OFF
    -DCMAKE_INSTALL_PREFIX=${WORK}/prefix -DCMAKE_INSTALL_INCLUDEDIR=include/elsewhere)
run(${CMAKE_COMMAND} --build ${WORK}/headers)
run(${CMAKE_COMMAND} --install ${WORK}/headers)
expect_for_another_machine(${WORK}/prefix accepted)
build_and_run(installed -DCMAKE_PREFIX_PATH=${WORK}/prefix)
build_and_run(in_tree -DFRESNEL_SOURCE=${FRESNEL})

run(${CMAKE_COMMAND} --install ${BUILT} --prefix ${WORK}/prefix_of_all)
expect_for_another_machine(${WORK}/prefix_of_all refused)
build_and_run(installed_all -DCMAKE_PREFIX_PATH=${WORK}/prefix_of_all
    "-DCMAKE_C_FLAGS=${C_FLAGS}" "-DCMAKE_CXX_FLAGS=${C_FLAGS}")
run(${WORK}/installed_all/c_consumer)
run(${WORK}/installed_all/c_consumer_of_shared)
