#include "deadpoint/fem/reduction/mpi_ranks.hpp"

#include "deadpoint/fem/algebra/petsc.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/fem/reduction/columns.hpp"

#include <array>
#include <cstdint>

namespace deadpoint::fem {

int MpiRanks::rank() const { return fem::rank(); }
int MpiRanks::count() const { return ranks(); }
void MpiRanks::sum(Eigen::MatrixXd& matrix) const { sum_over_ranks(matrix); }

void MpiRanks::share(Eigen::MatrixXd& matrix, int from) const
{
    std::array<std::int64_t, 2> size{matrix.rows(), matrix.cols()};
    MPI_Bcast(size.data(), 2, MPI_INT64_T, from, PETSC_COMM_WORLD);
    matrix.resize(size[0], size[1]);
    MPI_Bcast(matrix.data(), static_cast<int>(matrix.size()), MPI_DOUBLE, from, PETSC_COMM_WORLD);
}

}  // namespace deadpoint::fem
