# cmake -DFRESNEL=... -DBUILT=... -DCOMPILER=... -DC_COMPILER=... -DC_FLAGS=... -DGENERATOR=... -DWORK=... -P check.cmake
# Installs the headers into a fresh prefix under WORK, then configures, builds and runs the consumer in this
# folder against that prefix and against the source tree; then the same with all that BUILT installs, and from C.
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

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} -S ${FRESNEL} -B ${WORK}/headers ${generator} -DFRESNEL_BUILD_APPS=OFF
    -DCMAKE_INSTALL_PREFIX=${WORK}/prefix)
run(${CMAKE_COMMAND} --build ${WORK}/headers)
run(${CMAKE_COMMAND} --install ${WORK}/headers)
build_and_run(installed -DCMAKE_PREFIX_PATH=${WORK}/prefix)
build_and_run(in_tree -DFRESNEL_SOURCE=${FRESNEL})

run(${CMAKE_COMMAND} --install ${BUILT} --prefix ${WORK}/prefix_of_all)
build_and_run(installed_all -DCMAKE_PREFIX_PATH=${WORK}/prefix_of_all
    "-DCMAKE_C_FLAGS=${C_FLAGS}" "-DCMAKE_CXX_FLAGS=${C_FLAGS}")
run(${WORK}/installed_all/c_consumer)
run(${WORK}/installed_all/c_consumer_of_shared)
