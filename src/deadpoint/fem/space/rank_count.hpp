#pragma once

#include <cstddef>

namespace deadpoint::fem {

/// How many ranks make a run quick without harm: no more than cores, than the cells keep busy, and than the memory
/// holds. docs/performance.md has the measurements behind both limits.
///
/// @param cells   of the mesh of the heat
/// @param cores   that may be used, >= 1
/// @param memory  that may be used [byte]
/// @return >= 1
int rank_count(std::size_t cells, int cores, double memory);

}  // namespace deadpoint::fem
