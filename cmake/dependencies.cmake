# Libraries of Debian 12; scripts/install-dependencies installs them, docs/dependencies.md says why each is there.
find_package(fmt REQUIRED)
find_package(ZLIB REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(spdlog REQUIRED)
find_package(doctest REQUIRED)
find_package(Boost REQUIRED)

find_library(UDUNITS2_LIBRARY udunits2 REQUIRED)
find_path(UDUNITS2_INCLUDE udunits2.h REQUIRED)
add_library(udunits2 INTERFACE)
target_link_libraries(udunits2 INTERFACE ${UDUNITS2_LIBRARY})
target_include_directories(udunits2 SYSTEM INTERFACE ${UDUNITS2_INCLUDE})

find_library(MUPARSER_LIBRARY muparser REQUIRED)
find_path(MUPARSER_INCLUDE muParser.h REQUIRED)
add_library(muparser INTERFACE)
target_link_libraries(muparser INTERFACE ${MUPARSER_LIBRARY})
target_include_directories(muparser SYSTEM INTERFACE ${MUPARSER_INCLUDE})

find_library(SECCOMP_LIBRARY seccomp REQUIRED)
find_path(SECCOMP_INCLUDE seccomp.h REQUIRED)
add_library(seccomp INTERFACE)
target_link_libraries(seccomp INTERFACE ${SECCOMP_LIBRARY})
target_include_directories(seccomp SYSTEM INTERFACE ${SECCOMP_INCLUDE})

find_library(NLOPT_LIBRARY nlopt REQUIRED)
find_path(NLOPT_INCLUDE nlopt.hpp REQUIRED)
add_library(nlopt INTERFACE)
target_link_libraries(nlopt INTERFACE ${NLOPT_LIBRARY})
target_include_directories(nlopt SYSTEM INTERFACE ${NLOPT_INCLUDE})

find_path(TOMLPLUSPLUS_INCLUDE toml++/toml.h REQUIRED)
add_library(tomlplusplus INTERFACE)
target_include_directories(tomlplusplus SYSTEM INTERFACE ${TOMLPLUSPLUS_INCLUDE})

find_library(DMUMPS_LIBRARY dmumps REQUIRED)
find_path(DMUMPS_INCLUDE dmumps_c.h REQUIRED)
add_library(mumps INTERFACE)
target_link_libraries(mumps INTERFACE ${DMUMPS_LIBRARY})
target_include_directories(mumps SYSTEM INTERFACE ${DMUMPS_INCLUDE})

find_library(METIS_LIBRARY metis REQUIRED)
find_path(METIS_INCLUDE metis.h REQUIRED)
add_library(metis INTERFACE)
target_link_libraries(metis INTERFACE ${METIS_LIBRARY})
target_include_directories(metis SYSTEM INTERFACE ${METIS_INCLUDE})

find_library(GMSH_LIBRARY gmsh REQUIRED)
find_path(GMSH_INCLUDE gmsh.h REQUIRED)
add_library(gmsh INTERFACE)
target_link_libraries(gmsh INTERFACE ${GMSH_LIBRARY})
target_include_directories(gmsh SYSTEM INTERFACE ${GMSH_INCLUDE})

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
