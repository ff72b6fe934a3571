#include "deadpoint/fem/thermal_state.hpp"

#include "deadpoint/core/error.hpp"
#include "deadpoint/core/write_file.hpp"
#include "deadpoint/fem/file_order.hpp"
#include "deadpoint/fem/session.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <sstream>

namespace deadpoint::fem {
namespace {

constexpr const char* kind = "deadpoint-thermal-state-1";

std::string heading(const Discretisation& space, const ThermalState& like)
{
    const auto text = fmt::format("{} {} sumps {}", kind, mesh_text(space), like.sumps.size());
    return like.enclosures.empty() ? text : fmt::format("{} enclosures {}", text, like.enclosures.size());
}

void write(std::ostream& out, const std::vector<double>& values)
{
    out.write(reinterpret_cast<const char*>(values.data()),
              static_cast<std::streamsize>(values.size() * sizeof(double)));
}

std::vector<double> read(std::istream& in, std::size_t count, const std::string& file)
{
    std::vector<double> values(count);
    in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(double)));
    if (in.gcount() != static_cast<std::streamsize>(count * sizeof(double)))
        throw IoError(fmt::format("{} is cut short; start from a complete result folder", file));
    for (const double value : values)
        if (!std::isfinite(value))
            throw DomainError(fmt::format("{} holds a temperature that is not finite", file));
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
                out << heading(space, state) << '\n';
                write(out, state.sumps);
                write(out, state.enclosures);
                write(out, ordered);
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
    std::ifstream in(file, std::ios::binary);
    const auto wanted = heading(space, like);
    std::string line(wanted.size() + 4096, '\0');  // room for that of another machine, not for any file
    in.getline(line.data(), std::ssize(line));
    line.resize(line.find('\0'));
    if (!in || line.rfind(kind, 0) != 0)
        throw IoError(fmt::format("{} is not a temperature state\n  help: name the folder of a finished run, which "
                                  "holds state.bin",
                                  file));
    if (line != wanted)
        throw InputError(fmt::format(
            "{} belongs to another mesh, element order or set of oil circuits and enclosures\n  it is:  {}\n  "
            "wanted: {}\n  help: start from a run of the same parts at the same --size",
            file, line, wanted));
    ThermalState state;
    state.sumps = read(in, like.sumps.size(), file);
    state.enclosures = read(in, like.enclosures.size(), file);
    const auto order = order_of_file(space);
    const auto values = read(in, order.size(), file);
    state.temperature.owned = share_of_file(space, order, values);
    return state;
}

}  // namespace deadpoint::fem
