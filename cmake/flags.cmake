# Flags of our own targets; nothing here reaches a user of maggi::maggi.
#
#   maggi_flags    language, warnings, sanitizers         library, command, tests
#   maggi_native   the processor of this machine          library

add_library(maggi_flags INTERFACE)
target_compile_features(maggi_flags INTERFACE c_std_17)
if(PROJECT_IS_TOP_LEVEL)
  target_compile_options(maggi_flags INTERFACE
    -Wall -Wextra -Wshadow -Wwrite-strings -Wundef
    $<$<COMPILE_LANGUAGE:C>:-Wstrict-prototypes>
    $<$<COMPILE_LANGUAGE:C>:-Wmissing-prototypes>)
endif()
if(MAGGI_WERROR)
  target_compile_options(maggi_flags INTERFACE -Werror)
endif()
if(MAGGI_SANITIZE)
  target_compile_options(maggi_flags INTERFACE
    -fsanitize=${MAGGI_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -O1 -g)
  target_link_options(maggi_flags INTERFACE -fsanitize=${MAGGI_SANITIZE})
endif()

add_library(maggi_native INTERFACE)
if(MAGGI_NATIVE)
  include(CheckCCompilerFlag)
  check_c_compiler_flag(-march=native MAGGI_HAVE_MARCH_NATIVE)
  if(MAGGI_HAVE_MARCH_NATIVE)
    target_compile_options(maggi_native INTERFACE $<$<COMPILE_LANGUAGE:C>:-march=native>)
  endif()
endif()
