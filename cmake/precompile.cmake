# deadpoint_precompile_fields(TARGET): parses the headers of deal.II and PETSc once for a target that has them in most of its
# sources. Sources still include what they use: the presets debug and fuzz build without this.
function(deadpoint_precompile_fields target)
    target_precompile_headers(${target} PRIVATE <algorithm> <cmath> <functional> <map> <memory> <string> <vector> <Eigen/Dense>
        <fmt/format.h> <deal.II/base/quadrature_lib.h> <deal.II/base/symmetric_tensor.h> <deal.II/fe/fe_q.h>
        <deal.II/fe/fe_simplex_p.h> <deal.II/hp/fe_collection.h> <deal.II/hp/q_collection.h> <deal.II/lac/full_matrix.h>
        <petscksp.h>)
    if(CCACHE AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        target_compile_options(${target} PRIVATE -fpch-preprocess)
    endif()
endfunction()
