#include "deadpoint/press/problem/deformation_mesh.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/exchange/deformation.hpp"
#include "deadpoint/press/problem/heat.hpp"

#include <cmath>

namespace deadpoint::press {

casefile::Case case_of_deformation(casefile::Case input)
{
    if (input.numerics.deformation_order == 0)
        return input;
    input.numerics.order = input.numerics.deformation_order;
    for (auto& [name, part] : input.parts)
        part.order = 0;
    return input;
}

double deformation_scale(const casefile::Case& input, const Machine& machine)
{
    if (input.numerics.deformation_size > 0)
        return input.numerics.deformation_size;
    const double unknowns = 3 * static_cast<double>(count_corners(case_of_deformation(input), machine).unknowns());
    return unknowns <= static_cast<double>(largest_factor) ? 1 : std::cbrt(unknowns / wanted_unknowns);
}

}  // namespace deadpoint::press
