#include "solved_case.hpp"
#include <cmath>
using namespace verification;
using namespace deadpoint;
TEST_CASE("scratch")
{
    for (const auto& overrides : {std::vector<std::string>{}, {"parts.upper.tetrahedra=true"}, {"parts.lower.tetrahedra=true"}, {"parts.lower.tetrahedra=true","parts.upper.tetrahedra=true"}, {"parts.upper.tetrahedra=true","parts.upper.size=5 mm"}, {"parts.upper.tetrahedra=true","numerics.order=2"}}) {
        try {
            const auto s = solve("bonded-blocks", overrides);
            MESSAGE("ok "  << s.probe("upper") - (300 + 100 * .023 - 250 * .044 + 70 * .021 - zero_celsius) << " " << s.machine.cells.size());
        } catch (std::exception& e) {
            MESSAGE(std::string(e.what()));
        }
    }
}
