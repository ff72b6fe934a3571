#include "deadpoint/full/frame/press_compliance.hpp"

#include "deadpoint/drift/chain.hpp"
#include "deadpoint/exchange/gaps.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/press/drift/chain_model.hpp"
#include "deadpoint/press/drift/gap_model.hpp"

namespace deadpoint::full {

press::PressCompliance press_compliance(fem::Model& model, const press::ChainModel& chain, const press::GapModel& gaps,
                                        bool half_model)
{
    const double share = half_model ? 0.5 : 1;  // of a force on the whole press, on the half that is modelled
    const auto& gap = chain.dimensions[drift::gap];
    std::vector<Functional> functionals{gap};
    functionals.insert(functionals.end(), gaps.functionals.begin(),
                       gaps.functionals.begin() + static_cast<std::ptrdiff_t>(gaps.corners.size()));
    const auto openings = model.evaluate(functionals, model.deformation_adjoint(gap));
    press::PressCompliance result;
    result.opening = share * openings.front();
    if (gaps.corners.empty())
        return result;
    auto corners = gaps.corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i].gap = {{share * openings[1 + i]}, {0}};
    const auto all = press::parallelism(std::move(corners), gaps.mirrored);
    for (const auto& corner : all.corners)
        result.corners.push_back({corner.name, corner.gap.value.front()});
    result.left_right = all.left_right.value.front();
    result.front_back = all.front_back.value.front();
    return result;
}

}  // namespace deadpoint::full
