#include "deadpoint/full/model/prepare.hpp"

#include "deadpoint/casefile/describe/findings.hpp"
#include "deadpoint/casefile/files/case_source.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/machine/assembly/build.hpp"
#include "deadpoint/machine/assembly/measure.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/check/check_machine.hpp"
#include "deadpoint/press/check/plausibility.hpp"
#include "deadpoint/press/machine/machine.hpp"
#include "deadpoint/press/machine/model_part.hpp"
#include "deadpoint/press/problem/deformation_mesh.hpp"
#include "deadpoint/press/problem/heat.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>

namespace deadpoint::full {
namespace {

bool apart(const std::optional<BoxShape>& a, const std::optional<BoxShape>& b)
{
    constexpr double rounding = 1e-9;
    for (std::size_t i = 0; a && b && i < 3; ++i)
        if (a->max[i] < b->min[i] + rounding || b->max[i] < a->min[i] + rounding)
            return true;
    return false;
}

// Which surfaces claim a face, and which share of it they claim together. Boxes that meet share the faces between them.
class Claims {
public:
    Claims(const casefile::Case& input, const Machine& machine, Mistakes& mistakes)
        : input_(input), machine_(machine), mistakes_(mistakes)
    {}
    void add(const MeshSurface& surface)
    {
        for (const auto& entry : surface.faces) {
            auto& [names, share] = claims_[entry.face];
            for (const auto& other : names)
                if (!apart(input_.surfaces.at(other).within, input_.surfaces.at(surface.name).within))
                    claimed_twice(entry.face, other, surface.name);
            names.push_back(surface.name);
            share += entry.fraction;
        }
    }
    [[nodiscard]] double share(std::uint32_t face) const
    {
        const auto found = claims_.find(face);
        return found == claims_.end() ? 0 : found->second.share;
    }

private:
    void claimed_twice(std::uint32_t face, const std::string& first, const std::string& second)
    {
        mistakes_.add("surfaces." + second,
                      fmt::format("surfaces.{} and surfaces.{} both claim a face of part '{}'", first, second,
                                  machine_.parts[machine_.faces[face].part].name),
                      "narrow one of them with 'within' or 'parts'");
    }

