#include "deadpoint/fem/conduction/heat_checkpoint.hpp"

#include "deadpoint/core/hash.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/fem/algebra/vectors.hpp"
#include "deadpoint/fem/conduction/checkpoint.hpp"
#include "deadpoint/fem/conduction/stage_matrix.hpp"
#include "deadpoint/fem/space/discretisation.hpp"
#include "deadpoint/fem/space/file_order.hpp"
#include "deadpoint/heat/run.hpp"
#include "deadpoint/heat/run_state.hpp"
#include "deadpoint/io/binary_file.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/observer.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace deadpoint::fem {
namespace {

constexpr std::string_view checkpoint_kind = "deadpoint-checkpoint-3\n";
constexpr const char* remedy = "start the run anew without --resume, with --force to replace what is there";
// The time between two checkpoints is at least this many times the duration of the last one.
constexpr double least_pause = 50;

// The temperatures of a state, in the order of files.
std::string hash_of(const std::vector<double>& field, const std::vector<std::size_t>& order, const ThermalState& state)
{
    StableHash hash;
    const auto add = [&](double value) { hash.add({reinterpret_cast<const char*>(&value), sizeof value}); };
    for (const auto unknown : order)
        add(field[unknown]);
    for (const auto* values : {&state.sumps, &state.enclosures})
        std::ranges::for_each(*values, add);
    return fmt::format("{:016x}", hash.value());
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

// Why a run does not begin with the operation that led to a checkpoint; empty if it does.
std::string other_beginning(const RunMark& of_file, double time, const RunMark& run)
{
    double start = 0;
    for (std::size_t i = 0; i < of_file.segments.size(); ++i) {
        if (i >= run.segments.size())
            return fmt::format("it ran through {} segments; this operation has {}", of_file.segments.size(),
                               run.segments.size());
        if (of_file.segments[i] != run.segments[i])
            return fmt::format("operation.{} differs in more than its duration", i);
        const bool reached = time <= start + of_file.durations[i];
        if (reached ? start + run.durations[i] < time : run.durations[i] != of_file.durations[i])
            return fmt::format("operation.{}.duration was {:g} s and is {:g} s now", i, of_file.durations[i],
                               run.durations[i]);
        if (reached)
            return {};
        start += of_file.durations[i];
    }
    return {};
}

}  // namespace

double RunMark::end() const { return std::accumulate(durations.begin(), durations.end(), 0.0); }

BinaryReader open_checkpoint(const std::string& file, const RunMark& run, CheckpointHead& head)
{
    BinaryReader reader(file, checkpoint_kind, remedy);
    reader(head);
    if (head.version != version)
        throw InputError(fmt::format("'{}' is a checkpoint of version {}; this is {}\n  help: {}", file, head.version,
                                     version, remedy));
    if (head.run.durations.size() != head.run.segments.size())
        reader.refuse("its operation is incomplete");
    if (head.run.apart_from_operation != run.apart_from_operation)
        throw InputError(fmt::format("'{}' is a checkpoint of another case: its hash is {}, that of this one {}\n  "
                                     "help: give the same case file and --set as before, or {}",
                                     file, head.run.case_hash, run.case_hash, remedy));
    if (const auto reason = other_beginning(head.run, head.time, run); !reason.empty())
        throw InputError(fmt::format("'{}' was reached by another operation: {}\n  help: leave the operation as it was "
                                     "up to t = {:.2f} h, or {}",
                                     file, reason, head.time / 3600, remedy));
    return reader;
}

CheckpointHead checkpoint_head(const std::string& file, const RunMark& run)
{
    CheckpointHead head;
    open_checkpoint(file, run, head);
    return head;
}

HeatCheckpoint::HeatCheckpoint(heat::HeatRun<HeatSystem>& run, const CheckpointPlan& plan, const ThermalState& start,
                               Observer& observer)
    : run_(run), space_(run.system().space()), plan_(plan), observer_(observer), order_(order_of_file(space_)),
      last_(std::chrono::steady_clock::now())
{
    start_ = hash_of(gather_all(space_, start.temperature.owned, 1), order_, start);
}

bool HeatCheckpoint::due() const
{
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - last_;
    int answer = plan_.interval == 0 || passed.count() >= std::max(plan_.interval, least_pause * cost_) ? 1 : 0;
    MPI_Bcast(&answer, 1, MPI_INT, 0, PETSC_COMM_WORLD);
    return answer != 0;
}

void HeatCheckpoint::offer(bool now)
{
    if (plan_.file.empty() || std::isinf(plan_.interval) || (kept_ && !now) || (!due() && !now))
        return;
    const auto begin = std::chrono::steady_clock::now();
    write_on_first(plan_.file, "the run goes on without a new checkpoint");
    last_ = std::chrono::steady_clock::now();
    cost_ = std::chrono::duration<double>(last_ - begin).count();
}

void HeatCheckpoint::keep()
{
    if (plan_.kept_file.empty())
        return;
    write_on_first(plan_.kept_file, "the results cannot be prolonged");
    kept_ = true;
}

// The first rank gathers the data of the others.
void HeatCheckpoint::write_on_first(const std::string& file, const char* without) const
{
    std::ostream nowhere(nullptr);
    bool begun = false;
    if (rank() == 0) {
        try {
            write_file(
                file,
                [&](std::ostream& out) {
                    begun = true;
                    write(out);
                },
                Durability::synced);
        } catch (const IoError& error) {
            observer_.warn(fmt::format("{}: {}", without, first_line(error.what())));
        }
    }
    if (!begun)
        write(nowhere);
}

// The start of a step, and the data from which the preconditioner was built.
std::vector<Vec> HeatCheckpoint::vectors() const
{
    std::vector<Vec> result;
    for (const OwnedVec* vector : run_.vectors())
        result.push_back(*vector);
    if (const Vec origin = run_.system().stage().preconditioner_temperature())
        result.push_back(origin);
    return result;
}

template <class Value>
void HeatCheckpoint::write_field(BinaryWriter& writer, std::span<const Value> owned) const
{
    const auto all = gather_all(space_, {owned.begin(), owned.end()}, 1);
    std::vector<Value> ordered;
    ordered.reserve(order_.size());
    for (const auto unknown : order_)
        ordered.push_back(static_cast<Value>(all[unknown]));
    writer(ordered);
}

void HeatCheckpoint::write(std::ostream& out) const
{
    BinaryWriter writer(out, checkpoint_kind);
    const auto state = run_.state();
    writer(CheckpointHead{std::string(version), plan_.run, mesh_text(space_), start_, state.place.time, plan_.fields});
    writer(state);
    const auto rows = static_cast<std::size_t>(space_.last - space_.first);
    for (const Vec vector : vectors()) {
        const ConstEntries values(vector);
        write_field(writer, std::span<const double>(values.data(), rows));
    }
    for (const auto& field : plan_.handed_on ? plan_.handed_on() : std::vector<HandedField>{}) {
        writer(field.time, field.owned.index() == 0);
        std::visit([&](const auto& owned) { write_field(writer, owned); }, field.owned);
    }
    writer.finish();
}

template <class Value>
Field HeatCheckpoint::read_field(BinaryReader& reader) const
{
    std::vector<Value> values;
    reader(values);
    if (values.size() != order_.size())
        reader.refuse("a field in it has another number of unknowns");
    if (!std::ranges::all_of(values, [](Value value) { return std::isfinite(value); }))
        reader.refuse("a field in it holds a value that is no finite number");
    return {share_of_file(space_, order_, values)};
}

void HeatCheckpoint::restore(const FieldCallback& on_field)
{
    CheckpointHead head;
    auto reader = open_checkpoint(plan_.from, plan_.run, head);
    if (const auto mesh = mesh_text(space_); head.mesh != mesh)
        throw InputError(fmt::format("'{}' belongs to another mesh\n  it is:  {}\n  wanted: {}\n  help: give the same "
                                     "--size and files as before, or {}",
                                     plan_.from, head.mesh, mesh, remedy));
    if (head.start != start_)
        throw InputError(fmt::format("'{}' belongs to a run from other temperatures\n  help: give the same --from as "
                                     "before, or {}",
                                     plan_.from, remedy));
    heat::RunState state;
    reader(state);
    if (const auto reason = heat::misfit(state, run_.state(), run_.problem()); !reason.empty())
        reader.refuse(reason);
    auto& stage = run_.system().stage();
    if (run_.system().follows_temperature())
        stage.prepare_preconditioner_temperature(run_.temperature());
    for (const Vec vector : vectors())
        std::ranges::copy(read_field<double>(reader).owned, Entries(vector).data());
    make_preconditioner(state.origin);
    run_.restore(state);
    hand_on_again(reader, state.place.next_field, on_field);
}

// Rebuilds the former multigrid hierarchy. One of the present matrix would also solve, but not to the same bits.
void HeatCheckpoint::make_preconditioner(const heat::PreconditionerOrigin& origin)
{
    if (origin.factor <= 0)
        return;
    auto& system = run_.system();
    auto& sources = run_.sources();
    sources.enter(run_.problem().segments[origin.segment]);
    OwnedVec temperature = system.make_vector();
    const Vec followed = system.stage().preconditioner_temperature();
    DEADPOINT_PETSC(VecCopy(followed ? followed : Vec(run_.temperature()), temperature));
    system.build(origin.factor, temperature, sources.films.following(origin.time, origin.air));
}

void HeatCheckpoint::hand_on_again(BinaryReader& reader, std::size_t count, const FieldCallback& on_field) const
{
    for (std::size_t i = 0; i < count; ++i) {
        double time = 0;
        bool exact = false;
        reader(time, exact);
        if (time != run_.problem().field_times[i])
            reader.refuse("its fields are not at the times of this case");
        const auto field = exact ? read_field<double>(reader) : read_field<float>(reader);
        if (on_field)
            on_field(time, field);
    }
}

}  // namespace deadpoint::fem
