#include "deadpoint/press.hpp"

#include "deadpoint/api/full/press_parts.hpp"
#include "deadpoint/api/full/result_writer.hpp"
#include "deadpoint/api/twin/diagnostics.hpp"
#include "deadpoint/api/twin/listener.hpp"
#include "deadpoint/api/twin/results.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/problem/heat_tables.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/result/run_result.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace deadpoint {
namespace {

MeshFigures figures_of(const Machine& machine)
{
    MeshFigures figures{machine.cells.size(), machine.nodes.size(), machine.half_model, {}};
    for (const auto& part : machine.parts)
        figures.parts.push_back({part.name, part.body, part.cell_count});
    return figures;
}

}  // namespace

int segment_of(const casefile::Case& input, int wanted, bool needs_speed)
{
    const auto count = static_cast<int>(input.operation.size());
    if (wanted >= count || wanted < -1)
        throw InputError("there is no segment " + std::to_string(wanted) + "\n  help: the operation has " +
                         std::to_string(count) + ", counted from 0");
    if (wanted >= 0)
        return wanted;
    const int running = press::first_running_segment(input);
    if (running < 0 && needs_speed)
        throw InputError("the press runs in no segment of [[operation]]\n  help: give one a speed");
    return std::max(0, running);
}

void require_session()
{
    if (!fem::is_open())
        throw InputError("no Session is open\n  help: make a deadpoint::Session at the start of main() and keep it to "
                         "its end");
}

Press Press::read(const std::filesystem::path& file, const ReadOptions& options)
{
    require_scale(options.size_scale);
    auto read = read_with_diagnostics(file, options);
    if (!read.errors.empty())
        throw CaseError(read.errors, std::move(read.diagnostics));
    return Press(std::make_unique<Implementation>(Implementation{full::Press(std::move(read.value), options.size_scale),
                                                                 file, options, std::move(read.diagnostics),
                                                                 std::move(read.warnings), std::move(read.files)}));
}

std::vector<Diagnostic> Press::check(const std::filesystem::path& file, const ReadOptions& options)
{
    require_scale(options.size_scale);
    auto read = read_with_diagnostics(file, options);
    if (!read.errors.empty())
        return read.diagnostics;
    Observer silent;
    full::Press press(read.value, options.size_scale);
    return check_press(read, press, silent);
}

Press::Press(std::unique_ptr<Implementation> implementation) : implementation_(std::move(implementation)) {}
Press::~Press() = default;
Press::Press(Press&&) noexcept = default;
Press& Press::operator=(Press&&) noexcept = default;

const std::string& Press::name() const { return implementation_->press.input().machine.name; }

const std::vector<Diagnostic>& Press::warnings() const { return implementation_->warnings; }

std::string Press::case_text() const { return casefile::write_case(implementation_->press.input()); }

MeshFigures Press::mesh(Observer* observer)
{
    ObserverOrNone to(observer);
    return figures_of(implementation_->press.machine(to.get()));
}

LoadsResult Press::loads(int segment, Observer* observer)
{
    ObserverOrNone to(observer);
    auto& press = implementation_->press;
    return public_loads(press.loads(segment_of(press.input(), segment, true), to.get()));
}

HeatTables Press::heat_tables(int segment, Observer* observer)
{
    ObserverOrNone to(observer);
    auto& press = implementation_->press;
    return public_tables(press.heat_tables(segment_of(press.input(), segment, false), to.get()));
}

RunResult Press::run(const RunOptions& options, Observer* observer)
{
    require_session();
    ObserverOrNone to(observer);
    Listener listener(to.get());
    auto& press = implementation_->press;
    ResultWriter writer(options, implementation_->inputs);
    const auto result = writer.run(press, implementation_->reading, listener);
    return public_run(press.input(), result, listener.warnings, writer.folder());
}

}  // namespace deadpoint
