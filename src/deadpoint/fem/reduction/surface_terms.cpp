#include "deadpoint/fem/reduction/surface_terms.hpp"

#include "deadpoint/fem/conduction/terms/heat_matrices.hpp"
#include "deadpoint/fem/reduction/gathered_term.hpp"
#include "deadpoint/fem/reduction/mpi_ranks.hpp"
#include "deadpoint/fem/space/discretisation.hpp"
#include "deadpoint/reduce/offline/build_options.hpp"
#include "deadpoint/reduce/offline/low_rank.hpp"

#include <algorithm>
#include <optional>

namespace deadpoint::fem {
namespace {

/// A term to be cut to a factor of low rank.
struct WantedFactor {
    TermSum sum;
    Eigen::VectorXd load;  ///< product of the term with the uniform field; empty: none, and the term need not keep it
    double tolerance = 0;  ///< of the largest eigenvalue
    Eigen::MatrixXd* factor = nullptr;  ///< where it belongs
};

bool has_entries(const SparseTerm& term)
{
    std::vector<double> entries{static_cast<double>(term.entries())};
    sum_over_ranks(entries);
    return entries[0] > 0;
}

/// Collects the terms of joints and films.
class Wanted {
public:
    Wanted(const reduce::Truncation& truncation, const reduce::DenseTerms& terms)
        : truncation_(truncation), terms_(terms)
    {}
    // A term whose product with the uniform field is a functional.
    void add_side(const SparseTerm& term, std::size_t functional, double factor, reduce::LowRankTerm& result)
    {
        list_.push_back({{{1, &term}},
                         factor * terms_.functionals.row(static_cast<Eigen::Index>(functional)).transpose(),
                         truncation_.others,
                         &result.factor});
    }
    // J = S_aa + S_bb - S_ab - S_ab^T.
    void add_between(const JointTerm& joint, const SparseTerm& across, reduce::LowRankTerm& result)
    {
        if (has_entries(across))
            list_.push_back({{{1, &joint.aa}, {1, &joint.bb}, {-1, &across}}, {}, truncation_.joints, &result.factor});
    }
    [[nodiscard]] const std::vector<WantedFactor>& list() const { return list_; }

private:
    const reduce::Truncation& truncation_;
    const reduce::DenseTerms& terms_;
    std::vector<WantedFactor> list_;
};

Wanted wanted_factors(const HeatMatrices& matrices, const reduce::Truncation& truncation, reduce::DenseTerms& terms)
{
    const auto& geometry = terms.geometry;
    const auto& layout = geometry.layout;
    terms.joints.resize(layout.interfaces);
    terms.films.resize(layout.surfaces);
    Wanted wanted(truncation, terms);
    for (std::size_t i = 0; i < layout.interfaces; ++i) {
        const auto& joint = matrices.joint_terms()[i];
        auto& reduced = terms.joints[i];
        wanted.add_side(joint.aa, layout.mean(i, false), geometry.interface_area[i], reduced.aa);
        wanted.add_side(joint.bb, layout.mean(i, true), geometry.interface_area[i], reduced.bb);
        wanted.add_between(joint, joint.across, reduced.between);
        wanted.add_between(joint, joint.turning, reduced.turning);
    }
    for (std::size_t s = 0; s < layout.surfaces; ++s)
        if (has_entries(matrices.film_terms()[s]))
            wanted.add_side(matrices.film_terms()[s], layout.surface(s), 1, terms.films[s]);
    return wanted;
}

Eigen::MatrixXd factor_of(const GatheredTerm& term, const WantedFactor& wanted, const Eigen::MatrixXd& correction,
                          const Eigen::VectorXd& uniform)
{
    const auto product = [&](const Eigen::MatrixXd& columns) -> Eigen::MatrixXd {
        return correction.transpose() * term.product(correction * columns);
    };
    return wanted.load.size() == 0 ? reduce::low_rank_factor(product, uniform.size(), wanted.tolerance)
                                   : reduce::low_rank_factor(product, wanted.load, uniform, wanted.tolerance);
}

}  // namespace

void project_surfaces(const Discretisation& space, const HeatMatrices& matrices, const BasisFields& fields,
                      const Eigen::MatrixXd& correction, const reduce::Truncation& truncation,
                      reduce::DenseTerms& terms)
{
    const MpiRanks ranks;
    const auto count = static_cast<std::size_t>(ranks.count()), own = static_cast<std::size_t>(ranks.rank());
    const auto wanted = wanted_factors(matrices, truncation, terms);
    const auto& list = wanted.list();
    for (std::size_t first = 0; first < list.size(); first += count) {
        std::optional<GatheredTerm> mine;
        for (std::size_t k = first; k < std::min(first + count, list.size()); ++k) {
            GatheredTerm term(space, list[k].sum, fields, static_cast<int>(k - first));
            if (k - first == own)
                mine.emplace(std::move(term));
        }
        if (!mine)
            continue;
        *list[first + own].factor = factor_of(*mine, list[first + own], correction, terms.uniform);
    }
    for (std::size_t k = 0; k < list.size(); ++k)
        ranks.share(*list[k].factor, static_cast<int>(k % count));
}

}  // namespace deadpoint::fem
