#include "deadpoint/fem/conduction/heat_checkpoint.hpp"

#include "deadpoint/core/version.hpp"
#include "deadpoint/fem/space/file_order.hpp"
#include "deadpoint/fem/space/session.hpp"
#include "deadpoint/io/write_file.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint {

constexpr auto members(const Series*) { return std::tuple{&Series::value, &Series::rate}; }
constexpr auto members(const OilHistory*)
{
    return std::tuple{&OilHistory::inlet, &OilHistory::outlet, &OilHistory::sump, &OilHistory::heat,
                      &OilHistory::cooler};
}
constexpr auto members(const EnclosureHistory*)
{
    return std::tuple{&EnclosureHistory::temperature, &EnclosureHistory::from_surfaces, &EnclosureHistory::power,
                      &EnclosureHistory::to_room};
}
constexpr auto members(const EnergyBalance*)
{
    return std::tuple{&EnergyBalance::generated, &EnergyBalance::to_air, &EnergyBalance::to_oil,
                      &EnergyBalance::from_surfaces, &EnergyBalance::stored};
}
constexpr auto members(const ThermalHistory*)
{
    using History = ThermalHistory;
    return std::tuple{&History::time,
                      &History::probes,
                      &History::interface_a,
                      &History::interface_b,
                      &History::part_means,
                      &History::functionals,
                      &History::source_heat,
                      &History::source_temperature,
                      &History::to_air,
                      &History::to_oil,
                      &History::body_heat,
                      &History::oil,
                      &History::enclosures,
                      &History::contributions,
                      &History::energy,
                      &History::rejected_steps,
                      &History::law_out_of_range,
                      &History::film_out_of_range};
}

namespace fem {

constexpr auto members(const OilFlow*)
{
    return std::tuple{&OilFlow::inlet,           &OilFlow::outlet, &OilFlow::sump,  &OilFlow::sump_rate,
                      &OilFlow::sump_relaxation, &OilFlow::heat,   &OilFlow::cooler};
}
constexpr auto members(const AirFlow*)
{
    return std::tuple{&AirFlow::temperature, &AirFlow::from_surfaces, &AirFlow::power, &AirFlow::to_room};
}
constexpr auto members(const AirState*) { return std::tuple{&AirState::start, &AirState::slope, &AirState::now}; }
constexpr auto members(const StageRecord*)
{
    return std::tuple{
        &StageRecord::time,      &StageRecord::source_heat,     &StageRecord::body_heat, &StageRecord::oil_temperature,
        &StageRecord::film_mean, &StageRecord::variable_to_air, &StageRecord::air};
}
constexpr auto members(const StepRecord*)
{
    return std::tuple{&StepRecord::segment, &StepRecord::row,    &StepRecord::duration,
                      &StepRecord::start,   &StepRecord::middle, &StepRecord::end};
}
constexpr auto members(const HeatRate*)  // but for its vector
{
    return std::tuple_cat(members(static_cast<const StageRecord*>(nullptr)),
                          std::tuple{&HeatRate::source_slope, &HeatRate::source_temperature, &HeatRate::film,
                                     &HeatRate::oil, &HeatRate::generated, &HeatRate::to_air, &HeatRate::to_oil,
                                     &HeatRate::flux, &HeatRate::in_range, &HeatRate::films_untested});
}

/// The scalars of a solver between two steps, but for its rate.
struct HeatCheckpoint::Kept {
    double previous_dt = 0;
    bool have_previous = false;
    std::size_t next_field = 0;
    int iterations = 0;
    int solves = 0;
    std::vector<double> sump, oil_temperature, lowest, highest;
    std::vector<AirState> air;
    double multigrid_factor = -1;
    MultigridOrigin multigrid;

    /// What goes to the solver and back without a change.
    Carried as_it_is() { return {previous_dt, have_previous, next_field, iterations, solves, sump}; }

