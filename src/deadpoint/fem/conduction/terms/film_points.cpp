#include "deadpoint/fem/conduction/terms/film_points.hpp"

#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/laws/laws.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/algebra/vectors.hpp"
#include "deadpoint/fem/conduction/terms/heat_functionals.hpp"
#include "deadpoint/fem/conduction/terms/prescribed.hpp"
#include "deadpoint/fem/conduction/terms/sparse_term.hpp"
#include "deadpoint/heat/films.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::fem {
namespace {

void add_values(Vec vector, const PointShape& shape, double factor)
{
    for (int i = 0; i < shape.count; ++i)
        DEADPOINT_PETSC(VecSetValue(vector, shape.dof[i], factor * shape.value[i], ADD_VALUES));
}

void assemble(Vec vector)
{
    DEADPOINT_PETSC(VecAssemblyBegin(vector));
    DEADPOINT_PETSC(VecAssemblyEnd(vector));
}

}  // namespace

FilmPoints::FilmPoints(const Discretisation& space, const HeatProblem& problem, const std::vector<double>& surface_area,
                       const PrescribedTemperatures& prescribed, Vec pattern)
    : space_(space), problem_(&problem), surface_area_(surface_area), prescribed_(prescribed)
{
    points_.resize(problem.surfaces.size());
    if (std::ranges::none_of(problem.surfaces, heat::follows_temperature))
        return;
    gathered_ = std::make_unique<Gathered>(pattern);
    prepare_points();
    prepare_rooms(pattern);
}

void FilmPoints::prepare_points()
{
    const auto& machine = space_.machine;
    PointShape shape;
    for (std::size_t s = 0; s < points_.size(); ++s) {
        const auto& condition = problem_->surfaces[s];
        if (!heat::follows_temperature(condition))
            continue;
        for (const auto& [index, fraction, central] : faces_of(machine, condition)) {
            if (!space_.owns_cell(machine.faces[index].cell))
                continue;
            for (const auto& point : face_points(machine, machine.faces[index])) {
                space_.evaluate(index, point.position, false, shape);
                points_[s].push_back({without_zeros(shape), fraction * point.weight});
            }
        }
    }
}

void FilmPoints::prepare_rooms(Vec pattern)
{
    for (const auto& room : problem_->radiation) {
        auto& prepared = rooms_.emplace_back();
        for (const int surface : room.surfaces) {
            prepared.surfaces.push_back(static_cast<std::size_t>(surface));
            prepared.loads.push_back(duplicate(pattern));
        }
    }
}

// Temperature whose radiation a surface receives, per surface condition; 0 for those of no room [K].
std::vector<double> FilmPoints::irradiation(const double* values) const
{
    std::vector<double> fourth(problem_->surfaces.size(), 0.0), result = fourth;
    for (const auto& room : rooms_)
        for (const auto s : room.surfaces)
            for (const auto& point : points_[s])
                fourth[s] += point.weight * std::pow(value_at(point.shape, values), 4) / surface_area_[s];
    sum_over_ranks(fourth);
    for (std::size_t r = 0; r < rooms_.size(); ++r) {
        const auto& surfaces = rooms_[r].surfaces;
        const std::size_t count = surfaces.size();
        for (std::size_t i = 0; i < count; ++i) {
            double received = 0, all = 0;
            for (std::size_t j = 0; j < count; ++j) {
                const double exchange = problem_->radiation[r].exchange[i * count + j];
                received += exchange * fourth[surfaces[j]];
                all += exchange;
            }
            result[surfaces[i]] = std::sqrt(std::sqrt(received / all));
        }
    }
    return result;
}

