#pragma once

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/fem/space/discretisation.hpp"

/// Internal to fem/: the surfaces of the heat problem by unknowns, and what its parts share.
namespace deadpoint::fem {

inline constexpr double stefan_boltzmann = 5.670374419e-8;  ///< [W/m2/K4]

/// Where two bodies meet through films.
struct HeatInterface {
    SparseFunctional mean_a;
    SparseFunctional mean_b;
    double area = 0;
    double sum = 0;               ///< film_a + film_b + oil
    double heat_weight_area = 0;  ///< its share of its source's heat, 0..1
    double film_heat = 0;         ///< the same, of what falls into its film
    SparseFunctional load_zone;   ///< watts by unknown of one watt by load zone less one spread evenly
    /// Turning joints: per axial strip the moments of both sides' unknowns, (dof, zeroth, first).
    struct Strip {
        std::vector<std::pair<PetscInt, std::array<double, 2>>> a, b;
        std::array<double, 2> norm{};
    };
    std::vector<Strip> strips;
};

struct FilmPoint {
    PointShape shape;
    double weight = 0;
};

/// A surface with a condition.
struct HeatFilm {
    const SurfaceCondition* condition = nullptr;
    SparseFunctional integral;  ///< of T over the surface
    double area = 0;
    std::vector<FilmPoint> points;  ///< only where the coefficient depends on temperature
    std::size_t index = 0;          ///< into HeatProblem::surfaces
};

/// Surfaces that radiate to each other; see heat_radiation.cpp.
struct HeatRoom {
    const RadiantRoom* room = nullptr;
    std::vector<std::size_t> films;  ///< indices into HeatSolver's
    std::vector<OwnedVec> loads;     ///< b, per surface
    std::vector<double> coupling;    ///< row after row; empty: none for the time being [W/K]
};

/// Adds factor * rows x columns to a matrix.
void insert_block(Mat matrix, const PointShape& rows, const PointShape& columns, double factor);

/// Of all ranks' `values` by unknown, at a point.
double value_at(const PointShape& shape, const double* values);

/// A vector of the same layout, its entries not set.
OwnedVec duplicate(Vec vector);

}  // namespace deadpoint::fem
