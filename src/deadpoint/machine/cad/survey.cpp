#include "deadpoint/machine/cad/survey.hpp"

#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/machine/cad/identity.hpp"
#include "deadpoint/machine/cad/read_cad.hpp"
#include "deadpoint/machine/parts/cell_limit.hpp"
#include "deadpoint/observer.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace deadpoint::machine {
namespace {

constexpr double too_long = 100;     // [m]
constexpr double very_long = 20;     // [m]
constexpr double very_short = 1e-3;  // [m]

/// Files that several parts share are read once.
class Drawings {
public:
    explicit Drawings(Observer& observer) : observer_(observer) {}
    const CadModel& of(const std::string& part, const StepSource& source)
    {
        const auto [place, fresh] = known_.try_emplace({source.path, source.unit.value_or(0)});
        if (fresh) {
            const auto waiting = [&](double seconds) {
                observer_.progress(0, fmt::format("reading {}, for {:.0f} s", source.path, seconds));
            };
            try {
                place->second = read_cad(part, source.path, source.unit, waiting);
            } catch (...) {
                known_.erase(place);
                throw;
            }
        }
        return place->second;
    }

private:
    Observer& observer_;
    std::map<std::pair<std::string, double>, CadModel> known_;
};

/// The solids that a part is made of, with the unit and scale of their file.
CadModel part_of(const PartDescription& part, const StepSource& source, const CadModel& file, Observer& observer)
{
    std::vector<SolidIdentity> solids;
    for (const CadSolid& solid : file.solids) {
        solids.push_back({solid.called, solid.name, solid.fingerprint});
    }
    const ChosenSolids chosen = chosen_solids(part.name, source, solids);
    if (!chosen.doubt.empty()) {
        observer.warn(chosen.doubt);
    }
    CadModel result{file.unit, file.scale, {}, {}};
    for (const std::size_t i : chosen.solids) {
        result.solids.push_back(file.solids[i]);
    }
    return result;
}

void check_size(const PartDescription& part, const CadModel& solids, Observer& observer)
{
    const double length = extent(solids);
    const std::string says =
        solids.unit.empty() ? "its file says no unit" : fmt::format("its file says {}", solids.unit);
    const std::string suspect = solids.scale == 1
                                    ? fmt::format("{}; if that is wrong, state `unit`, such as unit = \"1 mm\"", says)
                                    : "check `unit`, the length of one unit of the file";
    if (length > too_long) {
        throw InputError(fmt::format("part '{}' is {:.0f} m long\n  help: {}", part.name, length, suspect));
    }
    if (length > very_long || length < very_short) {
        observer.warn(fmt::format("part '{}' is {:.4g} mm long: {}", part.name, 1e3 * length, suspect));
    }
}

void check_part(const MachineDescription& description, const PartDescription& part, const CadModel& solids,
                Observer& observer)
{
    if (solids.scale != 1) {
        observer.warn(
            fmt::format("part '{}': `unit` makes it {:.6g} times as large as its file says, which has the unit {}",
                        part.name, solids.scale, solids.unit.empty() ? "millimetre by default" : solids.unit));
    }
    check_size(part, solids, observer);
    double volume = 0;
    for (const CadSolid& solid : solids.solids) {
        volume += solid.volume;
    }
    const double size = (part.size > 0 ? part.size : description.size) * description.size_scale;
    check_cell_count(part.name, about_tetrahedra(volume, size), size, observer);
}

}  // namespace

void survey_drawings(const MachineDescription& description, Mistakes& mistakes, Observer& observer)
{
    Drawings drawings(observer);
    for (const PartDescription& part : description.parts) {
        if (const auto* source = std::get_if<StepSource>(&part.source)) {
            mistakes.attempt("parts." + part.name, [&] {
                check_part(description, part, part_of(part, *source, drawings.of(part.name, *source), observer),
                           observer);
            });
        }
    }
}

}  // namespace deadpoint::machine
