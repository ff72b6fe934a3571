#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/fem/space/discretisation.hpp"

#include <vector>

namespace deadpoint {
struct HeatProblem;
}

/// Internal to fem/: unknowns whose temperature is prescribed.
namespace deadpoint::fem {

class PrescribedTemperatures {
public:
    PrescribedTemperatures(const Discretisation& space, const HeatProblem& problem);

    void adopt(const HeatProblem& problem) { problem_ = &problem; }
    /// True if there are any on any rank.
    [[nodiscard]] bool some() const { return some_; }
    /// This rank's, by global number, ascending.
    [[nodiscard]] const std::vector<PetscInt>& unknowns() const { return unknowns_; }
    /// Sets their temperatures at a time.
    void impose(double time, Vec temperature) const;
    /// Sets their entries to zero.
    void clear(Vec vector) const;
    /// A functional without them.
    [[nodiscard]] SparseFunctional without(SparseFunctional functional) const;
    /// Sum of their entries, of all ranks.
    [[nodiscard]] double total(Vec vector) const;
    /// Per surface condition: sum of (right - left) (prescribed temperature - reference), of all ranks.
    [[nodiscard]] std::vector<double> shares(Vec right, Vec left, double time, double reference) const;
    /// Per surface condition: sum of weight (start - reference) of its unknowns; then the sum over
    /// all free unknowns.
    [[nodiscard]] std::vector<double> start_shares(Vec weights, Vec start, double reference) const;

private:
    struct Place {
        Vec3 position{};
        std::size_t surface = 0;  ///< condition
    };
    void find();

    const Discretisation& space_;
    const HeatProblem* problem_;
    bool some_ = false;
    std::vector<PetscInt> unknowns_;
    std::vector<Place> places_;  ///< of the unknowns
};

}  // namespace deadpoint::fem
