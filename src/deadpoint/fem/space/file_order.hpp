#pragma once

#include "deadpoint/fem/algebra/petsc.hpp"
#include "deadpoint/fem/space/discretisation.hpp"

#include <string>
#include <vector>

/// Internal to fem/: fields in files, numbered so that any number of ranks can read what any other wrote.
namespace deadpoint::fem {

/// A text that identifies mesh, elements and unknowns; the same on any number of ranks.
std::string mesh_text(const Discretisation& space);

/// Global numbers of the unknowns in the order of a file: by their first appearance cell by cell.
std::vector<std::size_t> order_of_file(const Discretisation& space);

/// This rank's share of a field that was read.
template <class Value>
std::vector<double> share_of_file(const Discretisation& space, const std::vector<std::size_t>& order,
                                  const std::vector<Value>& values)
{
    std::vector<double> owned(static_cast<std::size_t>(space.last - space.first));
    for (std::size_t i = 0; i < order.size(); ++i)
        if (const auto unknown = static_cast<PetscInt>(order[i]); space.owns(unknown))
            owned[static_cast<std::size_t>(unknown - space.first)] = values[i];
    return owned;
}

}  // namespace deadpoint::fem
