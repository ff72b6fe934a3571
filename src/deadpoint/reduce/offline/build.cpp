#include "deadpoint/reduce/offline/build.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/reduce/certificate/lowest.hpp"
#include "deadpoint/reduce/certificate/residual_terms.hpp"
#include "deadpoint/reduce/offline/basis.hpp"
#include "deadpoint/reduce/offline/pod.hpp"
#include "deadpoint/reduce/offline/ranks.hpp"
#include "deadpoint/reduce/offline/training.hpp"

#include <utility>

namespace deadpoint::reduce {
namespace {

std::shared_ptr<const PreparedTerms> projected(FullModel& full, const BuildOptions& options)
{
    auto terms = full.project(options.large);
    share(full.ranks(), terms);
    return std::make_shared<const PreparedTerms>(std::move(terms));
}

}  // namespace

BuiltModels build(FullModel& full, const HeatProblem& base, const Box& box, const BuildOptions& options,
                  Observer& observer)
{
    const auto& ranks = full.ranks();
    observer.stage("basis");
    add_fields(full, base, box, options, observer);
    orthonormalise(full, options.least);
    observer.stage("projection");
    const auto large = projected(full, options);
    observer.stage("training runs");
    const auto training = train(large, base, box, options, ranks, observer);
    observer.stage("small model");
    const auto combinations = on_first(ranks, [&] {
        return most_frequent(training.states, training.duals, options.dual_share, large->terms.uniform,
                             static_cast<Eigen::Index>(options.largest));
    });
    auto small = choose_small(large, combinations, base, box, options, ranks);
    BuiltModels models{large, std::move(small), {}};
    if (options.certificate) {
        observer.stage("certificate");
        models.residual =
            std::make_shared<const ResidualTerms>(full.residual(lowest_conduction(base, box), options.residual));
    }
    full.combine(combinations.leftCols(models.small.terms->terms.uniform.size()));
    return models;
}

}  // namespace deadpoint::reduce
