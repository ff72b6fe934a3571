#include "deadpoint/fem/conduction/float_matrix.hpp"

#include <algorithm>
#include <numeric>

namespace deadpoint::fem {
namespace {

bool is_of_type(Mat matrix, MatType type)
{
    PetscBool same = PETSC_FALSE;
    DEADPOINT_PETSC(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(matrix), type, &same));
    return same == PETSC_TRUE;
}

/// The compressed rows of a sequential matrix, to read.
class Rows {
public:
    explicit Rows(Mat matrix) : matrix_(matrix)
    {
        PetscBool done = PETSC_FALSE;
        DEADPOINT_PETSC(MatGetRowIJ(matrix_, 0, PETSC_FALSE, PETSC_FALSE, &count, &starts, &columns, &done));
        DEADPOINT_PETSC(MatSeqAIJGetArrayRead(matrix_, &values));
    }
    ~Rows()
    {
        PetscBool done = PETSC_FALSE;
        MatSeqAIJRestoreArrayRead(matrix_, &values);
        MatRestoreRowIJ(matrix_, 0, PETSC_FALSE, PETSC_FALSE, &count, &starts, &columns, &done);
    }
    Rows(const Rows&) = delete;

    PetscInt count = 0;
    const PetscInt* starts = nullptr;
    const PetscInt* columns = nullptr;
    const PetscScalar* values = nullptr;

private:
    Mat matrix_;
};

/// The two parts of this rank's rows: its own columns and the ghosts.
struct Parts {
    explicit Parts(Mat matrix)
    {
        if (is_of_type(matrix, MATMPIAIJ)) {
            DEADPOINT_PETSC(MatMPIAIJGetSeqAIJ(matrix, &own, &other, &ghosts));
            DEADPOINT_PETSC(MatGetSize(other, nullptr, &ghost_count));
        } else {
            own = matrix;
        }
    }
    Mat own = nullptr;
    Mat other = nullptr;  ///< null on one rank
    const PetscInt* ghosts = nullptr;
    PetscInt ghost_count = 0;
};

/// Calls visit(row, k, local column, value) for the k-th entry of each row.
template <class Visit>
void for_each_entry(const Parts& parts, std::size_t columns, const Visit& visit)
{
    const Rows own(parts.own);
    const auto visit_row = [&](const Rows& rows, std::size_t row, std::size_t k, std::size_t before) {
        for (PetscInt entry = rows.starts[row]; entry < rows.starts[row + 1]; ++entry)
            visit(row, k++, static_cast<PetscInt>(before) + rows.columns[entry], rows.values[entry]);
        return k;
    };
    const auto count = static_cast<std::size_t>(own.count);
    if (!parts.other) {
        for (std::size_t row = 0; row < count; ++row)
            visit_row(own, row, 0, 0);
        return;
    }
    const Rows other(parts.other);
    for (std::size_t row = 0; row < count; ++row)
        visit_row(other, row, visit_row(own, row, 0, 0), columns);
}

}  // namespace

bool is_assembled(Mat matrix) { return is_of_type(matrix, MATSEQAIJ) || is_of_type(matrix, MATMPIAIJ); }

FloatMatrix::FloatMatrix(Mat matrix) : communicator_(PetscObjectComm(reinterpret_cast<PetscObject>(matrix)))
{
    PetscInt rows = 0, columns = 0;
    DEADPOINT_PETSC(MatGetLocalSize(matrix, &rows, &columns));
    const Parts parts(matrix);
    columns_ = static_cast<std::size_t>(columns);
    ghosts_ = static_cast<std::size_t>(parts.ghost_count);
    lengths_.assign(static_cast<std::size_t>(rows), 0);
    for_each_entry(parts, columns_, [&](std::size_t row, std::size_t, PetscInt, double) { ++lengths_[row]; });
    starts_.push_back(0);
    for (std::size_t first = 0; first < lengths_.size(); first += slice) {
        const std::span of_slice(lengths_.data() + first, std::min(slice, lengths_.size() - first));
        starts_.push_back(starts_.back() + slice * *std::ranges::max_element(of_slice));
    }
    places_.assign(starts_.back(), 0);
    values_.assign(starts_.back(), 0);
    for_each_entry(parts, columns_, [&](std::size_t row, std::size_t k, PetscInt column, double value) {
        places_[position(row, k)] = column;
        values_[position(row, k)] = static_cast<float>(value);
    });
    if (parts.other)
        find_exchanges(communicator_, matrix, {parts.ghosts, ghosts_});
}

