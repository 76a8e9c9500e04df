# usarnaoqi_add_test(NAME <test> COMMAND <program> [<argument>...]
#                    [ROBOT <model>] [WORLD <file>] [SEED <number>])
# A test of CTest that runs a client with a simulated robot of its own, in simulated time: the test
# passes if the program ends with exit code 0. The client finds the robot whatever address it names.
#
# usarnaoqi_add_scenarios(<folder> [SEEDS <number>])
# A test of CTest that runs a folder of scenarios, at most so many seeds of each.
#
# Both start the program USARNAOQI_PROGRAM, by default the one in the PATH.
find_program(USARNAOQI_PROGRAM usarnaoqi)

function(usarnaoqi_add_test)
  cmake_parse_arguments(ARG "" "NAME;ROBOT;WORLD;SEED" "COMMAND" ${ARGN})
  if(NOT ARG_NAME OR NOT ARG_COMMAND)
    message(FATAL_ERROR "usarnaoqi_add_test: expected NAME and COMMAND")
  endif()
  set(options)
  foreach(option ROBOT WORLD SEED)
    string(TOLOWER ${option} word)
    if(DEFINED ARG_${option})
      list(APPEND options --${word} ${ARG_${option}})
    endif()
  endforeach()
  add_test(NAME ${ARG_NAME} COMMAND ${USARNAOQI_PROGRAM} run ${options} -- ${ARG_COMMAND})
endfunction()

function(usarnaoqi_add_scenarios folder)
  cmake_parse_arguments(ARG "" "SEEDS" "" ${ARGN})
  get_filename_component(name ${folder} NAME)
  set(options)
  if(DEFINED ARG_SEEDS)
    set(options --seeds ${ARG_SEEDS})
  endif()
  add_test(NAME ${name} COMMAND ${USARNAOQI_PROGRAM} ci ${folder} ${options})
endfunction()
