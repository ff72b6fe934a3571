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
    deadpoint_precompile(${target} <Eigen/Dense> <fmt/format.h> <deal.II/base/quadrature_lib.h> <deal.II/base/symmetric_tensor.h>
        <deal.II/fe/fe_q.h> <deal.II/fe/fe_simplex_p.h> <deal.II/hp/fe_collection.h> <deal.II/hp/q_collection.h>
        <deal.II/lac/full_matrix.h> <petscksp.h>)
endfunction()
