#pragma once

#include "deadpoint/exchange/laws/material.hpp"
#include "deadpoint/exchange/stress.hpp"

/// Internal to fem/: Hooke's law with thermal strain.
namespace deadpoint::fem {

struct Lame {
    double lambda = 0;  ///< [Pa]
    double mu = 0;      ///< [Pa]
};
inline Lame lame(const Material& m)
{
    return {m.youngs_modulus * m.poissons_ratio / ((1 + m.poissons_ratio) * (1 - 2 * m.poissons_ratio)),
            m.youngs_modulus / (2 * (1 + m.poissons_ratio))};
}

/// sigma = 2 mu eps + lambda tr(eps) 1 for the elastic strain, which is total strain less thermal
/// and initial strain.
inline Tensor6 hooke(const Material& m, const Tensor6& strain)
{
    const auto [lambda, mu] = lame(m);
    const double dilatation = lambda * (strain[0] + strain[1] + strain[2]);
    Tensor6 stress{};
    for (std::size_t i = 0; i < 6; ++i)
        stress[i] = 2 * mu * strain[i] + (i < 3 ? dilatation : 0);
    return stress;
}

}  // namespace deadpoint::fem