    struct Claim {
        std::vector<std::string> names;
        double share = 0;
    };
    const casefile::Case& input_;
    const Machine& machine_;
    Mistakes& mistakes_;
    std::map<std::uint32_t, Claim> claims_;
};

// Gives an exposed surface the shares of faces that no other surface claims.
void leave_unclaimed(const Machine& machine, const Claims& claims, MeshSurface& surface)
{
    constexpr double rounding = 1e-9;
    for (auto& entry : surface.faces)
        entry.fraction *= std::max(0.0, 1 - claims.share(entry.face));
    std::erase_if(surface.faces, [](const SurfaceFace& entry) { return entry.fraction < rounding; });
    surface.area = 0;
    for (const auto& entry : surface.faces)
        surface.area += entry.fraction * face_area(machine, machine.faces[entry.face]);
    surface.figures = machine::figures_of(machine, surface);
}

void settle_claims(const casefile::Case& input, Machine& machine, Mistakes& mistakes)
{
    using Select = casefile::Surface::Select;
    Claims by_place(input, machine, mistakes), by_exposure(input, machine, mistakes);
    for (const auto& surface : machine.surfaces) {
        const auto& description = input.surfaces.at(surface.name);
        if (press::has_condition(description))
            (description.select == Select::exposed ? by_exposure : by_place).add(surface);
    }
    for (auto& surface : machine.surfaces) {
        const auto& description = input.surfaces.at(surface.name);
        if (description.select == Select::exposed && press::has_condition(description))
            leave_unclaimed(machine, by_place, surface);
    }
}

/// Area of the whole faces that a surface takes by their middles [m2].
double area_by_middles(const Machine& machine, const MeshSurface& surface)
{
    double area = 0;
    for (const auto& entry : surface.faces)
        area += entry.central ? face_area(machine, machine.faces[entry.face]) : 0;
    return area;
}

// A temperature, a foot or a face of the dimension chain goes by nodes, and so by whole faces.
void require_middles(const casefile::Case& input, const Machine& machine, Mistakes& mistakes, Observer& observer)
{
    constexpr double worth_a_word = 0.01;
    for (const auto& surface : machine.surfaces) {
        const auto& own = input.surfaces.at(surface.name);
        if (own.film || own.heat_flux || own.insulated)
            continue;
        const double held = area_by_middles(machine, surface);
        if (held == 0)
            mistakes.add("surfaces." + surface.name,
                         "no face has its centre in the box, and a condition at nodes applies to whole faces",
                         "correct the box, or make the cells there smaller");
        else if (own.temperature || !own.temperature_formula.empty())
            if (std::abs(held - surface.area) > worth_a_word * surface.area)
                observer.warn(
                    fmt::format("surfaces.{}: the temperature is prescribed on whole faces, {:.4g} cm2, but the box "
                                "has {:.4g} cm2; end the box where cells end, or make the cells smaller",
                                surface.name, 1e4 * held, 1e4 * surface.area));
    }
}

// Passes progress to another observer, without repeating its stages and warnings.
class Repeated : public Observer {
public:
    explicit Repeated(Observer& to) : to_(to) {}
    void progress(double fraction, std::string_view detail) override { to_.progress(fraction, detail); }
    [[nodiscard]] bool cancelled() const override { return to_.cancelled(); }

private:
    Observer& to_;
};

/// What is wrong with the mesh of the deformation alone, since that of the heat was made before.
CaseError of_deformation(const CaseError& error, double scale)
{
    auto found = error.diagnostics();
    for (auto& diagnostic : found) {
        diagnostic.message = fmt::format("in the mesh of the deformation, with cells {:.2f} times as large as those of "
                                         "the heat: {}",
                                         scale, diagnostic.message);
        diagnostic.help = "choose numerics.deformation_size nearer to 1";
    }
    return {fmt::format("the mesh of the deformation, with cells {:.2f} times as large as those of the heat:\n{}\n  "
                        "help: choose numerics.deformation_size nearer to 1",
                        scale, error.what()),
            std::move(found)};
}

}  // namespace

Machine mesh_machine(const casefile::Case& input, double size_scale, Observer& observer, Mistakes& mistakes,
                     MeshedParts* kept)
{
    if (input.parts.empty())
        throw mistake("parts", "the case has no [parts]: there is nothing to mesh",
                      "add the solids of its bodies; motion and forces of the linkage alone are computed by 'deadpoint "
                      "loads'");
    const auto part = press::model_part(input);
    auto machine = machine::build_machine(press::describe_machine(part, size_scale), observer, kept);
    settle_claims(part, machine, mistakes);
    require_middles(part, machine, mistakes, observer);
    return machine;
}

void check_on_machine(const casefile::Case& input, const Machine& machine, double size_scale, Observer& observer,
                      Mistakes& mistakes)
{
    mistakes.attempt("probes", [&] { press::require_probes_on_parts(input, machine); });
    mistakes.attempt("surfaces", [&] {
        for (const auto& warning : press::cold_formulas(input, machine))
            observer.warn(warning);
    });
    mistakes.raise();
    auto questions = press::loose_bodies(machine);
    std::ranges::move(press::question_machine(input, machine, size_scale), std::back_inserter(questions));
    for (const auto& warning : casefile::placed_warnings(input, questions))
        observer.warn(warning);
}

Machine prepare_machine(const casefile::Case& input, double size_scale, Observer& observer)
{
    Mistakes mistakes;
    auto machine = mesh_machine(input, size_scale, observer, mistakes);
    check_on_machine(input, machine, size_scale, observer, mistakes);
    return machine;
}

std::optional<Machine> prepare_deformation_machine(const casefile::Case& input, double size_scale,
                                                   const Machine& machine, Observer& observer)
{
    const auto part = press::model_part(input);
    const double scale = press::deformation_scale(part, machine);
    const auto own = press::case_of_deformation(part);
    const bool alike = press::describe_orders(own, machine) == press::describe_orders(part, machine);
    if (!part.chain || (scale == 1 && alike))
        return std::nullopt;
    observer.stage("mesh of the deformation");
    Repeated quiet(observer);
    try {
        auto coarse = machine::build_machine(press::describe_machine(own, size_scale * scale), quiet);
        Mistakes mistakes;
        settle_claims(part, coarse, mistakes);
        mistakes.raise();
        return coarse;
    } catch (const CaseError& error) {
        throw of_deformation(error, scale);
    }
}

}  // namespace deadpoint::full
