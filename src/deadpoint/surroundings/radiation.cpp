#include "deadpoint/surroundings/radiation.hpp"

#include "deadpoint/error.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

namespace deadpoint::surroundings {

LawValue radiation_coefficient(double emissivity, double surface_temperature, double ambient_temperature)
{
    const double s = surface_temperature;
    const double a = ambient_temperature;
    if (!(emissivity >= 0 && emissivity <= 1))
        throw DomainError(fmt::format("emissivity {} is not between 0 and 1", emissivity));
    if (!(s > 0) || !(a > 0))
        throw DomainError(
            fmt::format("radiation needs absolute temperatures above zero: surface {} K, ambient {} K", s, a));
    const double factor = emissivity * stefan_boltzmann;
    return {factor * (s * s + a * a) * (s + a), factor * (3 * s * s + 2 * s * a + a * a), true};
}

namespace {

void require_surfaces(const std::vector<double>& areas, const std::vector<double>& emissivities)
{
    if (areas.size() != emissivities.size())
        throw DomainError("radiation in an enclosure needs one emissivity per area");
    for (const double area : areas)
        if (!(area > 0))
            throw DomainError(fmt::format("radiation in an enclosure: area {} m2 is not positive", area));
    for (const double emissivity : emissivities)
        if (!(emissivity > 0 && emissivity <= 1))
            throw DomainError(
                fmt::format("radiation in an enclosure: emissivity {} is not above 0 and at most 1", emissivity));
}

// u of enclosure_exchange() where no surface is larger than all others together.
Eigen::ArrayXd view_shares(const Eigen::ArrayXd& areas)
{
    constexpr int most_iterations = 100000;
    Eigen::ArrayXd shares = areas / areas.sum();
    double change = 1;
    for (int iteration = 0; iteration < most_iterations && change > 1e-14; ++iteration) {
        const Eigen::ArrayXd weight = areas / (1 - shares);
        const Eigen::ArrayXd next = weight / weight.sum();
        change = (next - shares).abs().maxCoeff();
        shares = next;
    }
    return shares;
}

// A_i F_ij, without the radiation of a surface to itself.
Eigen::MatrixXd view_areas(const Eigen::ArrayXd& areas)
{
    Eigen::Index largest = 0;
    const double most = areas.maxCoeff(&largest);
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(areas.size(), areas.size());
    if (2 * most >= areas.sum() * (1 - 1e-9)) {
        result.col(largest) = areas;
        result.row(largest) = areas;
    } else {
        const Eigen::ArrayXd shares = view_shares(areas);
        const double size = (areas / (1 - shares)).sum();
        result = size * (shares.matrix() * shares.matrix().transpose());
    }
    result.diagonal().setZero();
    return result;
}

}  // namespace

std::vector<double> enclosure_exchange(const std::vector<double>& areas, const std::vector<double>& emissivities)
{
    require_surfaces(areas, emissivities);
    const auto count = static_cast<Eigen::Index>(areas.size());
    const Eigen::ArrayXd area = Eigen::Map<const Eigen::ArrayXd>(areas.data(), count);
    const Eigen::ArrayXd emissivity = Eigen::Map<const Eigen::ArrayXd>(emissivities.data(), count);
    Eigen::MatrixXd view = view_areas(area);
    view.diagonal() = area.matrix() - view.rowwise().sum();
    view = (1 / area).matrix().asDiagonal() * view;
    const Eigen::MatrixXd reflected =
        Eigen::MatrixXd::Identity(count, count) - view * (1 - emissivity).matrix().asDiagonal();
    const Eigen::MatrixXd seen = reflected.partialPivLu().solve(view);
    const Eigen::MatrixXd exchange =
        (emissivity * area).matrix().asDiagonal() * seen * emissivity.matrix().asDiagonal();
    std::vector<double> result;
    for (Eigen::Index i = 0; i < count; ++i)
        for (Eigen::Index j = 0; j < count; ++j)
            result.push_back(0.5 * (exchange(i, j) + exchange(j, i)));  // symmetric except for rounding
    return result;
}

FilmLaw constant_film(double coefficient, double emissivity, double ambient_temperature)
{
    if (!(coefficient >= 0))
        throw DomainError(fmt::format("film coefficient {} W/m2/K is negative", coefficient));
    if (emissivity == 0)
        return [coefficient](double) { return LawValue{coefficient, 0, true}; };
    (void)radiation_coefficient(emissivity, ambient_temperature,
                                ambient_temperature);  // refuses wrong arguments at once
    return [=](double surface_temperature) {
        LawValue film = radiation_coefficient(emissivity, surface_temperature, ambient_temperature);
        film.value += coefficient;
        return film;
    };
}

}  // namespace deadpoint::surroundings
