# Libraries of Debian 12; scripts/install-dependencies installs them, docs/dependencies.md says why each is there.
find_package(fmt REQUIRED)
find_package(ZLIB REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(spdlog REQUIRED)
find_package(doctest REQUIRED)
find_package(Boost REQUIRED)

# A library without a package file for CMake, as a target.
function(deadpoint_library target library header)
    find_library(${target}_LIBRARY ${library} REQUIRED)
    find_path(${target}_INCLUDE ${header} REQUIRED)
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE ${${target}_LIBRARY})
    target_include_directories(${target} SYSTEM INTERFACE ${${target}_INCLUDE})
endfunction()

deadpoint_library(udunits2 udunits2 udunits2.h)
deadpoint_library(muparser muparser muParser.h)
deadpoint_library(seccomp seccomp seccomp.h)
deadpoint_library(nlopt nlopt nlopt.hpp)
deadpoint_library(mumps dmumps dmumps_c.h)
deadpoint_library(metis metis metis.h)
deadpoint_library(gmsh gmsh gmsh.h)

find_path(TOMLPLUSPLUS_INCLUDE toml++/toml.h REQUIRED)
add_library(tomlplusplus INTERFACE)
target_include_directories(tomlplusplus SYSTEM INTERFACE ${TOMLPLUSPLUS_INCLUDE})

# Open CASCADE, which Gmsh needs too. Its own package file asks for the parts with windows as well.
find_path(OPENCASCADE_INCLUDE Standard.hxx PATH_SUFFIXES opencascade REQUIRED)
add_library(opencascade INTERFACE)
target_include_directories(opencascade SYSTEM INTERFACE ${OPENCASCADE_INCLUDE})
foreach(toolkit IN ITEMS TKXDESTEP TKXCAF TKLCAF TKCAF TKCDF TKSTEP TKSTEPAttr TKSTEP209 TKSTEPBase TKXSBase TKBO TKShHealing TKMesh TKPrim TKTopAlgo TKGeomAlgo TKBRep TKG3d TKGeomBase TKMath
    TKernel)
    find_library(${toolkit}_LIBRARY ${toolkit} REQUIRED)
    target_link_libraries(opencascade INTERFACE ${${toolkit}_LIBRARY})
endforeach()

# deal.II: the imported target only, since deal_ii_setup_target() would force its own language standard on ours.
find_package(deal.II 9.4 REQUIRED HINTS /usr)
add_library(dealii INTERFACE)
target_link_libraries(dealii INTERFACE ${DEAL_II_TARGET_RELEASE})
# Its headers call into PETSc, MPI, TBB and Trilinos, which come with it but are not named by its target.
target_link_options(dealii INTERFACE -Wl,--copy-dt-needed-entries)
target_include_directories(dealii SYSTEM INTERFACE ${DEAL_II_INCLUDE_DIRS})
