#include "deadpoint/study/laws/film.hpp"

#include "deadpoint/core/error.hpp"
#include "deadpoint/study/laws/surface_geometry.hpp"
#include "deadpoint/surroundings/paper_film.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::study {
namespace {

using surroundings::ForcedFlow;
using surroundings::NaturalFlow;

const MeshSurface& find_surface(const Machine& machine, const std::string& name)
{
    const auto found = std::ranges::find(machine.surfaces, name, &MeshSurface::name);
    if (found == machine.surfaces.end())
        throw InputError(fmt::format("there is no surface '{}' in the mesh", name));
    return *found;
}

double needed_length(const std::optional<double>& given, const std::optional<double>& derived, const char* key,
                     const char* meaning, const casefile::Film& film, const std::string& surface)
{
    if (given)
        return *given;
    if (derived)
        return *derived;
    throw InputError(fmt::format("surfaces.{}.film: law = \"{}\" needs `{}`, {}; it does not follow from this "
                                 "surface's geometry\n  help: add {} = \"500 mm\", or split the surface",
                                 surface, film.law, key, meaning, key));
}

double height(const casefile::Film& film, const Machine& machine, const MeshSurface& surface)
{
    return needed_length(film.length, height_of(machine, surface), "length",
                         film.law == "moving" ? "along its motion (else the height of a surface on one part)"
                                              : "its height (else that of a surface on one part)",
                         film, surface.name);
}

double diameter(const casefile::Film& film, const Machine& machine, const MeshSurface& surface)
{
    const bool disk = film.law == "rotating_disk";
    return needed_length(
        film.diameter, disk ? disk_diameter(machine, surface) : cylinder_diameter(machine, surface), "diameter",
        disk ? "of the disk (else that of the cylinder around its plane)" : "of one cylinder", film, surface.name);
}

void set_moving(SurfaceFilm& result, const casefile::Film& film, const Machine& machine, const MeshSurface& surface,
                const LoadsResult* loads)
{
    result.air.forced = ForcedFlow::moving_plate;
    result.air.forced_length = result.air.natural_length;
    if (film.speed) {
        result.running_speed = *film.speed;
        return;
    }
    if (!loads)
        throw InputError(fmt::format("surfaces.{}.film: law = \"moving\" needs the speed of the body, and there are no "
                                     "loads to take it from\n  help: add speed = \"0.5 m/s\" (root mean square), or "
                                     "describe the linkage with its driver and slide body",
                                     surface.name));
    result.speed_per_turn = rms_speed(machine, surface, *loads) / loads->speed;
}

void set_flow(SurfaceFilm& result, const casefile::Film& film, const Machine& machine, const MeshSurface& surface,
              const LoadsResult* loads)
{
    auto& air = result.air;
    if (film.law == "horizontal_up" || film.law == "horizontal_down") {
        air.natural = film.law == "horizontal_up" ? NaturalFlow::facing_up : NaturalFlow::facing_down;
        air.natural_length = needed_length(film.length, area_over_perimeter(machine, surface), "length",
                                           "area over perimeter (else that of a single plane)", film, surface.name);
        return;
    }
    const bool round = film.law == "cylinder" || film.law == "rotating_cylinder";
    const bool turns = film.law == "rotating_cylinder" || film.law == "rotating_disk";
    air.natural = round ? NaturalFlow::horizontal_cylinder : NaturalFlow::vertical;
    air.natural_length = round || turns ? diameter(film, machine, surface) : height(film, machine, surface);
    if (turns) {
        air.forced = round ? ForcedFlow::rotating_cylinder : ForcedFlow::rotating_disk;
        air.forced_length = air.natural_length;
        result.speed_per_turn = 1;
    } else if (film.law == "moving") {
        set_moving(result, film, machine, surface, loads);
    } else if (film.law == "enclosed") {
        result.exchange = film.exchange.value_or(0) / (machine.half_model ? 2 : 1);
    }
}

int body_in_linkage(const Machine& machine, const MeshSurface& surface, const LoadsResult& loads)
{
    const auto body_at = [&](const SurfaceFace& entry) -> const std::string& {
        return machine.parts[machine.faces[entry.face].part].body;
    };
    if (surface.faces.empty())
        throw InputError(fmt::format("surfaces.{}: it has no faces left in the air", surface.name));
    const std::string& body = body_at(surface.faces.front());
    for (const auto& entry : surface.faces)
        if (body_at(entry) != body)
            throw InputError(fmt::format("surfaces.{}.film: it lies on the bodies '{}' and '{}', which move "
                                         "differently\n  help: split the surface, or add `speed`",
                                         surface.name, body, body_at(entry)));
    const auto found = std::ranges::find(loads.linkage.bodies, body);
    const auto index = static_cast<int>(found - loads.linkage.bodies.begin());
    if (found == loads.linkage.bodies.end() || index == loads.linkage.ground)
        throw InputError(fmt::format("surfaces.{}.film: body '{}' does not move with the linkage\n  help: take law = "
                                     "\"vertical\", or add `speed`",
                                     surface.name, body));
    return index;
}

}  // namespace