    friend constexpr auto members(const Kept*)
    {
        return std::tuple{&Kept::previous_dt, &Kept::have_previous, &Kept::next_field,       &Kept::iterations,
                          &Kept::solves,      &Kept::sump,          &Kept::oil_temperature,  &Kept::lowest,
                          &Kept::highest,     &Kept::air,           &Kept::multigrid_factor, &Kept::multigrid};
    }
};

namespace {

constexpr std::string_view kind = "deadpoint-checkpoint-1\n";
constexpr const char* remedy = "start the run anew without --resume, with --force to replace this file";
// The time between two checkpoints is at least this many times what the last one took.
constexpr double least_pause = 50;

template <class Value>
bool fits(const std::vector<Value>& read, const std::vector<Value>& like, std::size_t rows);

// Whether what was read has the lengths that belong to this problem. @param rows  of a column that has one in `like`
template <class Value>
bool fits(const Value& read, const Value& like, std::size_t rows)
{
    if constexpr (std::is_arithmetic_v<Value>)
        return true;
    else
        return std::apply([&](auto... member) { return (fits(read.*member, like.*member, rows) && ...); },
                          members(&read));
}

template <class Value>
bool fits(const std::vector<Value>& read, const std::vector<Value>& like, std::size_t rows)
{
    if constexpr (is_number<Value>)
        return read.size() == like.size() * rows;
    else if constexpr (std::is_same_v<Value, bool>)
        return read.size() == like.size();
    else
        return std::ranges::equal(read, like, [&](const Value& a, const Value& b) { return fits(a, b, rows); });
}

class Entries {
public:
    explicit Entries(Vec vector) : vector_(vector) { DEADPOINT_PETSC(VecGetArray(vector_, &values_)); }
    ~Entries() { VecRestoreArray(vector_, &values_); }
    Entries(const Entries&) = delete;
    double* values() { return values_; }

private:
    Vec vector_;
    double* values_ = nullptr;
};

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

}  // namespace

BinaryReader open_checkpoint(const std::string& file, const std::string& case_hash, CheckpointHead& head)
{
    BinaryReader reader(file, kind, remedy);
    reader(head);
    if (head.version != version)
        throw InputError(fmt::format("'{}' is a checkpoint of version {}; this is {}\n  help: {}", file, head.version,
                                     version, remedy));
    if (head.case_hash != case_hash)
        throw InputError(fmt::format("'{}' is a checkpoint of another case: its hash is {}, that of this one {}\n  "
                                     "help: give the same case file and --set as before, or {}",
                                     file, head.case_hash, case_hash, remedy));
    return reader;
}

HeatCheckpoint::HeatCheckpoint(HeatSolver& solver, const CheckpointPlan& plan, Observer& observer)
    : solver_(solver), plan_(plan), observer_(observer), order_(order_of_file(solver.space_)),
      last_(std::chrono::steady_clock::now())
{
    const auto state = solver_.state();
    start_ = hash_of(gather_all(solver_.space_, state.temperature.owned, 1), order_, state);
}

bool HeatCheckpoint::due() const
{
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - last_;
    int answer = plan_.interval == 0 || passed.count() >= std::max(plan_.interval, least_pause * cost_) ? 1 : 0;
    MPI_Bcast(&answer, 1, MPI_INT, 0, MPI_COMM_WORLD);
    return answer != 0;
}

void HeatCheckpoint::offer(const ThermalHistory& history, const RunPlace& place, bool now)
{
    if (std::isinf(plan_.interval) || (!due() && !now))
        return;
    const auto begin = std::chrono::steady_clock::now();
    std::ostream nowhere(nullptr);
    bool begun = false;
    if (rank() == 0) {
        try {
            write_file(
                plan_.file,
                [&](std::ostream& out) {
                    begun = true;
                    write(out, history, place);
                },
                Durability::synced);
        } catch (const IoError& error) {
            observer_.warn(fmt::format("the run goes on without a new checkpoint: {}", first_line(error.what())));
        }
    }
    if (!begun)  // the first rank gathers from the others
        write(nowhere, history, place);
    last_ = std::chrono::steady_clock::now();
    cost_ = std::chrono::duration<double>(last_ - begin).count();
}

HeatCheckpoint::Carried HeatCheckpoint::solvers_own() const
{
    return {solver_.previous_dt_, solver_.have_previous_, solver_.next_field_,
            solver_.iterations_,  solver_.solves_,        solver_.sump_};
}

HeatCheckpoint::Kept HeatCheckpoint::kept() const
{
    Kept kept;
    kept.as_it_is() = solvers_own();
    kept.oil_temperature = solver_.oil_temperature_;
    ThermalHistory extremes;
    solver_.extremes_of_ranks(extremes);
    kept.lowest = std::move(extremes.part_lowest);
    kept.highest = std::move(extremes.part_highest);
    kept.air = solver_.air_->between_steps();
    kept.multigrid_factor = solver_.multigrid_factor_;
    kept.multigrid = solver_.multigrid_origin_;
    return kept;
}

// What a step starts from.
std::vector<Vec> HeatCheckpoint::vectors() const
{
    std::vector<Vec> result{solver_.before_, solver_.now_, solver_.slope_before_, solver_.slope_now_,
                            solver_.rate_now_.vector};
    if (solver_.multigrid_temperature_)
        result.push_back(solver_.multigrid_temperature_);
    return result;
}

template <class Value>
void HeatCheckpoint::write_field(BinaryWriter& writer, std::span<const Value> owned) const
{
    const auto all = gather_all(solver_.space_, {owned.begin(), owned.end()}, 1);
    std::vector<Value> ordered;
    ordered.reserve(order_.size());
    for (const auto unknown : order_)
        ordered.push_back(static_cast<Value>(all[unknown]));
    writer(ordered);
}

void HeatCheckpoint::write(std::ostream& out, const ThermalHistory& history, const RunPlace& place) const
{
    BinaryWriter writer(out, kind);
    writer(CheckpointHead{std::string(version), plan_.case_hash, mesh_text(solver_.space_), start_, place.time});
    writer(place, kept(), history, solver_.steps_, solver_.rate_now_);
    const auto rows = static_cast<std::size_t>(solver_.space_.last - solver_.space_.first);
    for (const Vec vector : vectors())
        write_field(writer, std::span<const double>(Entries(vector).values(), rows));
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
    return {share_of_file(solver_.space_, order_, values)};
}

void HeatCheckpoint::restore(ThermalHistory& history, RunPlace& place, const FieldCallback& on_field)
{
    CheckpointHead head;
    auto reader = open_checkpoint(plan_.file, plan_.case_hash, head);
    if (const auto mesh = mesh_text(solver_.space_); head.mesh != mesh)
        throw InputError(fmt::format("'{}' belongs to another mesh\n  it is:  {}\n  wanted: {}\n  help: give the same "
                                     "--size and files as before, or {}",
                                     plan_.file, head.mesh, mesh, remedy));
    if (head.start != start_)
        throw InputError(fmt::format("'{}' belongs to a run from other temperatures\n  help: give the same --from as "
                                     "before, or {}",
                                     plan_.file, remedy));
    Kept kept;
    ThermalHistory past;
    std::vector<StepRecord> steps;
    HeatRate rate;
    reader(place, kept, past, steps, rate);
    check(reader, kept, place);
    const auto rows = past.time.size();
    const auto sound_step = [&](const StepRecord& step) {
        const StageRecord& like = solver_.rate_now_;
        return step.segment < solver_.problem_->segments.size() && step.row < rows && step.duration > 0 &&
               fits(step.start, like, 1) && fits(step.middle, like, 1) && fits(step.end, like, 1);
    };
    if (!fits(past, history, rows) || rows < place.segment_row + 2 || past.time.back() != place.time ||
        !fits(rate, solver_.rate_now_, 1) || !std::ranges::all_of(steps, sound_step))
        reader.refuse("its history is not one of this case");
    history = std::move(past);
    solver_.steps_ = std::move(steps);
    std::swap(rate.vector, solver_.rate_now_.vector);
    solver_.rate_now_ = std::move(rate);

    if (solver_.system_follows_temperature())
        solver_.multigrid_temperature_ = duplicate(solver_.now_);
    for (Vec vector : vectors())
        std::ranges::copy(read_field<double>(reader).owned, Entries(vector).values());
    solver_.store(solver_.now_, solver_.stored_now_);
    put_back(kept, place.segment);
    hand_on_again(reader, on_field);
}

// The lengths of all lists, and what the time steps would not end with otherwise.
void HeatCheckpoint::check(const BinaryReader& reader, const Kept& kept, const RunPlace& place) const
{
    const auto& segments = solver_.problem_->segments;
    const auto air = solver_.air_->count(), parts = solver_.lowest_.size();
    if (place.segment >= segments.size() || kept.multigrid.segment >= segments.size() ||
        kept.sump.size() != solver_.sump_.size() || kept.oil_temperature.size() != solver_.oil_temperature_.size() ||
        kept.lowest.size() != parts || kept.highest.size() != parts || kept.air.size() != air ||
        kept.multigrid.air.size() != air || kept.multigrid.slopes.size() != solver_.rate_now_.source_slope.size() ||
        kept.next_field > solver_.problem_->field_times.size())
        reader.refuse("its lists are not those of this case");
    double start = 0;
    for (std::size_t i = 0; i < place.segment; ++i)
        start += segments[i].duration;
    const bool in_segment =
        place.segment_start == start && place.time > start && place.time <= start + segments[place.segment].duration;
    if (!in_segment || !(place.wanted > 0) || !std::isfinite(place.wanted) || !(kept.previous_dt >= 0) ||
        !std::isfinite(kept.previous_dt) || !std::isfinite(kept.multigrid_factor))
        reader.refuse("its times are not those of this case");
}

// The multigrid hierarchy is built as it was: one of the present matrix would solve as well, but not to the same bits.
void HeatCheckpoint::put_back(Kept& kept, std::size_t segment)
{
    const auto& segments = solver_.problem_->segments;
    if (kept.multigrid_factor > 0) {
        solver_.enter_segment(segments[kept.multigrid.segment]);
        solver_.time_ = kept.multigrid.time;
        solver_.air_->start_from(kept.multigrid.air);
        solver_.shell_slopes_ = kept.multigrid.slopes;
        solver_.build_system(kept.multigrid_factor,
                             solver_.multigrid_temperature_ ? solver_.multigrid_temperature_ : solver_.now_);
        PC multigrid = nullptr;
        DEADPOINT_PETSC(KSPGetPC(solver_.solver_, &multigrid));
        DEADPOINT_PETSC(KSPSetUp(solver_.solver_));
        DEADPOINT_PETSC(PCApply(multigrid, solver_.now_, solver_.work_));  // some of it is set up by its first use
    }
    solver_.enter_segment(segments[segment]);
    solvers_own() = kept.as_it_is();
    if (!solver_.problem_->oil.empty())
        solver_.set_oil(kept.oil_temperature);
    solver_.lowest_ = kept.lowest;
    solver_.highest_ = kept.highest;
    solver_.air_->go_on_from(kept.air);
}

void HeatCheckpoint::hand_on_again(BinaryReader& reader, const FieldCallback& on_field) const
{
    for (std::size_t i = 0; i < solver_.next_field_; ++i) {
        double time = 0;
        bool exact = false;
        reader(time, exact);
        if (time != solver_.problem_->field_times[i])
            reader.refuse("its fields are not at the times of this case");
        const auto field = exact ? read_field<double>(reader) : read_field<float>(reader);
        if (on_field)
            on_field(time, field);
    }
}

void HeatSolver::note_multigrid(Vec temperature)
{
    if (!temperature)
        return;  // of the weights of causes, after all steps
    multigrid_origin_.segment = static_cast<std::size_t>(segment_ - problem_->segments.data());
    multigrid_origin_.time = time_;
    multigrid_origin_.air.clear();
    for (std::size_t k = 0; k < air_->count(); ++k)
        multigrid_origin_.air.push_back(air_->temperature(k));
    multigrid_origin_.slopes = shell_slopes_;
    if (!system_follows_temperature())
        return;
    if (!multigrid_temperature_)
        multigrid_temperature_ = duplicate(temperature);
    DEADPOINT_PETSC(VecCopy(temperature, multigrid_temperature_));
}

}  // namespace fem
}  // namespace deadpoint
