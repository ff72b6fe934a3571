#include "deadpoint/fem/conduction/heat_solver.hpp"

#include <algorithm>
#include <cmath>

// Surfaces that radiate to each other. With E_i the mean of sigma T^4 over surface i, what reaches it is
//   H_i = sum of X_ij E_j / (eps_i A_i)                                                      [W/m2]
// and each of its points gives off eps_i (sigma T^4 - H_i). The tangent of the first term is in the matrix, with that
// of the films; that of the second couples all points of all surfaces and is applied with vectors b_i of the sum 1,
//   sum over i, j of b_i sqrt(c_i c_j) X_ij b_j^T,    c_i = mean of 4 sigma T^3,    b_i = integral of 4 sigma T^3 phi /
//   (c_i A_i)
// symmetric, and with the first term positive; exact where all points of the room are of one temperature.

namespace deadpoint::fem {

void HeatSolver::prepare_rooms()
{
    for (const auto& room : problem_->radiation) {
        HeatRoom& prepared = rooms_.emplace_back();
        prepared.room = &room;
        for (const int surface : room.surfaces) {
            const auto film = std::ranges::find(films_, static_cast<std::size_t>(surface), &HeatFilm::index);
            prepared.films.push_back(static_cast<std::size_t>(film - films_.begin()));
            prepared.loads.push_back(duplicate(now_));
        }
    }
}

// Temperature whose radiation a surface receives, per surface condition; 0 for those of no room [K].
std::vector<double> HeatSolver::irradiation(const double* values) const
{
    std::vector<double> fourth(problem_->surfaces.size(), 0.0), result = fourth;
    for (const auto& room : rooms_)
        for (const auto i : room.films)
            for (const auto& point : films_[i].points)
                fourth[films_[i].index] += point.weight * std::pow(value_at(point.shape, values), 4) / films_[i].area;
    sum_over_ranks(fourth);
    for (const auto& room : rooms_) {
        const std::size_t count = room.films.size();
        for (std::size_t i = 0; i < count; ++i) {
            double received = 0, all = 0;
            for (std::size_t j = 0; j < count; ++j) {
                const double exchange = room.room->exchange[i * count + j];
                received += exchange * fourth[films_[room.films[j]].index];
                all += exchange;
            }
            result[films_[room.films[i]].index] = std::sqrt(std::sqrt(received / all));
        }
    }
    return result;
}

// @param values  of all ranks, by unknown
void HeatSolver::build_room_loads(const double* values)
{
    for (auto& room : rooms_) {
        const std::size_t count = room.films.size();
        std::vector<double> slope(count, 0.0);
        for (std::size_t i = 0; i < count; ++i) {
            const auto& film = films_[room.films[i]];
            Vec load = room.loads[i];
            DEADPOINT_PETSC(VecSet(load, 0));
            for (const auto& point : film.points) {
                const double here = point.weight * film_slope({}, 1, value_at(point.shape, values), 0);
                for (int k = 0; k < point.shape.count; ++k)
                    DEADPOINT_PETSC(VecSetValue(load, point.shape.dof[k], here * point.shape.value[k], ADD_VALUES));
            }
            DEADPOINT_PETSC(VecAssemblyBegin(load));
            DEADPOINT_PETSC(VecAssemblyEnd(load));
            double sum = 0;
            DEADPOINT_PETSC(VecSum(load, &sum));
            DEADPOINT_PETSC(VecScale(load, 1 / sum));
            clear_prescribed(load);
            slope[i] = sum / film.area;
        }
        room.coupling.resize(count * count);
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = 0; j < count; ++j)
                room.coupling[i * count + j] = std::sqrt(slope[i] * slope[j]) * room.room->exchange[i * count + j];
    }
}

// out -= factor sum of b_i coupling_ij (b_j . in)
void HeatSolver::multiply_rooms(Vec in, Vec out) const
{
    for (const auto& room : rooms_) {
        if (room.coupling.empty())
            continue;
        const auto count = static_cast<PetscInt>(room.loads.size());
        const std::vector<Vec> loads(room.loads.begin(), room.loads.end());
        std::vector<double> products(loads.size()), received(loads.size(), 0.0);
        DEADPOINT_PETSC(VecMDot(in, count, loads.data(), products.data()));
        for (std::size_t i = 0; i < loads.size(); ++i)
            for (std::size_t j = 0; j < loads.size(); ++j)
                received[i] -= system_factor_ * room.coupling[i * loads.size() + j] * products[j];
        DEADPOINT_PETSC(VecMAXPY(out, count, received.data(), const_cast<Vec*>(loads.data())));
    }
}

}  // namespace deadpoint::fem
