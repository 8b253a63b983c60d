# Installs the build to a scratch prefix, builds the consumer project against it and runs it; then the same with the program.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/empty)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
# Every header that is installed can be included, and none of the private ones is there.
include(${CMAKE_CURRENT_LIST_DIR}/../../core/cmake/NadirPrivateHeaders.cmake)
file(GLOB_RECURSE headers RELATIVE ${WORK}/prefix/include/nadir ${WORK}/prefix/include/nadir/*.h)
list(SORT headers)
set(all_headers)
foreach(header IN LISTS headers)
  if(header IN_LIST NADIR_PRIVATE_HEADERS)
    message(FATAL_ERROR "${header}: is private, but was installed")
  endif()
  string(APPEND all_headers "#include \"${header}\"\n")
endforeach()
file(WRITE ${WORK}/all_headers.cpp "${all_headers}")
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_BUILD_TYPE=${BUILD_TYPE}
  -DADDITIONAL_SOURCE=${WORK}/all_headers.cpp)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/embedded_localiser)

# From an installed program in an empty folder: simulate, localise, evaluate, and the same JSON on one thread and on two.
# The program is moved first, so that neither the build nor the source tree can help it.
file(RENAME ${WORK}/prefix ${WORK}/moved)
set(nadir ${CMAKE_COMMAND} -E chdir ${WORK}/empty ${WORK}/moved/bin/nadir)
run(${nadir} simulate maps/proving-ground --level hard --seed 7 --frame-rate 1 --out F)
run(${nadir} localise F --map maps/proving-ground --out R.nadir --threads 2 --json)
run(${nadir} localise F --map maps/proving-ground --out R1.nadir --threads 1 --json)
run(${nadir} evaluate R.nadir --json --out R.json)
run(${nadir} evaluate R1.nadir --json --out R1.json)
run(${CMAKE_COMMAND} -E compare_files ${WORK}/empty/R.json ${WORK}/empty/R1.json)
file(REMOVE_RECURSE ${WORK})
