# One function per kind of target, so that every target of ours gets the same language level and the same warnings.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

find_program(NADIR_CCACHE ccache)
if(NADIR_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # The first two let it keep what was compiled with precompiled headers; ccache's manual explains both.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${NADIR_CCACHE})
endif()

# $<BOOL:address,undefined> is an error in CMake, hence the plain if().
if(NADIR_SANITIZE)
  add_compile_options(-fsanitize=${NADIR_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${NADIR_SANITIZE})
  if(NADIR_SANITIZE MATCHES "undefined")  # a fifth of the time to compile, for what AddressSanitizer mostly finds as well
    add_compile_options(-fno-sanitize=vptr,object-size,null)
  endif()
  # Eigen allocates in another way under AddressSanitizer, and then frees what PCL's library has allocated in the usual one.
  add_compile_definitions(EIGEN_MALLOC_ALREADY_ALIGNED=1)
endif()

# Fused multiply-add would make results depend on the instruction set that a function was compiled for.
add_compile_options(-ffp-contract=off)

# For tests where everything is built from nothing: what they check is optimised, they themselves compile in two thirds of
# the time without.
function(nadir_plain_if_united target)
  if(NADIR_UNITE_SOURCES)
    target_compile_options(${target} PRIVATE -O0)
  endif()
endfunction()

# Sanitizers see code that computes little as it was written, which compiles in two fifths of the time.
function(nadir_plain_if_sanitized target)
  if(NADIR_SANITIZE)
    target_compile_options(${target} PRIVATE -O0)
  endif()
endfunction()

function(nadir_warnings target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Woverloaded-virtual
    $<$<BOOL:${NADIR_WARNINGS_ARE_ERRORS}>:-Werror>
    # g++ 12 has it wrong for "a" + std::string where it inlines much (PR 105651).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
    # A type of one source's own looks like a header's where sources are united.
    $<$<AND:$<BOOL:${NADIR_UNITE_SOURCES}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>)
endfunction()

# Several sources in one: headers are read once for all of them.
function(nadir_unite_sources target)
  if(NADIR_UNITE_SOURCES)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${NADIR_UNITE_SOURCES})
  endif()
endfunction()

# nadir_add_module(core/mcl SOURCES a.cpp DEPENDS core/map PUBLIC_LIBRARIES x PRIVATE_LIBRARIES y)
# Library core_mcl, alias nadir::core_mcl, include path the project's root.
function(nadir_add_module path)
  cmake_parse_arguments(MODULE "" "" "SOURCES;DEPENDS;PUBLIC_LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  string(REPLACE "/" "_" name ${path})
  add_library(${name} STATIC ${MODULE_SOURCES})
  add_library(nadir::${name} ALIAS ${name})
  target_include_directories(${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/nadir>)
  target_compile_features(${name} PUBLIC cxx_std_20)
  foreach(dependency IN LISTS MODULE_DEPENDS)
    string(REPLACE "/" "_" dependency_name ${dependency})
    target_link_libraries(${name} PUBLIC ${dependency_name})
  endforeach()
  target_link_libraries(${name} PUBLIC ${MODULE_PUBLIC_LIBRARIES} PRIVATE ${MODULE_PRIVATE_LIBRARIES})
  nadir_warnings(${name})
  nadir_unite_sources(${name})
  if(path MATCHES "^core/")  # what is installed as nadir::core
    set_property(GLOBAL APPEND PROPERTY NADIR_MODULES ${name})
  endif()
endfunction()

# nadir_add_test(core/mcl SOURCES a_test.cpp DEPENDS core_sim LABELS unit): one program, one CTest entry a test.
function(nadir_add_test path)
  cmake_parse_arguments(TEST "" "TIMEOUT" "SOURCES;DEPENDS;LABELS" ${ARGN})
  string(REPLACE "/" "_" name ${path}_test)
  add_executable(${name} ${TEST_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${TEST_DEPENDS} GTest::gmock GTest::gtest_main)
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
  nadir_warnings(${name})
  if(NOT TEST_LABELS)
    set(TEST_LABELS unit)
  endif()
  if(NOT "slow" IN_LIST TEST_LABELS)  # those compute much themselves
    target_precompile_headers(${name} REUSE_FROM test_headers)
    nadir_plain_if_united(${name})
  endif()
  nadir_unite_sources(${name})
  if("unit" IN_LIST TEST_LABELS OR "fuzz" IN_LIST TEST_LABELS)  # what AddressSanitizer looks at
    add_dependencies(unit_tests ${name})
  else()  # what CI looks at in an optimised build
    add_dependencies(whole_tests ${name})
  endif()
  if("slow" IN_LIST TEST_LABELS)  # statistics over many draws, nothing that a sanitizer has not seen in the quick ones
    set(cost 100)
  elseif("data" IN_LIST TEST_LABELS)
    set(cost 1000)
  else()
    set(cost 1)
  endif()
  if("threads" IN_LIST TEST_LABELS)  # what ThreadSanitizer looks at
    add_dependencies(thread_tests ${name})
  endif()
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 900)
  endif()
  add_test(NAME ${name} COMMAND ${name} --gtest_brief=1)
  set_tests_properties(${name} PROPERTIES LABELS "${TEST_LABELS}" TIMEOUT ${TEST_TIMEOUT} COST ${cost}
    SKIP_REGULAR_EXPRESSION "NADIR_TEST_DATA is not set")
  if(NADIR_SANITIZE MATCHES "address")
    set_tests_properties(${name} PROPERTIES
      ENVIRONMENT "LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/lsan_suppressions.txt:print_suppressions=0")
  endif()
  if(NADIR_SANITIZE MATCHES "thread")
    set_tests_properties(${name} PROPERTIES
      ENVIRONMENT "TSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/tsan_suppressions.txt")
  endif()
endfunction()
