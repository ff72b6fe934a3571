#pragma once

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/heat_causes.hpp"
#include "deadpoint/heat/adjoint.hpp"
#include "deadpoint/heat/sources.hpp"
#include "deadpoint/heat/tr_bdf2.hpp"
#include "deadpoint/reduce/causes/projected_system.hpp"
#include "deadpoint/reduce/causes/search.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace deadpoint::reduce {

/// The adjoint of the steps of a finished run on a basis of a few fields, instead of in all unknowns.
///
/// With constant coefficients the weights of a functional l, at the time s before its own time, are exp(-s M^-1 K) M^-1
/// l. For all s up to the time t that has passed, a Krylov space of one shift approximates them at a rate that does not
/// depend on the mesh (van den Eshof and Hochbruck, SIAM J. Sci. Comput. 27, 2006):
///
///     (M + tau K)^-1 l,   (M + tau K)^-1 M of the field before, ...,   tau = t / 10
///
/// Where segments have other laws, such fields are added for each set of laws, with the weights at the end of its last
/// steps in place of l, and then once more, since those weights had come from a smaller basis. A set has fields enough
/// once two more of them no longer change the causes.
template <class System>
class ReducedAdjoint {
public:
    using Field = typename System::Vector;

    /// @param run  of a system without prescribed temperatures; it cannot continue afterwards
    ReducedAdjoint(System& system, const heat::FinishedRun<System>& run, double reference)
        : run_(run), reference_(reference), small_(system, run.sources.problem()),
          sources_(small_, run.sources.problem()), load_(system.make_vector())
    {
        system.begin_adjoint();
    }

    /// @param weights  value = sum of weight (T - T_reference)
    /// @param row  of the run's history: the time of the functional
    HeatCauses causes(const Field& weights, std::size_t row)
    {
        steps_ = run_.steps;
        while (!steps_.empty() && steps_.back().row > row)
            steps_ = steps_.first(steps_.size() - 1);
        find_stretches();
        CausesSearch search;
        for (std::size_t round = 0; round < std::min<std::size_t>(2, stretches_.size()); ++round)
            for (const auto& stretch : stretches_)
                extend(stretch, weights, search);
        if (!search.known())
            search.add(backward(steps_, weights, row).causes);
        return search.result(small_.size());
    }
    [[nodiscard]] int iterations() const { return small_.iterations(); }

private:
    using Small = ProjectedSystem<System>;
    /// The last steps with a set of laws.
    struct Stretch {
        std::size_t end = 0;  ///< number of steps up to its end
        double shift = 0;     ///< tau [s]
    };
    struct Backward {
        HeatCauses causes;
        typename Small::Vector weights;  ///< before the first of the steps
    };

    void find_stretches()
    {
        stretches_.clear();
        std::vector<const std::vector<InterfaceLaw>*> found;
        for (std::size_t end = steps_.size(); end > 0; --end) {
            const auto& step = steps_[end - 1];
            const auto& laws = laws_of(step);
            if (std::ranges::any_of(found, [&](const auto* other) { return conduct_alike(*other, laws); }))
                continue;
            found.push_back(&laws);
            const double passed = step.end.time - steps_.front().start.time;
            stretches_.push_back({end, passed / 10});
        }
    }
    [[nodiscard]] const std::vector<InterfaceLaw>& laws_of(const heat::StepRecord& step) const
    {
        const auto& problem = run_.sources.problem();
        const auto& own = problem.segments[step.segment].interfaces;
        return own.empty() ? problem.interfaces : own;
    }

    void extend(const Stretch& stretch, const Field& weights, CausesSearch& search)
    {
        const auto row = steps_.back().row;
        const bool at_end = stretch.end == steps_.size();
        if (!at_end)
            small_.load_of(backward(steps_.subspan(stretch.end), weights, row).weights, load_);
        std::size_t more = search.known() ? 2 : 6;
        for (bool first = true; search.wants_more(small_.size()) || first; more = 2) {
            make_adjoint(steps_).look_at(steps_[stretch.end - 1]);
            for (std::size_t k = 0; k < more; ++k, first = false) {
                if (!small_.enrich(stretch.shift, first && at_end ? weights : load_))
                    return;
                small_.load_of_last(load_);
            }
            search.add(backward(steps_, weights, row).causes);
        }
    }

    Backward backward(std::span<const heat::StepRecord> steps, const Field& weights, std::size_t row)
    {
        auto adjoint = make_adjoint(steps);
        adjoint.weights() = small_.project(weights);
        auto causes = adjoint.causes(row);
        return {std::move(causes), adjoint.weights()};
    }
    heat::HeatAdjoint<Small> make_adjoint(std::span<const heat::StepRecord> steps)
    {
        small_.complete_start(run_.start, reference_, start_);
        return {small_, {sources_, steps, start_}, reference_};
    }

    heat::FinishedRun<System> run_;
    double reference_;
    Small small_;
    heat::HeatSources<Small> sources_;
    Field load_;
    typename Small::Vector start_;
    std::span<const heat::StepRecord> steps_;  ///< up to the functional's time
    std::vector<Stretch> stretches_;
};

}  // namespace deadpoint::reduce
