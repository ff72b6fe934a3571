#include "deadpoint/calibration/identify.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/casefile/studies/calibration_file.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/twin/calibrate/calibrate.hpp"
#include "deadpoint/twin/calibrate/calibration_figures.hpp"
#include "deadpoint/twin/calibrate/measured_runs.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace deadpoint::twin {

using casefile::CalibrationCandidate;
using casefile::CalibrationRun;
using casefile::MeasuredCurve;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double poor = 0.1;  // shrinkage below which the data tell nearly nothing

/// Adds up what planned runs tell, by the whitened Jacobian at the prior's centre.
class Planning {
public:
    Planning(const casefile::CalibrationFile& file, const ReducedPress& press, const OtherPresses& others, int threads,
             Observer& observer)
        : file_(file), observer_(observer), runs_(file, press, others, threads, observer)
    {}

    CalibrationPlan run()
    {
        observer_.stage("what the planned runs can tell");
        plan_.name = file_.name;
        plan_.note = file_.note;
        plan_.notes = file_.notes;
        plan_.level = file_.options.level;
        const auto& input = runs_.runs().front().model->input();
        plan_.case_name = input.machine.name;
        plan_.case_hash = casefile::case_hash(input);
        const auto problem = runs_.problem(false);
        for (const auto& run : runs_.runs())
            plan_.runs += !run.run->hold_out && !run.curves.empty() ? 1 : 0;
        plan_.values = static_cast<std::size_t>(problem.starts().back());
        const auto known = calibration::identify(problem.parameters, jacobian_of(problem));
        covariance_ = known.covariance;
        plan_.combinations = as_data(known.combinations, false);
        take_parameters(known);
        observer_.stage("candidates");
        for (const auto& candidate : candidates())
            add_gain(candidate);
        std::ranges::stable_sort(plan_.candidates, std::ranges::greater{}, &CandidateGain::information);
        return std::move(plan_);
    }

private:
    static MatrixXd jacobian_of(const calibration::Problem& problem)
    {
        const auto at = problem.model(VectorXd::Zero(static_cast<Index>(problem.parameters.size())), true);
        return calibration::whiten_columns(problem, at.jacobian);
    }

    void take_parameters(const calibration::Identifiability& known)
    {
        plan_.parameters = runs_.unknowns();
        const double wide = quantile_of(plan_.level);
        for (Index k = 0; k < covariance_.rows(); ++k) {
            auto& p = plan_.parameters[static_cast<std::size_t>(k)];
            p.estimate = value_of(p, 0);
            p.deviation = std::sqrt(covariance_(k, k));
            p.lower = value_of(p, -wide * p.deviation);
            p.upper = value_of(p, wide * p.deviation);
            p.prior_lower = value_of(p, -wide * p.prior);
            p.prior_upper = value_of(p, wide * p.prior);
            p.expected = p.shrinkage = known.shrinkage[k];
            p.known = knowledge_of(p.shrinkage, false);
            p.influence = known.influence[k];
            if (p.shrinkage < poor && static_cast<std::size_t>(k) < runs_.case_parameters())
                warn(fmt::format("{}: the planned runs hardly determine '{}' ({:.0f} % of its variance)", p.place,
                                 p.name, 100 * p.shrinkage));
        }
    }

    void warn(std::string text)
    {
        observer_.warn(text);
        plan_.warnings.push_back(std::move(text));
    }

    // Those of the file; without any, each output that a sensor could measure and that no run measures.
    [[nodiscard]] std::vector<CalibrationCandidate> candidates() const
    {
        if (!file_.candidates.empty())
            return file_.candidates;
        std::set<std::string> measured;
        for (const auto& run : file_.runs)
            for (const auto& curve : run.curves)
                measured.insert(curve.output);
        std::vector<CalibrationCandidate> result;
        for (const auto& output : runs_.runs().front().model->outputs()) {
            const bool usual = output.kind == ForwardOutput::Kind::probe || output.name == "E_SW";
            if (usual && !measured.contains(output.name) && sensor_for(output) < file_.sensors.size())
                result.push_back({"sensor at " + output.name, "", {}, {output.name}, nullptr, {}});
        }
        return result;
    }

