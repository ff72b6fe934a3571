#include "deadpoint/full/run/press.hpp"

#include "deadpoint/casefile/files/case_source.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/stopwatch.hpp"
#include "deadpoint/full/model/prepare.hpp"
#include "deadpoint/full/run/reduce.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/machine/model_part.hpp"
#include "deadpoint/press/problem/heat_tables.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/twin/model/reduction.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace deadpoint::full {
namespace {

void pass_on(const std::vector<std::string>& warnings, Observer& observer)
{
    for (const auto& warning : warnings)
        observer.warn(warning);
}

/// Passes everything on and keeps the warnings.
class Keeper : public Observer {
public:
    Keeper(Observer& to, std::vector<std::string>& kept) : to_(to), kept_(kept) {}
    void stage(std::string_view name) override { to_.stage(name); }
    void progress(double fraction, std::string_view detail) override { to_.progress(fraction, detail); }
    void info(std::string_view text) override { to_.info(text); }
    void warn(std::string_view text) override
    {
        kept_.emplace_back(text);
        to_.warn(text);
    }
    [[nodiscard]] bool cancelled() const override { return to_.cancelled(); }

private:
    Observer& to_;
    std::vector<std::string>& kept_;
};

/// Adds the wall time of its lifetime to a sum.
class LifetimeTimer {
public:
    explicit LifetimeTimer(double& sum) : sum_(sum) {}
    ~LifetimeTimer() { sum_ += seconds_since(start_); }
    LifetimeTimer(const LifetimeTimer&) = delete;
    LifetimeTimer& operator=(const LifetimeTimer&) = delete;

private:
    double& sum_;
    Clock::time_point start_ = Clock::now();
};

}  // namespace

Press::Press(casefile::Case input, double size_scale) : input_(std::move(input)), size_scale_(size_scale) {}
Press::~Press() = default;
Press::Press(Press&&) noexcept = default;

Press& Press::operator=(Press&& other) noexcept
{
    model_.reset();  // it refers to the meshes
    input_ = std::move(other.input_);
    size_scale_ = other.size_scale_;
    machine_ = std::move(other.machine_);
    deformed_ = std::move(other.deformed_);
    model_ = std::move(other.model_);
    mesh_warnings_ = std::move(other.mesh_warnings_);
    mesh_seconds_ = other.mesh_seconds_;
    meshed_ = other.meshed_;
    return *this;
}

void Press::take(casefile::Case input)
{
    if (machine_ && press::model_key(input) != press::model_key(input_)) {
        drop_model();
        machine_.reset();
        deformed_.reset();
        meshed_ = false;
        mesh_seconds_ = 0;
    }
    input_ = std::move(input);
}

const Machine& Press::machine(Observer& observer, MeshedParts* kept)
{
    casefile::with_places(input_, [&] {
        Mistakes mistakes;
        if (machine_) {
            pass_on(mesh_warnings_, observer);
            check_on_machine(input_, *machine_, size_scale_, observer, mistakes);
            return;
        }
        const LifetimeTimer timer(mesh_seconds_);
        mesh_warnings_.clear();
        Keeper keeper(observer, mesh_warnings_);
        auto meshed = std::make_unique<Machine>(mesh_machine(input_, size_scale_, keeper, mistakes, kept));
        check_on_machine(input_, *meshed, size_scale_, observer, mistakes);
        machine_ = std::move(meshed);
    });
    return *machine_;
}

void Press::mesh(Observer& observer)
{
    const auto& machine = this->machine(observer);
    if (meshed_)
        return;
    const LifetimeTimer timer(mesh_seconds_);
    Keeper keeper(observer, mesh_warnings_);
    casefile::with_places(input_, [&] {
        if (auto own = prepare_deformation_machine(input_, size_scale_, machine, keeper))
            deformed_ = std::make_unique<Machine>(*std::move(own));
    });
    meshed_ = true;
}

press::LoadsResult Press::loads(int segment, Observer& observer)
{
    return casefile::with_places(input_, [&] {
        const Machine* parts = press::loads_need_machine(input_) ? &machine(observer) : machine_.get();
        observer.stage("loads");
        auto loads = press::compute_loads(input_, parts, segment);
        for (const auto& warning : loads.warnings)
            observer.warn(warning.text);
        return loads;
    });
}

press::HeatTables Press::heat_tables(int segment, Observer& observer)
{
    return casefile::with_places(input_, [&] {
        const Machine* parts = input_.parts.empty() ? nullptr : &machine(observer);
        std::optional<press::LoadsResult> of_operation;
        if (const int running = press::first_running_segment(input_); running >= 0 && press::has_loads(input_))
            of_operation = loads(running, observer);
        auto tables = press::heat_tables(input_, parts, of_operation ? &*of_operation : nullptr, segment);
        pass_on(tables.warnings, observer);
        return tables;
    });
}

void Press::check(Observer& observer)
{
    if (!input_.parts.empty())
        casefile::with_places(input_, [&] { model(observer).check(input_, observer); });
    else if (const int segment = press::first_running_segment(input_); segment >= 0)
        loads(segment, observer);
}

SharedModel& Press::model(Observer& observer)
{
    mesh(observer);
    if (!model_)
        model_ = std::make_unique<SharedModel>(*machine_, deformed_.get());
    return *model_;
}

void Press::prepare(Observer& observer)
{
    casefile::with_places(input_, [&] { model(observer).prepare(input_, observer); });
}

press::RunResult Press::run(const RunOptions& options, Observer& observer)
{
    return casefile::with_places(input_, [&] { return model(observer).run(input_, options, observer); });
}

std::optional<twin::Reduction> Press::reduce(const ReduceOptions& options, Observer& observer)
{
    auto result = casefile::with_places(input_, [&] { return model(observer).reduce(input_, options, observer); });
    if (result)
        result->small.size_scale = result->large.size_scale = size_scale_;
    return result;
}

void Press::lift(const std::string& file, const twin::ReducedStates& run, const press::FieldOptions& options,
                 press::RunResult& result, Observer& observer)
{
    casefile::with_places(input_, [&] { model(observer).lift(input_, file, run, options, result, observer); });
}

void Press::drop_model() { model_.reset(); }

}  // namespace deadpoint::full
