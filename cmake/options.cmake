# Language, warnings and optimisation, as one interface target that every part links.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release or Debug" FORCE)
endif()

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

add_library(plenum_options INTERFACE)
target_include_directories(plenum_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR})
target_compile_options(plenum_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow)
if(PLENUM_NATIVE)
  target_compile_options(plenum_options INTERFACE -march=native)
endif()

option(PLENUM_SANITIZE "address and undefined-behaviour sanitizers" OFF)
if(PLENUM_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()

# For sources with pair loops: as fast as -ffast-math, but NaN is still found.
set(PLENUM_PAIR_LOOP_FLAGS
  -fno-math-errno -fno-trapping-math -fno-signed-zeros -fassociative-math)
