#include "deadpoint/reduce/online/stored_matrix.hpp"

#include "deadpoint/error.hpp"

namespace deadpoint::reduce {

StoredMatrix<float> as_stored(const Eigen::MatrixXd& matrix)
{
    const Eigen::MatrixXf rounded = matrix.cast<float>();
    return {static_cast<std::uint64_t>(matrix.rows()),
            static_cast<std::uint64_t>(matrix.cols()),
            {rounded.data(), rounded.data() + rounded.size()}};
}

Eigen::MatrixXd as_matrix(const StoredMatrix<float>& stored)
{
    if (!stored.is_whole())
        throw InputError("a matrix of a reduced model has another number of entries than it says");
    return Eigen::Map<const Eigen::MatrixXf>(stored.entries.data(), static_cast<Eigen::Index>(stored.rows),
                                             static_cast<Eigen::Index>(stored.columns))
        .cast<double>();
}

}  // namespace deadpoint::reduce
