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
        terms = full.project(options.large);
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

// The heat that states give off, summed over their moments.
double heat_of(const DenseTerms& terms, const std::vector<double>& coefficients, const Eigen::MatrixXd& moments)
{
    double sum = terms.solid.cwiseProduct(moments).sum();
    auto coefficient = coefficients.begin();
    const auto add = [&](const LowRankTerm& term) {
        if (const double c = *coefficient++; !term.is_missing())
            sum += c * term.factor.cwiseProduct(moments * term.factor).sum();
    };
    for (const auto& joint : terms.joints)
        for (const auto* term : {&joint.aa, &joint.bb, &joint.between, &joint.turning})
            add(*term);
    for (const auto& film : terms.films)
        add(film);
    return sum;
}

// Of runs and dual problems, each with the heat 1.
Eigen::MatrixXd typical_states(const DenseTerms& terms, const Training& training, const std::vector<double>& highest)
{
    const Eigen::VectorXd unit = terms.uniform.normalized();
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(unit.size(), unit.size());
    for (const auto* moments : {&training.states, &training.duals}) {
        const Eigen::MatrixXd away = deviations(*moments, unit);
        if (const double heat = heat_of(terms, highest, away); heat > 0)
            sum += away / heat;
    }
    return sum;
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
    const auto large = large_terms(full, options, kept);
    observer.stage("training runs");
    const auto training = training_of(large, points, box, options, kept, ranks, observer);
    if (!training)
        return std::nullopt;
    observer.stage("small model");
    const auto combinations = on_first(ranks, [&] {
        const auto& terms = large->terms;
        return most_frequent(training->states, training->duals,
                             {terms.uniform, error_norm(terms, options.readings), options.dual_share},
                             static_cast<Eigen::Index>(options.largest));
    });
    auto small = choose_small(large, combinations, points, box, options, ranks, observer);
    if (!small)
        return std::nullopt;
    BuiltModels models{large, *std::move(small), {}};
    if (options.certificate) {
        observer.stage("certificate");
        const auto lowest = lowest_conduction(base, box);
        const auto highest = highest_conduction(base, box);
        models.residual = std::make_shared<const ResidualTerms>(
            full.residual({lowest, highest, typical_states(large->terms, *training, highest), options.residual}));
    }
    full.combine(models.small.combinations);
    return models;
}

}  // namespace deadpoint::reduce
