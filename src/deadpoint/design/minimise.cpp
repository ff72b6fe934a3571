#include "deadpoint/design/minimise.hpp"

#include <algorithm>
#include <cmath>
#include <nlopt.hpp>
#include <optional>

namespace deadpoint::design {
namespace {

nlopt::algorithm algorithm_of(MinimiseMethod method)
{
    switch (method) {
    case MinimiseMethod::ccsa:
        return nlopt::LD_CCSAQ;
    case MinimiseMethod::cobyla:
        return nlopt::LN_COBYLA;
    default:
        return nlopt::LD_SLSQP;
    }
}

std::string words_of(nlopt::result result)
{
    switch (result) {
    case nlopt::FTOL_REACHED:
        return "the objective no longer changed";
    case nlopt::XTOL_REACHED:
        return "the variables no longer changed";
    case nlopt::MAXEVAL_REACHED:
        return "the number of evaluations was reached";
    case nlopt::FORCED_STOP:
        return "it was stopped";
    case nlopt::ROUNDOFF_LIMITED:
        return "rounding allowed no further progress";
    default:
        return "it ended";
    }
}

double exceeded_by(const Evaluation& found)
{
    double most = 0;
    for (const double limit : found.limits)
        most = std::max(most, limit);
    return most;
}

/// Evaluates points for NLopt, which asks for objective and limits one after the other.
class Search {
public:
    Search(const MinimiseProblem& problem, const MinimiseOptions& options)
        : problem_(problem), options_(options),
          optimiser_(algorithm_of(options.method), static_cast<unsigned>(problem.variables))
    {}

    Minimum run(const Point& start)
    {
        optimiser_.set_lower_bounds(0);
        optimiser_.set_upper_bounds(1);
        optimiser_.set_min_objective(&Search::value, this);
        if (problem_.limits > 0)
            optimiser_.add_inequality_mconstraint(&Search::limits, this,
                                                  std::vector<double>(problem_.limits, options_.kept_within));
        optimiser_.set_maxeval(options_.most_evaluations);
        optimiser_.set_ftol_rel(options_.tolerance);
        optimiser_.set_xtol_abs(options_.tolerance);
        if (options_.method == MinimiseMethod::cobyla)
            optimiser_.set_initial_step(0.2);
        result_.end = search(start);
        if (error_)
            std::rethrow_exception(error_);
        return std::move(result_);
    }

private:
    std::string search(Point at)
    {
        double value = 0;
        try {
            return words_of(optimiser_.optimize(at, value));
        } catch (const nlopt::roundoff_limited&) {
            return words_of(nlopt::ROUNDOFF_LIMITED);
        } catch (const nlopt::forced_stop&) {
            return words_of(nlopt::FORCED_STOP);
        } catch (const std::runtime_error&) {
            // SLSQP: its quadratic problem has no solution.
            return "the limits allowed no further step";
        }
    }

    const Evaluation& at(const Point& point, bool derivatives)
    {
        if (last_ && *last_ == point && (!derivatives || !found_.slope.empty()))
            return found_;
        if (problem_.stopped && problem_.stopped())
            optimiser_.force_stop();
        found_ = problem_.evaluate(point, derivatives || options_.method != MinimiseMethod::cobyla);
        last_ = point;
        take(point);
        return found_;
    }

    void take(const Point& point)
    {
        const double exceeded = exceeded_by(found_);
        const bool feasible = exceeded <= 2 * options_.kept_within;
        const bool better =
            result_.steps.empty() || (feasible && !result_.feasible) ||
            (feasible == result_.feasible && (feasible ? found_.value < result_.value : exceeded < least_exceeded_));
        result_.steps.push_back({point, found_.value, exceeded});
        if (!better)
            return;
        result_.at = point;
        result_.value = found_.value;
        result_.feasible = feasible;
        least_exceeded_ = exceeded;
    }

    // No exception may pass through NLopt's C code; the first one ends the search.
    template <class Work>
    void guarded(Work&& work)
    {
        try {
            work();
        } catch (...) {
            if (!error_)
                error_ = std::current_exception();
            optimiser_.force_stop();
        }
    }

    static double value(const std::vector<double>& point, std::vector<double>& slope, void* self)
    {
        auto& search = *static_cast<Search*>(self);
        double result = HUGE_VAL;
        search.guarded([&] {
            const auto& found = search.at(point, !slope.empty());
            if (!slope.empty())
                std::ranges::copy(found.slope, slope.begin());
            result = found.value;
        });
        return result;
    }

    static void limits(unsigned count, double* values, unsigned variables, const double* point, double* slopes,
                       void* self)
    {
        auto& search = *static_cast<Search*>(self);
        std::fill_n(values, count, 0.0);
        search.guarded([&] {
            const auto& found = search.at(Point(point, point + variables), slopes != nullptr);
            std::ranges::copy(found.limits, values);
            for (std::size_t k = 0; slopes != nullptr && k < count; ++k)
                std::ranges::copy(found.slopes[k], slopes + k * variables);
        });
    }

    const MinimiseProblem& problem_;
    const MinimiseOptions& options_;
    nlopt::opt optimiser_;
    std::optional<Point> last_;
    Evaluation found_;
    Minimum result_;
    double least_exceeded_ = 0;
    std::exception_ptr error_;
};

}  // namespace

Minimum minimise(const MinimiseProblem& problem, const Point& start, const MinimiseOptions& options)
{
    return Search(problem, options).run(start);
}

const char* name_of(MinimiseMethod method)
{
    switch (method) {
    case MinimiseMethod::ccsa:
        return "ccsa";
    case MinimiseMethod::cobyla:
        return "cobyla";
    default:
        return "slsqp";
    }
}

}  // namespace deadpoint::design
