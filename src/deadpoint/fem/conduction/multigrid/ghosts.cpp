#include "deadpoint/fem/conduction/multigrid/ghosts.hpp"

#include <algorithm>

namespace deadpoint::fem {

Ghosts::Ghosts(Mat matrix, std::span<const PetscInt> ghosts)
    : communicator_(PetscObjectComm(reinterpret_cast<PetscObject>(matrix))), count_(ghosts.size())
{
    PetscInt own = 0;
    int ranks = 1;
    DEADPOINT_PETSC(MatGetLocalSize(matrix, nullptr, &own));
    own_ = static_cast<std::size_t>(own);
    MPI_Comm_size(communicator_, &ranks);
    if (ranks > 1)
        find_exchanges(matrix, ghosts);
}

// Ghosts are sorted by their global number, so each rank's follow each other. Every rank tells the owners which of
// their entries it needs.
void Ghosts::find_exchanges(Mat matrix, std::span<const PetscInt> ghosts)
{
    const PetscInt* first_of_rank = nullptr;
    DEADPOINT_PETSC(MatGetOwnershipRangesColumn(matrix, &first_of_rank));
    int ranks = 1, rank = 0;
    MPI_Comm_size(communicator_, &ranks);
    MPI_Comm_rank(communicator_, &rank);
    std::vector<int> wanted(static_cast<std::size_t>(ranks)), sent(wanted), from(wanted), to(wanted);
    for (std::size_t r = 0; r < wanted.size(); ++r) {
        const auto begin = std::ranges::lower_bound(ghosts, first_of_rank[r]);
        const auto end = std::ranges::lower_bound(ghosts, first_of_rank[r + 1]);
        wanted[r] = static_cast<int>(end - begin);
        from[r] = static_cast<int>(begin - ghosts.begin());
    }
    MPI_Alltoall(wanted.data(), 1, MPI_INT, sent.data(), 1, MPI_INT, communicator_);
    int count = 0;
    for (std::size_t r = 0; r < sent.size(); ++r) {
        to[r] = count;
        count += sent[r];
    }
    std::vector<PetscInt> asked(static_cast<std::size_t>(count));
    MPI_Alltoallv(ghosts.data(), wanted.data(), from.data(), MPIU_INT, asked.data(), sent.data(), to.data(), MPIU_INT,
                  communicator_);
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

MPI_Request Ghosts::receive(const Exchange& exchange, void* to, std::size_t size) const
{
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Irecv(to, static_cast<int>(exchange.count * size), MPI_BYTE, exchange.rank, 0, communicator_, &request);
    return request;
}

MPI_Request Ghosts::send(const Exchange& exchange, const void* from, std::size_t size) const
{
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Isend(from, static_cast<int>(exchange.sent.size() * size), MPI_BYTE, exchange.rank, 0, communicator_, &request);
    return request;
}

void Ghosts::wait(Requests& requests)
{
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

}  // namespace deadpoint::fem