heat::FilmHeat FilmPoints::add_heat(const std::vector<heat::FilmAt>& films, Vec temperature, Vec watts) const
{
    const double* values = gathered_->gather(temperature);
    const auto received = irradiation(values);
    const std::size_t count = problem_->surfaces.size();
    std::vector<double> sums(3 * count, 0.0);  // lost heat, heat to other surfaces, untested area
    for (const auto& film : films) {
        const bool in_room = received[film.surface] > 0;
        for (const auto& point : points_[film.surface]) {
            const double at = value_at(point.shape, values);
            const LawValue value = film.law(at);
            const double to_surfaces =
                in_room ? point.weight * heat::film_flux({}, film.emissivity, at, received[film.surface]) : 0;
            const double flow = to_surfaces + point.weight * heat::film_flux(value, in_room ? 0 : film.emissivity, at,
                                                                             film.surroundings);
            sums[film.surface] += flow;
            sums[count + film.surface] += to_surfaces;
            sums[2 * count + film.surface] += value.in_range ? 0 : point.weight;
            add_values(watts, point.shape, -flow);
        }
    }
    assemble(watts);
    sum_over_ranks(sums);
    const auto part = [&](std::size_t k) {
        const auto begin = sums.begin() + static_cast<std::ptrdiff_t>(k * count);
        return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(count));
    };
    return {part(0), part(1), part(2)};
}

void FilmPoints::add_slopes(const std::vector<heat::FilmAt>& films, Vec temperature, Vec load) const
{
    if (films.empty())
        return;
    const double* values = gathered_->gather(temperature);
    for (const auto& film : films)
        for (const auto& point : points_[film.surface]) {
            const double at = value_at(point.shape, values);
            add_values(load, point.shape, point.weight * heat::film_slope(film.law(at), 0, at, film.surroundings));
        }
}

void FilmPoints::fill(Mat matrix, const std::function<double(std::size_t, const Point&)>& coefficient) const
{
    DEADPOINT_PETSC(MatZeroEntries(matrix));
    for (std::size_t s = 0; s < points_.size(); ++s)
        for (const auto& point : points_[s])
            insert_block(matrix, point.shape, point.shape, coefficient(s, point) * point.weight);
    DEADPOINT_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
}

void FilmPoints::build_tangents(const std::vector<heat::FilmAt>& films, Vec temperature, Mat matrix)
{
    const double* values = gathered_->gather(temperature);
    for (std::size_t r = 0; r < rooms_.size(); ++r)
        build_room(r, values);
    std::vector<const heat::FilmAt*> of_surface(points_.size(), nullptr);
    for (const auto& film : films)
        of_surface[film.surface] = &film;
    fill(matrix, [&](std::size_t surface, const Point& point) {
        const auto& film = *of_surface[surface];
        const double at = value_at(point.shape, values);
        return heat::film_slope(film.law(at), film.emissivity, at, film.surroundings);
    });
}

void FilmPoints::build_constant(const std::vector<double>& coefficients, Mat matrix) const
{
    fill(matrix, [&](std::size_t surface, const Point&) { return coefficients[surface]; });
}

// b of a surface; returns c_i [W/m2/K].
double FilmPoints::build_room_load(std::size_t surface, const double* values, Vec load) const
{
    DEADPOINT_PETSC(VecSet(load, 0));
    for (const auto& point : points_[surface])
        add_values(load, point.shape, point.weight * heat::film_slope({}, 1, value_at(point.shape, values), 0));
    assemble(load);
    double sum = 0;
    DEADPOINT_PETSC(VecSum(load, &sum));
    DEADPOINT_PETSC(VecScale(load, 1 / sum));
    prescribed_.clear(load);
    return sum / surface_area_[surface];
}

void FilmPoints::build_room(std::size_t index, const double* values)
{
    auto& room = rooms_[index];
    const std::size_t count = room.surfaces.size();
    std::vector<double> slope(count, 0.0);
    for (std::size_t i = 0; i < count; ++i)
        slope[i] = build_room_load(room.surfaces[i], values, room.loads[i]);
    room.coupling.resize(count * count);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j)
            room.coupling[i * count + j] =
                std::sqrt(slope[i] * slope[j]) * problem_->radiation[index].exchange[i * count + j];
}

void FilmPoints::forget_rooms()
{
    for (auto& room : rooms_)
        room.coupling.clear();
}

void FilmPoints::multiply_rooms(double factor, Vec in, Vec out) const
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
                received[i] -= factor * room.coupling[i * loads.size() + j] * products[j];
        DEADPOINT_PETSC(VecMAXPY(out, count, received.data(), const_cast<Vec*>(loads.data())));
    }
}

}  // namespace deadpoint::fem
