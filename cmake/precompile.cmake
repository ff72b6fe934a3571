# deadpoint_precompile(TARGET header...): parses these headers, and the standard ones that nearly all sources have, once for the
# target. Sources still include what they use: the presets debug and fuzz build without this.
function(deadpoint_precompile target)
    target_precompile_headers(${target} PRIVATE <algorithm> <cmath> <functional> <map> <memory> <string> <vector> ${ARGN})
    if(CCACHE AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        target_compile_options(${target} PRIVATE -fpch-preprocess)
    endif()
endfunction()

# For sources that compute fields.
function(deadpoint_precompile_fields target)
    deadpoint_precompile(${target} <Eigen/Dense> <fmt/format.h> <petscksp.h>)
endfunction()
