#include "deadpoint/reduce/certificate/residual_root.hpp"

#include "deadpoint/error.hpp"

namespace deadpoint::reduce {

Eigen::MatrixXd residual_root(const Eigen::MatrixXd& gram)
{
    const Eigen::VectorXd sizes = gram.diagonal().cwiseMax(0.0).cwiseSqrt();
    const Eigen::VectorXd scale = (sizes.array() > 0).select(sizes.cwiseInverse(), 0.0);
    Eigen::MatrixXd scaled = scale.asDiagonal() * ((gram + gram.transpose()) / 2) * scale.asDiagonal();
    scaled.diagonal().setOnes();
    for (double added = 1e-15; added < 1e-8; added *= 10) {
        scaled.diagonal().setConstant(1 + added);
        const Eigen::LLT<Eigen::MatrixXd> root(scaled);
        if (root.info() == Eigen::Success)
            return Eigen::MatrixXd(root.matrixU()) * sizes.asDiagonal();
    }
    throw ConvergenceError("the residual of the reduced model has no size in the conduction matrix; please report the "
                           "case");
}

}  // namespace deadpoint::reduce
