#include "deadpoint/reduce/offline/build.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/reduce/certificate/lowest.hpp"
#include "deadpoint/reduce/certificate/residual_terms.hpp"
#include "deadpoint/reduce/kept/build_checkpoint.hpp"
#include "deadpoint/reduce/kept/matrix_pieces.hpp"
#include "deadpoint/reduce/offline/basis.hpp"
#include "deadpoint/reduce/offline/gram.hpp"
#include "deadpoint/reduce/offline/pod.hpp"
#include "deadpoint/reduce/offline/training.hpp"
#include "deadpoint/reduce/offline/typical_heat.hpp"
#include "deadpoint/reduce/parallel/ranks.hpp"

#include <utility>

namespace deadpoint::reduce {
namespace {

using Terms = std::shared_ptr<const PreparedTerms>;

Terms large_terms(FullModel& full, const BuildOptions& options, const BuildCheckpoint& kept)
{
    DenseTerms terms;
    if (const auto known = read_matrices(kept, "terms"); !known.empty()) {
        terms.geometry = full.geometry();
        take_matrices(known, terms);
    } else {
        terms = full.project(options.projection);
        share(full.ranks(), terms);
        write_matrices(kept, "terms", matrices_of(terms));
    }
    return std::make_shared<const PreparedTerms>(std::move(terms));
}

std::optional<Training> training_of(const Terms& large, const std::vector<HeatProblem>& points, const Box& box,
                                    const BuildOptions& options, const BuildCheckpoint& kept, const Ranks& ranks,
                                    Observer& observer)
{
    if (const auto known = read_matrices(kept, "training"); known.size() == 2)
        return Training{Moments(known[0]), Moments(known[1])};
    auto training = train(large, points, box, options, ranks, observer);
    if (training)
        write_matrices(kept, "training", {training->states.sum(), training->duals.sum()});
    return training;
}

// The directions that are left out cost a run time, and its file room.
Terms cut_large(const PreparedTerms& whole, const TypicalHeat& typical, double least, const Ranks& ranks)
{
    DenseTerms terms;
    terms.geometry = whole.terms.geometry;
    if (ranks.rank() == 0) {
        terms = whole.terms;
        cut_terms(terms, typical, least);
    }
    share(ranks, terms);
    return std::make_shared<const PreparedTerms>(std::move(terms));
}

}  // namespace

std::optional<BuiltModels> build(FullModel& full, const std::vector<HeatProblem>& points, const Box& box,
                                 const BuildOptions& options, const BuildCheckpoint& kept, Observer& observer)
{
    const auto& base = points.front();
    const auto& ranks = full.ranks();
    observer.stage("basis");
    const auto weights = add_fields(full, base, box, options, kept, observer);
    if (!weights)
        return std::nullopt;
    orthonormalise(full, {options.least, options.largest_basis, *weights}, kept);
    observer.stage("projection");
    auto whole = large_terms(full, options, kept);
    observer.stage("training runs");
    const auto training = training_of(whole, points, box, options, kept, ranks, observer);
    if (!training)
        return std::nullopt;
    const auto typical = typical_heat(whole->terms, *training, highest_conduction(base, box));
    const auto large = cut_large(*std::exchange(whole, nullptr), typical, options.least_heat.of_large, ranks);
    observer.stage("small model");
    const auto combinations = on_first(ranks, [&] {
        const auto& terms = large->terms;
        return most_frequent(training->states, training->duals,
                             {terms.uniform, error_norm(terms, options.readings), options.dual_share},
                             static_cast<Eigen::Index>(options.largest));
    });
    auto small = choose_small(large, combinations, typical, points, box, options, ranks, observer);
    if (!small)
        return std::nullopt;
    BuiltModels models{large, *std::move(small), {}};
    if (options.certificate) {
        observer.stage("certificate");
        auto residual =
            full.residual({lowest_conduction(base, box), typical.highest, typical.moments, options.residual}, observer);
        if (!residual)
            return std::nullopt;
        models.residual = std::make_shared<const ResidualTerms>(*std::move(residual));
    }
    full.combine(models.small.combinations);
    return models;
}

}  // namespace deadpoint::reduce
