# luminist_tool(NAME DEPS modules...)
#
# A program in tools/NAME that makes things. All but its main.cpp is the library lum_NAME, so that tests/NAME/*_test.cpp
# can look at what it makes without a file between.
function(luminist_tool name)
  cmake_parse_arguments(T "" "" "DEPS" ${ARGN})
  find_package(CLI11 REQUIRED CONFIG QUIET)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(REMOVE_ITEM sources ${CMAKE_CURRENT_SOURCE_DIR}/main.cpp)
  add_library(lum_${name} STATIC ${sources})
  luminist_options(lum_${name})
  target_include_directories(lum_${name} PUBLIC ${CMAKE_SOURCE_DIR}/tools)
  list(TRANSFORM T_DEPS PREPEND lum_)
  target_link_libraries(lum_${name} PUBLIC ${T_DEPS})

  add_executable(${name} main.cpp)
  luminist_options(${name})
  target_link_libraries(${name} PRIVATE lum_${name} CLI11::CLI11)
  add_dependencies(${name} luminist-image)
  luminist_tests(${name} ${name})
endfunction()
