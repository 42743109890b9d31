# Runs a program: it must return 0 and print what is expected.
#
# cmake -D PROGRAM=... -D PRINTS=regex [-D ARGUMENTS=list] -P check.cmake
execute_process(COMMAND "${PROGRAM}" ${ARGUMENTS}
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
message("${output}")
if(NOT result EQUAL 0)
  message(FATAL_ERROR "it returned ${result}")
endif()
if(NOT output MATCHES "${PRINTS}")
  message(FATAL_ERROR "it did not print '${PRINTS}'")
endif()
