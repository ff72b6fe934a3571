#include "deadpoint/drift/play.hpp"

namespace deadpoint::drift {

double BearingPlay::slope(double growth) const
{
    if (kind == Kind::none)
        return 0;
    return kind == Kind::limited && growth < -initial ? 0 : 1;
}

double BearingPlay::taken(double growth) const
{
    if (kind == Kind::none)
        return 0;
    return slope(growth) == 0 ? -initial : growth;
}

double BearingPlay::share(double growth) const { return growth == 0 ? slope(growth) : taken(growth) / growth; }

}  // namespace deadpoint::drift