    // A sensor of the file for an output: one that names it, else the first of its kind.
    [[nodiscard]] std::size_t sensor_for(const ForwardOutput& output) const
    {
        const bool gap = output.kind == ForwardOutput::Kind::dimension;
        for (std::size_t s = 0; s < file_.sensors.size(); ++s)
            if ((file_.sensors[s].dimension == Dimension::length) == gap)
                return s;
        return file_.sensors.size();
    }

    [[nodiscard]] CalibrationRun run_of(const CalibrationRun& like, const std::vector<std::string>& measure) const
    {
        CalibrationRun run = like;
        run.curves.clear();
        const ModelledRun modelled = runs_.modelled(run);
        const double end = run.until.value_or(modelled.model->end()), interval = run.interval.value_or(600);
        const auto count =
            std::clamp<std::size_t>(static_cast<std::size_t>(end / interval), 1, casefile::most_values_of_curve);
        for (const auto& output : modelled.model->outputs()) {
            if (std::ranges::find(measure, output.name) == measure.end())
                continue;
            MeasuredCurve curve{
                output.name, output.name, output.kind == ForwardOutput::Kind::dimension, false, sensor_for(output), {},
                {},          {}};
            for (std::size_t k = 1; k <= count; ++k)
                curve.time.push_back(end * static_cast<double>(k) / static_cast<double>(count));
            run.curves.push_back(std::move(curve));
        }
        return run;
    }

    [[nodiscard]] std::vector<std::string> all_measured() const
    {
        std::set<std::string> names;
        for (const auto& run : file_.runs)
            for (const auto& curve : run.curves)
                names.insert(curve.output);
        return {names.begin(), names.end()};
    }

    void add_gain(const CalibrationCandidate& candidate)
    {
        std::vector<CalibrationRun> added;
        if (!candidate.set.empty()) {
            CalibrationRun run;
            run.name = candidate.name;
            run.input = candidate.input;
            run.alternatives = candidate.alternatives;
            added.push_back(run_of(run, candidate.measure.empty() ? all_measured() : candidate.measure));
        } else {
            for (const auto& run : file_.runs)
                if (candidate.run.empty() ? !run.hold_out : run.name == candidate.run)
                    added.push_back(run_of(run, candidate.measure));
        }
        MatrixXd rows(0, covariance_.rows());
        for (const auto& run : added) {
            const auto modelled = runs_.modelled(run);
            const MatrixXd more = jacobian_of(runs_.problem_of(modelled));
            MatrixXd both(rows.rows() + more.rows(), rows.cols());
            both << rows, more;
            rows = std::move(both);
        }
        take_gain(candidate.name, rows);
    }

    void take_gain(const std::string& name, const MatrixXd& rows)
    {
        CandidateGain gain;
        gain.name = name;
        gain.information = calibration::information(covariance_, rows);
        const MatrixXd after = (covariance_.inverse() + rows.transpose() * rows).inverse();
        double least = 2;
        for (Index k = 0; k < static_cast<Index>(runs_.case_parameters()); ++k) {
            const double ratio = std::sqrt(after(k, k) / covariance_(k, k));
            if (ratio < least) {
                least = ratio;
                gain.most_about = plan_.parameters[static_cast<std::size_t>(k)].name;
                gain.deviation_before = std::sqrt(covariance_(k, k));
                gain.deviation_after = std::sqrt(after(k, k));
            }
        }
        plan_.candidates.push_back(std::move(gain));
    }

    const casefile::CalibrationFile& file_;
    Observer& observer_;
    MeasuredRuns runs_;
    MatrixXd covariance_;
    CalibrationPlan plan_;
};

}  // namespace

std::optional<CalibrationPlan> plan_calibration(const casefile::CalibrationFile& file, const ReducedPress& press,
                                                const OtherPresses& others, int threads, Observer& observer)
try {
    return Planning(file, press, others, threads, observer).run();
} catch (const Stopped&) {
    return std::nullopt;
}

}  // namespace deadpoint::twin
