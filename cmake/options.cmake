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
  add_compile_definitions(PLENUM_GENERIC_LOOPS_ONLY)
endif()

# For sources with pair loops: as fast as -ffast-math, but NaN is still found.
set(PLENUM_PAIR_LOOP_FLAGS
  -fno-math-errno -fno-trapping-math -fno-signed-zeros -fassociative-math -ffp-contract=fast
  -fschedule-insns -fsched-pressure)
set(PLENUM_PAIR_LOOP_LEVEL -O3)
if(PLENUM_SANITIZE)
  list(REMOVE_ITEM PLENUM_PAIR_LOOP_FLAGS -fschedule-insns -fsched-pressure)
  set(PLENUM_PAIR_LOOP_LEVEL -O1)
endif()

# Instruction sets that loops are compiled for; the best is chosen when a program starts.
set(PLENUM_INSTRUCTION_SETS Baseline)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  list(APPEND PLENUM_INSTRUCTION_SETS Avx2 Avx512)
  add_compile_definitions(PLENUM_HAS_X86_LOOPS)
endif()
set(PLENUM_FLAGS_Avx2 -march=x86-64-v3)
set(PLENUM_FLAGS_Avx512 -march=x86-64-v4 -mprefer-vector-width=512)

# Compiles `source` into `target` once for each instruction set and each of the given definitions.
function(plenum_add_loops target source)
  foreach(set IN LISTS PLENUM_INSTRUCTION_SETS)
    foreach(definition IN LISTS ARGN)
      string(MAKE_C_IDENTIFIER "${target}_${source}_${set}_${definition}" name)
      add_library(${name} OBJECT ${source})
      target_link_libraries(${name} PRIVATE plenum_particles)
      target_compile_definitions(${name} PRIVATE PLENUM_ISA=${set} ${definition})
      target_compile_options(${name} PRIVATE ${PLENUM_PAIR_LOOP_LEVEL} ${PLENUM_PAIR_LOOP_FLAGS}
                             ${PLENUM_FLAGS_${set}})
      target_sources(${target} PRIVATE $<TARGET_OBJECTS:${name}>)
    endforeach()
  endforeach()
endfunction()
