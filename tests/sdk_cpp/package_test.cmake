# Installs the SDK, and builds and tests a qiBuild project with what was installed:
#   cmake -DBUILD=... -DSOURCE=... -DWORK=... -P package_test.cmake
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE told ERROR_VARIABLE told)
  if(failed)
    message(FATAL_ERROR "${ARGN}\n${told}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --component sdk --prefix ${WORK}/prefix)
foreach(remote ON OFF)
  run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/${remote} -DCMAKE_PREFIX_PATH=${WORK}/prefix
      -DMODULE_IS_REMOTE=${remote})
  run(${CMAKE_COMMAND} --build ${WORK}/${remote})
endforeach()
run(${CMAKE_CTEST_COMMAND} --test-dir ${WORK}/ON --output-on-failure --no-tests=error)
foreach(file ON/sdk/bin/oldmodule OFF/sdk/lib/naoqi/liboldmodule.so)
  if(NOT EXISTS ${WORK}/${file})
    message(FATAL_ERROR "${file} was not built")
  endif()
endforeach()