void FloatMatrix::take_values(Mat matrix)
{
    for_each_entry(Parts(matrix), columns_, [&](std::size_t row, std::size_t k, PetscInt, double value) {
        values_[position(row, k)] = static_cast<float>(value);
    });
}

std::size_t FloatMatrix::entries() const { return std::accumulate(lengths_.begin(), lengths_.end(), std::size_t{0}); }

std::vector<float> FloatMatrix::inverse_diagonal() const
{
    std::vector<float> result(rows(), 1);
    for (std::size_t row = 0; row < rows(); ++row)
        for (std::size_t k = 0; k < lengths_[row]; ++k)
            if (static_cast<std::size_t>(places_[position(row, k)]) == row)
                result[row] = 1 / values_[position(row, k)];
    return result;
}

// Ghosts are sorted by their global number, so each rank's follow each other. Every rank tells the owners which of
// their entries it needs.
void FloatMatrix::find_exchanges(MPI_Comm communicator, Mat matrix, std::span<const PetscInt> ghosts)
{
    const PetscInt* first_of_rank = nullptr;
    DEADPOINT_PETSC(MatGetOwnershipRangesColumn(matrix, &first_of_rank));
    int ranks = 1, rank = 0;
    MPI_Comm_size(communicator, &ranks);
    MPI_Comm_rank(communicator, &rank);
    std::vector<int> wanted(static_cast<std::size_t>(ranks)), sent(wanted), from(wanted), to(wanted);
    for (std::size_t r = 0; r < wanted.size(); ++r) {
        const auto begin = std::ranges::lower_bound(ghosts, first_of_rank[r]);
        const auto end = std::ranges::lower_bound(ghosts, first_of_rank[r + 1]);
        wanted[r] = static_cast<int>(end - begin);
        from[r] = static_cast<int>(begin - ghosts.begin());
    }
    MPI_Alltoall(wanted.data(), 1, MPI_INT, sent.data(), 1, MPI_INT, communicator);
    int count = 0;
    for (std::size_t r = 0; r < sent.size(); ++r) {
        to[r] = count;
        count += sent[r];
    }
    std::vector<PetscInt> asked(static_cast<std::size_t>(count));
    MPI_Alltoallv(ghosts.data(), wanted.data(), from.data(), MPIU_INT, asked.data(), sent.data(), to.data(), MPIU_INT,
                  communicator);
    for (int r = 0; r < ranks; ++r) {
        const auto k = static_cast<std::size_t>(r);
        if (wanted[k] == 0 && sent[k] == 0)
            continue;
        Exchange exchange{r, {}, static_cast<std::size_t>(from[k]), static_cast<std::size_t>(wanted[k])};
        for (int i = 0; i < sent[k]; ++i)
            exchange.sent.push_back(asked[static_cast<std::size_t>(to[k] + i)] - first_of_rank[rank]);
        exchanges_.push_back(std::move(exchange));
    }
}

void FloatMatrix::fetch(std::vector<float>& vector) const
{
    std::vector<MPI_Request> requests(2 * exchanges_.size());
    std::vector<std::vector<float>> parcels(exchanges_.size());
    for (std::size_t k = 0; k < exchanges_.size(); ++k) {
        const auto& exchange = exchanges_[k];
        for (const auto place : exchange.sent)
            parcels[k].push_back(vector[static_cast<std::size_t>(place)]);
        MPI_Irecv(vector.data() + columns_ + exchange.first, static_cast<int>(exchange.count), MPI_FLOAT, exchange.rank,
                  0, communicator_, &requests[2 * k]);
        MPI_Isend(parcels[k].data(), static_cast<int>(parcels[k].size()), MPI_FLOAT, exchange.rank, 0, communicator_,
                  &requests[2 * k + 1]);
    }
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

}  // namespace deadpoint::fem
