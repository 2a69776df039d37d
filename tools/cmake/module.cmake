# luminist_module(NAME DEPS other modules... [LIBS public libraries...] [PRIVATE_LIBS libraries...] [TEST_SHARDS n]
#                 [SANITIZE_O0])
#
# The only declaration of a module. It builds src/NAME/*.cpp into the library lum_NAME, builds tests/NAME/*_test.cpp
# into the executable NAME_test and registers it with ctest, in n parts that run side by side: NAME, NAME.2, ...
# SANITIZE_O0: no sanitized test waits for its loops, so that it is compiled without optimization there, in half the time.
# tools/check_layers.py reads the DEPS of the same line.
function(luminist_options target)
  target_include_directories(${target} PUBLIC ${CMAKE_SOURCE_DIR}/src)
  target_compile_definitions(${target} PUBLIC GLM_FORCE_EXPLICIT_CTOR GLM_FORCE_DEPTH_ZERO_TO_ONE)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wnon-virtual-dtor)
  if(LUMINIST_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(LUMINIST_SANITIZE)
    # g++ 12 sees uninitialized values inside std::regex once the sanitizers instrument it.
    target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=address,undefined)
  endif()
endfunction()

# For a target in tests/: what they compute with is in the modules, so they are compiled fast rather than to be fast.
function(luminist_test_options target)
  luminist_options(${target})
  target_compile_options(${target} PRIVATE -O0)
endfunction()

# For a test that renders with tests/solve/fake_renderer.cpp, which computes: compiled to be fast, too.
function(luminist_fake_renderer target)
  target_sources(${target} PRIVATE ${CMAKE_SOURCE_DIR}/tests/solve/fake_renderer.cpp)
  target_compile_options(${target} PRIVATE -O1)
endfunction()

# luminist_tests(NAME MODULE [n]): tests/NAME/*_test.cpp, of the library lum_MODULE, as the executable NAME_test, in n
# parts.
function(luminist_tests name module)
  set(shards ${ARGN})
  if(NOT shards)
    set(shards 1)
  endif()
  file(GLOB tests CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/${name}/*_test.cpp)
  if(tests)
    add_executable(${name}_test ${tests})
    luminist_test_options(${name}_test)
    target_include_directories(${name}_test PRIVATE ${CMAKE_SOURCE_DIR}/tests)
    target_link_libraries(${name}_test PRIVATE lum_${module} lum_test_support GTest::gtest GTest::gtest_main)
    foreach(shard RANGE 1 ${shards})
      set(part ${name})
      if(shard GREATER 1)
        set(part ${name}.${shard})
      endif()
      math(EXPR index "${shard} - 1")
      add_test(NAME ${part} COMMAND ${name}_test WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
      set_tests_properties(${part} PROPERTIES TIMEOUT 1200
        ENVIRONMENT "LUMINIST_CACHE=${CMAKE_BINARY_DIR}/cache;GTEST_TOTAL_SHARDS=${shards};GTEST_SHARD_INDEX=${index}")
    endforeach()
  endif()
endfunction()

function(luminist_module name)
  cmake_parse_arguments(M "SANITIZE_O0" "TEST_SHARDS" "DEPS;LIBS;PRIVATE_LIBS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/${name}/*.cpp)
  add_library(lum_${name} STATIC ${sources})
  luminist_options(lum_${name})
  if(LUMINIST_SANITIZE AND M_SANITIZE_O0)
    target_compile_options(lum_${name} PRIVATE -O0)
  endif()
  list(TRANSFORM M_DEPS PREPEND lum_)
  target_link_libraries(lum_${name} PUBLIC ${M_DEPS} ${M_LIBS} PRIVATE ${M_PRIVATE_LIBS})

  luminist_tests(${name} ${name} ${M_TEST_SHARDS})
endfunction()
