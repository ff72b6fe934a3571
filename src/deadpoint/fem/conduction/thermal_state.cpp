#include "deadpoint/fem/conduction/thermal_state.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/fem/space/discretisation.hpp"
#include "deadpoint/fem/space/fields.hpp"
#include "deadpoint/fem/space/file_order.hpp"
#include "deadpoint/io/binary_file.hpp"
#include "deadpoint/io/write_file.hpp"

#include <cmath>
#include <fmt/format.h>
#include <string_view>

namespace deadpoint::fem {
namespace {

constexpr std::string_view state_kind = "deadpoint-thermal-state-2\n";
constexpr const char* state_help = "name the folder of a finished run with --from, or compute that run again";

std::string heading(const Discretisation& space, const ThermalState& like)
{
    const auto text = fmt::format("{} sumps {}", mesh_text(space), like.sumps.size());
    return like.enclosures.empty() ? text : fmt::format("{} enclosures {}", text, like.enclosures.size());
}

std::vector<double> read(BinaryReader& in, std::size_t count, const std::string& file)
{
    std::vector<double> values;
    in(values);
    if (values.size() != count)
        in.refuse(fmt::format("it holds {} temperatures where {} are due", values.size(), count));
    for (const double value : values)
        if (!std::isfinite(value) || value <= 0)
            throw DomainError(fmt::format("{} holds a temperature of {} K, which no part can have\n  help: {}", file,
                                          value, state_help));
    return values;
}

}  // namespace

void write_thermal_state(const std::string& file, const Discretisation& space, const ThermalState& state)
{
    const auto all = gather_all(space, state.temperature.owned, 1);
    std::string error;
    if (rank() == 0) {
        try {
            std::vector<double> ordered;
            for (const auto unknown : order_of_file(space))
                ordered.push_back(all[unknown]);
            write_file(file, [&](std::ostream& out) {
                BinaryWriter writer(out, state_kind);
                writer(heading(space, state), state.sumps, state.enclosures, ordered);
                writer.finish();
            });
        } catch (const IoError& reason) {
            error = reason.what();
        }
    }
    error = from_first_rank(error);
    if (!error.empty())
        throw IoError(error);
}

ThermalState read_thermal_state(const std::string& file, const Discretisation& space, const ThermalState& like)
{
    BinaryReader in(file, state_kind, state_help);
    const auto wanted = heading(space, like);
    std::string found;
    in(found);
    if (found != wanted)
        throw InputError(fmt::format(
            "{} belongs to another mesh, element order or set of oil circuits and enclosures\n  it is:  {}\n  "
            "wanted: {}\n  help: start from a run of the same parts at the same --size",
            file, found, wanted));
    ThermalState state;
    state.sumps = read(in, like.sumps.size(), file);
    state.enclosures = read(in, like.enclosures.size(), file);
    const auto order = order_of_file(space);
    const auto values = read(in, order.size(), file);
    state.temperature.owned = share_of_file(space, order, values);
    return state;
}

}  // namespace deadpoint::fem