double SurfaceFilm::speed_at(double crank_speed) const
{
    if (running_speed)
        return crank_speed != 0 ? *running_speed : 0;
    return speed_per_turn * std::abs(crank_speed);
}

FilmLawAt SurfaceFilm::law_at(double crank_speed) const
{
    if (constant)
        return {{"constant film", {{"coefficient", *constant}}}, [value = *constant](double) -> FilmLaw {
                    return [value](double) { return LawValue{value, 0, true}; };
                }};
    auto moved = air;
    moved.speed = speed_at(crank_speed);
    auto formula = surroundings::formula_of(moved);
    if (as_printed) {
        formula.name += ", as the paper prints it";
        return {formula, [moved](double ambient) { return surroundings::paper_film_law(moved, ambient); }};
    }
    if (!exchange)
        return {formula, [moved](double ambient) { return surroundings::film_law(moved, ambient); }};
    formula.name += ", of enclosed air";
    formula.parameters.insert(formula.parameters.end(), {{"area", area}, {"exchange", *exchange}});
    return {formula, [moved, size = area, into_room = *exchange](double ambient) {
                return surroundings::enclosed_film(surroundings::film_law(moved, ambient), size, into_room);
            }};
}

SurfaceFilm surface_film(const casefile::Film& film, const Machine& machine, const std::string& name,
                         const LoadsResult* loads)
{
    const MeshSurface& surface = find_surface(machine, name);
    SurfaceFilm result;
    result.surface = name;
    result.area = surface.area;
    result.law = film.law.empty() ? "given" : film.law;
    if (film.law.empty()) {
        result.constant = film.coefficient.value_or(0);
    } else if (film.law == "paper") {
        result.constant = film.constant == "frame" ? surroundings::paper_frame_coefficient
                                                   : surroundings::paper_crankshaft_coefficient;
    } else {
        constexpr std::string_view printed = "paper_";
        result.as_printed = film.law.starts_with(printed);
        auto plain = film;
        if (result.as_printed)
            plain.law = film.law.substr(printed.size());
        set_flow(result, plain, machine, surface, loads);
    }
    return result;
}

// |v|^2 of a point of the body is |t'|^2 + 2 w t' . n + w^2 |X|^2, with n = (-y, x) of the turned arm R X.
double rms_speed(const Machine& machine, const MeshSurface& surface, const LoadsResult& loads)
{
    const auto moments = plane_moments(machine, surface);
    const auto& history = loads.history;
    const auto& body = history.bodies.at(static_cast<std::size_t>(body_in_linkage(machine, surface, loads)));
    double sum = 0, time = 0;
    for (std::size_t i = 0; i < history.time.size(); ++i) {
        const double c = std::cos(body.pose[i].angle), s = std::sin(body.pose[i].angle);
        const Vec2 arm{c * moments.mean[0] - s * moments.mean[1], s * moments.mean[0] + c * moments.mean[1]};
        const Vec2 velocity = body.velocity[i].translation;
        const double turn = body.velocity[i].angle;
        const double square = dot(velocity, velocity) + 2 * turn * dot(velocity, Vec2{-arm[1], arm[0]}) +
                              turn * turn * moments.mean_square;
        const double next = i + 1 < history.time.size() ? history.time[i + 1] : history.period;
        const double before = i > 0 ? history.time[i - 1] : history.time.back() - history.period;
        sum += 0.5 * (next - before) * square;
        time += 0.5 * (next - before);
    }
    return std::sqrt(sum / time);
}

}  // namespace deadpoint::study
