#include "deadpoint/reduce/online/reduced_run.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/heat_causes.hpp"
#include "deadpoint/heat/adjoint.hpp"
#include "deadpoint/heat/run.hpp"
#include "deadpoint/reduce/online/dense_system.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace deadpoint::reduce {
namespace {

States start_of(const DenseTerms& terms, const HeatProblem& problem)
{
    States start = States::Zero(terms.uniform.size());
    for (Eigen::Index p = 0; p < terms.parts.cols(); ++p)
        start += problem.initial_temperature(static_cast<int>(p), {}) * terms.parts.col(p);
    return start;
}

}  // namespace

struct ReducedRun::Parts {
    Parts(std::shared_ptr<const PreparedTerms> terms, const HeatProblem& problem, std::size_t adjoints,
          double reference_)
        : system(std::move(terms), problem, reference_),
          run(system, problem, adjoints, static_cast<std::size_t>(system.parts().observed.rows()) - adjoints),
          reference(reference_)
    {}
    DenseSystem system;
    heat::HeatRun<DenseSystem> run;
    std::optional<heat::HeatAdjoint<DenseSystem>> adjoint;
    double reference;
};

ReducedRun::ReducedRun(std::shared_ptr<const PreparedTerms> terms, const HeatProblem& problem, std::size_t adjoints,
                       double reference)
    : parts_(std::make_unique<Parts>(std::move(terms), problem, adjoints, reference))
{
    parts_->run.temperature() = start_of(parts_->system.parts(), problem);
    std::vector<double> sumps, enclosures;
    for (const auto& circuit : problem.oil)
        sumps.push_back(circuit.sump_start);
    for (const auto& enclosure : problem.enclosures)
        enclosures.push_back(enclosure.start);
    parts_->run.set_media(std::move(sumps), enclosures);
}
ReducedRun::~ReducedRun() = default;
ReducedRun::ReducedRun(ReducedRun&&) noexcept = default;

const ThermalHistory& ReducedRun::go(const ReducedHooks& hooks, Observer& observer)
{
    auto& run = parts_->run;
    heat::RunHooks<States> inner;
    inner.on_step = [&](double time) {
        if (hooks.on_step)
            hooks.on_step(time, run.temperature());
        auto& stepper = run.stepper();
        if (hooks.on_stages)
            hooks.on_stages(run.steps().back(), stepper.before().temperature, stepper.middle().temperature,
                            run.temperature());
    };
    inner.on_field = hooks.on_field;
    run.begin();
    return run.go(inner, observer);
}

std::shared_ptr<const TridiagonalForm> ReducedRun::tridiagonal() const { return parts_->system.tridiagonal(); }

HeatCauses ReducedRun::causes(const States& weights, std::size_t row)
{
    auto& adjoint = parts_->adjoint;
    if (!adjoint)
        adjoint.emplace(parts_->run, parts_->reference);
    adjoint->weights() = weights;
    return adjoint->causes(row);
}

}  // namespace deadpoint::reduce
