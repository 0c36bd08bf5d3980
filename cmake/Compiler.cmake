# One place for the language level, warnings and sanitizers of every target.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 99)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# moc reads headers only: it need not wait for the libraries below.
set(CMAKE_AUTOGEN_ORIGIN_DEPENDS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

add_library(hedr_options INTERFACE)
target_include_directories(hedr_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(hedr_options INTERFACE
    -Wall -Wextra -Wconversion -Wshadow -Wdouble-promotion
    # Who only wants to use the programs is not stopped by a warning, which at -O3 may be a false one
    # (gcc 12, PR 105651); the checks are.
    $<$<NOT:$<CONFIG:Release>>:-Werror>
    $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor -Woverloaded-virtual>
    # The same sums on every machine and in every build: no fused multiply-add behind our back.
    -ffp-contract=off)

if(HEDR_SANITIZE)
  target_compile_options(hedr_options INTERFACE
      -fsanitize=${HEDR_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
      # With these two gcc needs six times as long for what uses Eigen. A null pointer ends the program anyway, and
      # the fuzzers look for both in all that reads bytes.
      $<$<CXX_COMPILER_ID:GNU>:-fno-sanitize=null,alignment>
      # gcc says itself that this warning is wrong now and then in instrumented code.
      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(hedr_options INTERFACE -fsanitize=${HEDR_SANITIZE})
endif()

if(HEDR_BUILD_FUZZERS)
  target_compile_options(hedr_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

find_program(HEDR_CCACHE ccache)
if(HEDR_CCACHE)
  # Without this sloppiness ccache passes over everything that uses a precompiled header; with the
  # base directory one checkout takes what another has compiled.
  set(launcher ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros
      CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${HEDR_CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
  set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
endif()

# What makes compiling a target quick: headers of others (never our own, which change) are precompiled, those that all
# use and those named; and sources are united where that is wanted.
function(hedr_compile_quickly target)
  set(headers algorithm array cmath filesystem functional memory optional span string variant vector
      Eigen/Core tl/expected.hpp ${ARGN})
  list(TRANSFORM headers REPLACE "(.+)" "$<$<COMPILE_LANGUAGE:CXX>:<\\1$<ANGLE-R>>")
  target_precompile_headers(${target} PRIVATE ${headers})
  # ccache asks for it.
  target_compile_options(${target} PRIVATE
      $<$<AND:$<CXX_COMPILER_ID:GNU>,$<COMPILE_LANGUAGE:CXX>>:-fpch-preprocess>)
  hedr_unite(${target})
endfunction()
