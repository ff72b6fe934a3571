#include "deadpoint/reduce/certificate/bends.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace deadpoint::reduce {
namespace {

double ratio(const BentLaw& law) { return law.seen * law.curvature / law.fall; }

}  // namespace

double largest_of_bent(const std::vector<BentLaw>& laws, double energy)
{
    auto ordered = laws;
    std::ranges::sort(ordered, std::greater{}, ratio);
    double least = ordered.empty() ? 0 : ratio(ordered.front()) / 2 * energy;
    double by_bends = 0;
    for (std::size_t k = 0; k < ordered.size(); ++k) {
        const auto& law = ordered[k];
        by_bends += law.duration * law.seen * law.bend * law.seen * law.bend / law.fall;
        const double next = k + 1 < ordered.size() ? ratio(ordered[k + 1]) : 0;
        least = std::min(least, next / 2 * energy + std::sqrt(by_bends * energy));
    }
    return least;
}

}  // namespace deadpoint::reduce
