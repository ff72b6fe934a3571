#pragma once

#include "deadpoint/fem/space/discretisation.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace deadpoint {
struct HeatProblem;
}
namespace deadpoint::heat {
struct FilmAt;
struct FilmHeat;
}  // namespace deadpoint::heat

/// Internal to fem/: convection coefficients that depend on temperature, point by point, and
/// radiation among surfaces.
namespace deadpoint::fem {

class PrescribedTemperatures;

/// Surfaces that radiate to each other. With E_i the mean of sigma T^4 over surface i, its
/// irradiation is
///   H_i = sum of X_ij E_j / (eps_i A_i)                                                      [W/m2]
/// and each of its points gives off eps_i (sigma T^4 - H_i). The tangent of the first term is in the matrix, with that
/// of the films; that of the second couples all points of all surfaces and is applied with vectors b_i of the sum 1,
///   sum over i, j of b_i sqrt(c_i c_j) X_ij b_j^T,    c_i = mean of 4 sigma T^3,    b_i = integral of 4 sigma T^3 phi
///   / (c_i A_i)
/// symmetric, and with the first term positive; exact where all points of the room are of one temperature.
class FilmPoints {
public:
    FilmPoints(const Discretisation& space, const HeatProblem& problem, const std::vector<double>& surface_area,
               const PrescribedTemperatures& prescribed, Vec pattern);

    void adopt(const HeatProblem& problem) { problem_ = &problem; }
    /// True if some coefficient depends on temperature.
    [[nodiscard]] bool some() const { return gathered_ != nullptr; }
    /// Adds the heat of these surfaces to the watts by unknown.
    [[nodiscard]] heat::FilmHeat add_heat(const std::vector<heat::FilmAt>& films, Vec temperature, Vec watts) const;
    /// Adds the slopes of their heat by the temperature of the air, without radiation.
    void add_slopes(const std::vector<heat::FilmAt>& films, Vec temperature, Vec load) const;
    /// Writes the tangents at a temperature into a matrix, and those of the rooms for
    /// multiply_rooms().
    void build_tangents(const std::vector<heat::FilmAt>& films, Vec temperature, Mat matrix);
    /// Writes given coefficients, per surface condition, into a matrix.
    void build_constant(const std::vector<double>& coefficients, Mat matrix) const;
    /// No rooms until the next build_tangents().
    void forget_rooms();
    /// out -= factor sum of b_i coupling_ij (b_j . in)
    void multiply_rooms(double factor, Vec in, Vec out) const;

private:
    struct Point {
        PointShape shape;
        double weight = 0;
    };
    struct Room {
        std::vector<std::size_t> surfaces;  ///< indices of conditions
        std::vector<OwnedVec> loads;        ///< b, per surface
        std::vector<double> coupling;       ///< row after row; empty: none for the time being [W/K]
    };
    void prepare_points();
    void prepare_rooms(Vec pattern);
    [[nodiscard]] std::vector<double> irradiation(const double* values) const;
    void build_room(std::size_t room, const double* values);
    double build_room_load(std::size_t surface, const double* values, Vec load) const;
    void fill(Mat matrix, const std::function<double(std::size_t surface, const Point&)>& coefficient) const;

    const Discretisation& space_;
    const HeatProblem* problem_;
    const std::vector<double>& surface_area_;
    const PrescribedTemperatures& prescribed_;
    std::vector<std::vector<Point>> points_;  ///< per surface condition, this rank's
    std::vector<Room> rooms_;
    std::unique_ptr<Gathered> gathered_;
};

}  // namespace deadpoint::fem
