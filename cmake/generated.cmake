# The derivatives of the kernel: the committed ad_generated/, or with Tapenade a folder of the build.
#
#   MAGGI_GENERATED            the folder
#   MAGGI_GENERATED_SOURCES    what of it the library compiles
#   maggi_ad                   include folders and MAGGI_NDIR for who calls derivatives
#   maggi_generated_fresh      stops the build when the kernel changed since they were generated
#   regenerate                 writes them anew

set(MAGGI_DIRECTIONS 8 CACHE STRING "directions that the vector tangents carry at once")
set(MAGGI_AD_ENGINE built-in CACHE STRING "who wrote the derivatives: built-in or tapenade")
set_property(CACHE MAGGI_AD_ENGINE PROPERTY STRINGS built-in tapenade)
set(generate ${PROJECT_SOURCE_DIR}/tools/tapenade/generate)

if(NOT MAGGI_DIRECTIONS MATCHES "^(8|16|24|32|40|48|56|64)$")
  message(FATAL_ERROR "MAGGI_DIRECTIONS=${MAGGI_DIRECTIONS} is not a multiple of 8 from 8 to 64")
endif()

if(MAGGI_AD_ENGINE STREQUAL built-in)
  set(MAGGI_GENERATED ${PROJECT_SOURCE_DIR}/ad_generated)
  set(regenerate ${CMAKE_COMMAND} -E env CC=${CMAKE_C_COMPILER} ${generate})
  set(command_to_type "tools/tapenade/generate")
elseif(MAGGI_AD_ENGINE STREQUAL tapenade)
  find_program(TAPENADE tapenade DOC "the program tapenade, 3.16")
  if(NOT EXISTS "${TAPENADE}")
    message(FATAL_ERROR "MAGGI_AD_ENGINE=tapenade needs -DTAPENADE=/path/to/bin/tapenade")
  endif()
  set(MAGGI_GENERATED ${PROJECT_BINARY_DIR}/ad_generated)
  set(regenerate ${CMAKE_COMMAND} -E env CC=${CMAKE_C_COMPILER}
    ${generate} --engine tapenade --tapenade ${TAPENADE} --output ${MAGGI_GENERATED})
  set(command_to_type "cmake ${PROJECT_BINARY_DIR}")
else()
  message(FATAL_ERROR "MAGGI_AD_ENGINE=${MAGGI_AD_ENGINE} is neither built-in nor tapenade")
endif()

set(check_generated ${CMAKE_COMMAND}
  -D SOURCE=${PROJECT_SOURCE_DIR} -D FOLDER=${MAGGI_GENERATED} -D TYPE=${command_to_type}
  -P ${PROJECT_SOURCE_DIR}/cmake/check_generated.cmake)

# Tapenade runs at configuration, again when something that it read has changed
if(MAGGI_AD_ENGINE STREQUAL tapenade)
  execute_process(COMMAND ${check_generated} RESULT_VARIABLE stale OUTPUT_QUIET ERROR_QUIET)
  if(stale)
    message(STATUS "Tapenade writes ${MAGGI_GENERATED}")
    execute_process(COMMAND ${regenerate} RESULT_VARIABLE failed)
    if(failed)
      message(FATAL_ERROR "tools/tapenade/generate: see its message above")
    endif()
  endif()
  file(STRINGS ${MAGGI_GENERATED}/MANIFEST inputs REGEX "^read ")
  list(TRANSFORM inputs REPLACE "^read +[0-9a-f]+ +" "${PROJECT_SOURCE_DIR}/")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${inputs})
endif()

if(NOT EXISTS ${MAGGI_GENERATED}/MANIFEST)
  message(FATAL_ERROR "${MAGGI_GENERATED}/MANIFEST is missing: type ${command_to_type}")
endif()

# heads.c is a table for tests
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${MAGGI_GENERATED}/MANIFEST)
file(STRINGS ${MAGGI_GENERATED}/MANIFEST MAGGI_GENERATED_SOURCES REGEX "^written .*\\.c$")
list(TRANSFORM MAGGI_GENERATED_SOURCES REPLACE "^written +[0-9a-f]+ +" "${MAGGI_GENERATED}/")
list(REMOVE_ITEM MAGGI_GENERATED_SOURCES ${MAGGI_GENERATED}/heads.c)
list(APPEND MAGGI_GENERATED_SOURCES ${PROJECT_SOURCE_DIR}/tools/tapenade/runtime/adStack.c)

add_library(maggi_ad INTERFACE)
target_include_directories(maggi_ad INTERFACE
  ${MAGGI_GENERATED} ${PROJECT_SOURCE_DIR}/tools/tapenade/runtime)
target_compile_definitions(maggi_ad INTERFACE MAGGI_NDIR=${MAGGI_DIRECTIONS})

add_custom_target(maggi_generated_fresh COMMAND ${check_generated} VERBATIM)
if(PROJECT_IS_TOP_LEVEL)
  add_custom_target(regenerate COMMAND ${regenerate} USES_TERMINAL VERBATIM)
endif()
