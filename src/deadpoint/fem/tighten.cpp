#include "deadpoint/fem/tighten.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/fem/model.hpp"

#include <Eigen/Dense>

namespace deadpoint::fem {
namespace {

constexpr double unit_strain = 1e-3;

}  // namespace

RestLoads tighten(Model& model, std::size_t part_count, const std::vector<ForceGauge>& rods,
                  const std::vector<double>& forces, const Vec3& gravity)
{
    RestLoads result{gravity, {}};
    if (rods.empty())
        return result;
    const auto count = static_cast<Eigen::Index>(rods.size());
    Eigen::MatrixXd per_strain(count, count);
    Eigen::VectorXd missing = Eigen::Map<const Eigen::VectorXd>(forces.data(), count);
    if (norm(gravity) > 0) {
        const auto by_weight = model.forces(rods, result, model.displacement(result));
        missing -= Eigen::Map<const Eigen::VectorXd>(by_weight.data(), count);
    }
    for (Eigen::Index j = 0; j < count; ++j) {
        RestLoads one{{}, std::vector<Tensor6>(part_count)};
        one.initial_strain[static_cast<std::size_t>(rods[j].index)][static_cast<std::size_t>(rods[j].axis)] =
            -unit_strain;
        const auto got = model.forces(rods, one, model.displacement(one));
        per_strain.col(j) = Eigen::Map<const Eigen::VectorXd>(got.data(), count);
        if (!(got[static_cast<std::size_t>(j)] > 0))
            throw InputError("tightening rod '" + rods[j].name +
                             "' does not stretch it: nothing stands against its two ends; see which parts it is "
                             "bonded to with `deadpoint check`");
    }
    const Eigen::VectorXd strain = per_strain.fullPivLu().solve(missing);
    result.initial_strain.resize(part_count);
    for (Eigen::Index j = 0; j < count; ++j)
        result.initial_strain[static_cast<std::size_t>(rods[j].index)][static_cast<std::size_t>(rods[j].axis)] =
            -unit_strain * strain[j];
    return result;
}

}  // namespace deadpoint::fem
