#pragma once

#include "deadpoint/reduce/parallel/ranks.hpp"

namespace deadpoint::fem {

/// The ranks of PETSC_COMM_WORLD.
class MpiRanks final : public reduce::Ranks {
public:
    [[nodiscard]] int rank() const override;
    [[nodiscard]] int count() const override;
    void sum(Eigen::MatrixXd& matrix) const override;
    void share(Eigen::MatrixXd& matrix, int from) const override;
};

}  // namespace deadpoint::fem
