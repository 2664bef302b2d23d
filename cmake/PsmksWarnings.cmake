# Warnings of psmks' own code, for one target. Headers of imported targets are system headers and
# stay silent.
function(psmks_target_warnings target)
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
    if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
      # clang counts among conversions what gcc does not: indices of Eigen and of the standard library.
      target_compile_options(${target} PRIVATE -Wno-sign-conversion)
    endif()
    if(PSMKS_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # gcc takes sources that are included for headers, where unnamed namespaces are a mistake.
      target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
    endif()
    if(PSMKS_WARNINGS_AS_ERRORS)
      target_compile_options(${target} PRIVATE -Werror)
    endif()
  elseif(MSVC)
    target_compile_options(${target} PRIVATE /W4)
    if(PSMKS_WARNINGS_AS_ERRORS)
      target_compile_options(${target} PRIVATE /WX)
    endif()
  endif()
endfunction()
