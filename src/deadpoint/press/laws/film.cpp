#include "deadpoint/press/laws/film.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/surroundings/paper_film.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string_view>
#include <variant>

namespace deadpoint::press {
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

std::string film_path(const MeshSurface& surface) { return fmt::format("surfaces.{}.film", surface.name); }

/// A surface and its convection, with all data that the law may need.
struct SurfacePlace {
    const casefile::Film& film;
    const Machine& machine;
    const MeshSurface& surface;
    const LoadsResult* loads;
};

double needed_length(const SurfacePlace& at, const std::optional<double>& given, const std::optional<double>& derived,
                     const char* key, const char* meaning)
{
    if (given)
        return *given;
    if (derived)
        return *derived;
    std::string_view law = casefile::law_name(at.film);
    constexpr std::string_view printed = "paper_";
    if (law.starts_with(printed))
        law.remove_prefix(printed.size());
    throw mistake(
        film_path(at.surface),
        fmt::format("law = \"{}\" needs `{}`, {}; it does not follow from this surface's geometry", law, key, meaning),
        fmt::format("add {} = \"500 mm\", or split the surface", key));
}

double height(const SurfacePlace& at, const std::optional<double>& given,
              const char* meaning = "its height (else that of a surface on one part)")
{
    return needed_length(at, given, at.surface.figures.height, "length", meaning);
}

void set_film(SurfaceFilm& result, const SurfacePlace&, const casefile::FilmCoefficient& film)
{
    result.constant = film.value.value_or(0);
}

void set_film(SurfaceFilm& result, const SurfacePlace&, const casefile::PaperFilm& film)
{
    result.constant = film.of == casefile::PaperFilm::Of::frame ? surroundings::paper_frame_coefficient
                                                                : surroundings::paper_crankshaft_coefficient;
}

void set_film(SurfaceFilm& result, const SurfacePlace& at, const casefile::PlateFilm& film)
{
    using Facing = casefile::PlateFilm::Facing;
    result.as_printed = film.as_printed;
    auto& air = result.air;
    if (film.facing == Facing::sideways) {
        air.natural = NaturalFlow::vertical;
        air.natural_length = height(at, film.length);
        return;
    }
    air.natural = film.facing == Facing::up ? NaturalFlow::facing_up : NaturalFlow::facing_down;
    air.natural_length = needed_length(at, film.length, at.surface.figures.area_over_perimeter, "length",
                                       "area over perimeter (else that of a single plane)");
}

void set_film(SurfaceFilm& result, const SurfacePlace& at, const casefile::RoundFilm& film)
{
    using Form = casefile::RoundFilm::Form;
    const bool disk = film.form == Form::rotating_disk;
    const auto& figures = at.surface.figures;
    const auto& derived = disk ? figures.disk_diameter : figures.cylinder_diameter;
    result.as_printed = film.as_printed;
    auto& air = result.air;
    air.natural = disk ? NaturalFlow::vertical : NaturalFlow::horizontal_cylinder;
    air.natural_length =
        needed_length(at, film.diameter, derived, "diameter",
                      disk ? "of the disk (else that of the cylinder around its plane)" : "of one cylinder");
    if (film.form == Form::cylinder)
        return;
    air.forced = disk ? ForcedFlow::rotating_disk : ForcedFlow::rotating_cylinder;
    air.forced_length = air.natural_length;
    result.speed_per_turn = 1;
}

void set_film(SurfaceFilm& result, const SurfacePlace& at, const casefile::MovingFilm& film)
{
    auto& air = result.air;
    air.natural = NaturalFlow::vertical;
    air.natural_length = height(at, film.length, "along its motion (else the height of a surface on one part)");
    air.forced = ForcedFlow::moving_plate;
    air.forced_length = air.natural_length;
    if (film.speed) {
        result.running_speed = *film.speed;
        return;
    }
    if (!at.loads)
        throw mistake(film_path(at.surface),
                      "law = \"moving\" needs the speed of the body, and there are no loads to take it from",
                      "add speed = \"0.5 m/s\" (root mean square), or describe the linkage with its driver and slide "
                      "body");
    result.speed_per_turn = rms_speed(at.machine, at.surface, *at.loads) / at.loads->speed;
}

void set_film(SurfaceFilm& result, const SurfacePlace& at, const casefile::EnclosedFilm& film)
{
    result.air.natural = NaturalFlow::vertical;
    result.air.natural_length = height(at, film.length);
    result.exchange = film.exchange / (at.machine.half_model ? 2 : 1);
}

int body_in_linkage(const Machine& machine, const MeshSurface& surface, const LoadsResult& loads)
{
    const auto body_at = [&](const SurfaceShare& share) -> const std::string& {
        return machine.parts[share.part].body;
    };
    const auto& shares = surface.figures.parts;
    if (shares.empty())
        throw mistake("surfaces." + surface.name, "it has no faces left in the air");
    const std::string& body = body_at(shares.front());
    for (const auto& share : shares)
        if (body_at(share) != body)
            throw mistake(
                film_path(surface),
                fmt::format("it lies on the bodies '{}' and '{}', which move differently", body, body_at(share)),
                "split the surface, or add `speed`");
    const auto found = std::ranges::find(loads.linkage.bodies, body);
    const auto index = static_cast<int>(found - loads.linkage.bodies.begin());
    if (found == loads.linkage.bodies.end() || index == loads.linkage.ground)
        throw mistake(film_path(surface), fmt::format("body '{}' does not move with the linkage", body),
                      "take law = \"vertical\", or add `speed`");
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
    if (constant) {
        const double value = *constant * growth.factor(crank_speed);
        return {{"constant film", {{"coefficient", value}}}, [value](double) -> FilmLaw {
                    return [value](double) { return LawValue{value, 0, true}; };
                }};
    }
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
    const auto law = casefile::law_name(film);
    result.law = law.empty() ? "given" : law;
    if (film.with_speed) {
        result.growth = *film.with_speed;
        result.speed_per_turn = 1;
    }
    const SurfacePlace at{film, machine, surface, loads};
    std::visit([&](const auto& given) { set_film(result, at, given); }, film.law);
    return result;
}

// |v|^2 of a point of the body is |t'|^2 + 2 w t' . n + w^2 |X|^2, with n = (-y, x) of the turned arm R X.
double rms_speed(const Machine& machine, const MeshSurface& surface, const LoadsResult& loads)
{
    const auto& moments = surface.figures.moments;
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

}  // namespace deadpoint::press
