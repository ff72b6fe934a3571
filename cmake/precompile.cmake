# deadpoint_precompile_fields(TARGET): parses the headers of deal.II and PETSc once for a target that has them in most of its
# sources. Sources still include what they use: the presets debug and fuzz build without this.
function(deadpoint_precompile_fields target)
    target_precompile_headers(${target} PRIVATE <algorithm> <cmath> <functional> <map> <memory> <string> <vector> <Eigen/Dense>
        <fmt/format.h> <deal.II/distributed/shared_tria.h> <deal.II/dofs/dof_tools.h> <deal.II/fe/fe_q.h>
        <deal.II/fe/fe_simplex_p.h> <deal.II/fe/mapping_fe.h> <deal.II/fe/mapping_q.h> <deal.II/hp/fe_values.h>
        <deal.II/lac/dynamic_sparsity_pattern.h> <petscksp.h>)
    if(CCACHE AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        target_compile_options(${target} PRIVATE -fpch-preprocess)
    endif()
endfunction()
