#include "deadpoint/fem/algebra/sparse_factor.hpp"

#include <algorithm>
#include <dmumps_c.h>
#include <fmt/format.h>
#include <metis.h>
#include <numeric>
#include <vector>

namespace deadpoint::fem {
namespace {

// Jobs of MUMPS.
constexpr int begin = -1, end = -2, analyse = 1, factor = 2, substitute = 3;
// Its errors: too little room for integers or for numbers, which more room mends; others.
constexpr int short_of_integers = -8, short_of_numbers = -9, singular = -10, no_memory = -13;

// Couplings of nodes, each once: a node of this rank and one behind it.
struct Edges {
    std::vector<int> from, to;
};

Edges node_couplings(const SymmetricTriplets& matrix, int block)
{
    Edges edges;
    std::vector<int> behind;
    const auto finish = [&](int node) {
        std::ranges::sort(behind);
        const auto repeated = std::ranges::unique(behind);
        behind.erase(repeated.begin(), repeated.end());
        edges.from.insert(edges.from.end(), behind.size(), node);
        edges.to.insert(edges.to.end(), behind.begin(), behind.end());
        behind.clear();
    };
    int current = -1;
    for (std::size_t e = 0; e < matrix.value.size(); ++e) {
        const int node = (matrix.row[e] - 1) / block, other = (matrix.column[e] - 1) / block;
        if (node != current)
            finish(current);
        current = node;
        if (other > node)
            behind.push_back(other);
    }
    finish(current);
    return edges;
}

// All ranks' values on the first one.
std::vector<int> gather(const std::vector<int>& owned, const SymmetricTriplets& matrix)
{
    const int own = static_cast<int>(owned.size());
    std::vector<int> sizes(matrix.sizes.size()), starts(sizes.size() + 1, 0);
    MPI_Gather(&own, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, PETSC_COMM_WORLD);
    std::partial_sum(sizes.begin(), sizes.end(), starts.begin() + 1);
    std::vector<int> all(static_cast<std::size_t>(matrix.rank == 0 ? starts.back() : 0));
    MPI_Gatherv(owned.data(), own, MPI_INT, all.data(), sizes.data(), starts.data(), MPI_INT, 0, PETSC_COMM_WORLD);
    return all;
}

// The place of each node in an order of nested dissection (Karypis and Kumar, A fast and high quality multilevel scheme
// for partitioning irregular graphs, SIAM J. Sci. Comput. 20, 1998).
std::vector<idx_t> nested_dissection(idx_t nodes, const Edges& edges)
{
    std::vector<idx_t> starts(static_cast<std::size_t>(nodes) + 1, 0), neighbours(2 * edges.from.size());
    for (const auto* ends : {&edges.from, &edges.to})
        for (const int node : *ends)
            ++starts[static_cast<std::size_t>(node) + 1];
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    auto next = starts;
    const auto add = [&](int node, int neighbour) {
        neighbours[static_cast<std::size_t>(next[static_cast<std::size_t>(node)]++)] = neighbour;
    };
    for (std::size_t k = 0; k < edges.from.size(); ++k) {
        add(edges.from[k], edges.to[k]);
        add(edges.to[k], edges.from[k]);
    }
    std::vector<idx_t> node_at(static_cast<std::size_t>(nodes)), place_of(node_at.size());
    if (METIS_NodeND(&nodes, starts.data(), neighbours.data(), nullptr, nullptr, node_at.data(), place_of.data()) !=
        METIS_OK)
        throw ConvergenceError("the unknowns of a sparse factor cannot be put in order, most often for want of memory");
    return place_of;
}

// The place of each unknown, from 1; empty except on the first rank, and where no nodes are coupled.
std::vector<MUMPS_INT> order_of_unknowns(const SymmetricTriplets& matrix, int block)
{
    const auto owned = node_couplings(matrix, block);
    const Edges edges{gather(owned.from, matrix), gather(owned.to, matrix)};
    std::vector<MUMPS_INT> places;
    if (edges.from.empty())
        return places;
    for (const idx_t place : nested_dissection(matrix.size() / block, edges))
        for (int c = 0; c < block; ++c)
            places.push_back(static_cast<MUMPS_INT>(block * place + c + 1));
    return places;
}

std::string reason_text(int error)
{
    switch (error) {
    case singular:
        return "its matrix is singular";
    case no_memory:
        return "memory is short\n  help: use larger cells (`--size`)";
    default:
        return fmt::format("MUMPS reports error {}", error);
    }
}

}  // namespace

struct SparseFactor::Mumps {
    DMUMPS_STRUC_C data{};
    int rank = 0;
    std::vector<int> sizes, starts;  ///< as in SymmetricTriplets
    std::vector<MUMPS_INT> order;

    Mumps() = default;
    Mumps(const Mumps&) = delete;
    Mumps& operator=(const Mumps&) = delete;
    ~Mumps()
    {
        if (!begun)
            return;
        data.job = end;
        dmumps_c(&data);
    }

    bool begun = false;
    [[nodiscard]] bool alone() const { return sizes.size() == 1; }
    MUMPS_INT& option(int number) { return data.icntl[number - 1]; }
    // MUMPS reads them only.
    void set_entries(const SymmetricTriplets& matrix)
    {
        (alone() ? data.nnz : data.nnz_loc) = static_cast<MUMPS_INT8>(matrix.value.size());
        (alone() ? data.irn : data.irn_loc) = const_cast<int*>(matrix.row.data());
        (alone() ? data.jcn : data.jcn_loc) = const_cast<int*>(matrix.column.data());
        (alone() ? data.a : data.a_loc) = const_cast<double*>(matrix.value.data());
    }
};

SparseFactor::SparseFactor(const SymmetricTriplets& pattern, int block) : mumps_(std::make_unique<Mumps>())
{
    auto& mumps = *mumps_;
    mumps.rank = pattern.rank;
    mumps.sizes = pattern.sizes;
    mumps.starts = pattern.starts;
    mumps.order = order_of_unknowns(pattern, block);
    mumps.data.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(PETSC_COMM_WORLD));
    mumps.data.par = 1;  // the first rank computes too
    mumps.data.sym = 1;  // positive definite
    call(begin);
    mumps.begun = true;  // from here on it holds memory
    for (const int stream : {1, 2, 3})
        mumps.option(stream) = -1;
    mumps.option(4) = 0;                       // no messages
    mumps.option(18) = mumps.alone() ? 0 : 3;  // each rank has a share of the entries
    mumps.data.n = pattern.size();
    if (!mumps.order.empty()) {
        mumps.option(7) = 1;  // the order given
        mumps.data.perm_in = mumps.order.data();
    }
    mumps.set_entries(pattern);
    call(analyse);
}

SparseFactor::~SparseFactor() = default;

void SparseFactor::call(int job)
{
    mumps_->data.job = job;
    dmumps_c(&mumps_->data);
    if (const int error = mumps_->data.infog[0]; error < 0)
        throw ConvergenceError("a sparse factor failed: " + reason_text(error));
}

void SparseFactor::factorise(const SymmetricTriplets& matrix)
{
    constexpr int largest_room = 400;  // percent beyond MUMPS' estimate
    auto& data = mumps_->data;
    auto& room = mumps_->option(14);
    mumps_->set_entries(matrix);
    data.job = factor;
    dmumps_c(&data);
    while ((data.infog[0] == short_of_integers || data.infog[0] == short_of_numbers) && 2 * room <= largest_room) {
        room *= 2;
        data.job = factor;
        dmumps_c(&data);
    }
    if (data.infog[0] < 0)
        throw ConvergenceError("a sparse factor failed: " + reason_text(data.infog[0]));
}

// MUMPS wants the right sides on the first rank, and leaves the solutions there.
void SparseFactor::solve(PetscInt columns, const double* right, double* solution)
{
    auto& mumps = *mumps_;
    const auto rows = static_cast<std::size_t>(mumps.data.n), count = static_cast<std::size_t>(columns);
    const auto own = static_cast<std::size_t>(mumps.sizes[static_cast<std::size_t>(mumps.rank)]);
    std::vector<double> all(mumps.rank == 0 ? rows * count : 0);
    for (std::size_t k = 0; k < count; ++k)
        MPI_Gatherv(right + k * own, static_cast<int>(own), MPI_DOUBLE, all.data() + k * rows, mumps.sizes.data(),
                    mumps.starts.data(), MPI_DOUBLE, 0, PETSC_COMM_WORLD);
    mumps.data.rhs = all.data();
    mumps.data.nrhs = columns;
    mumps.data.lrhs = mumps.data.n;
    call(substitute);
    for (std::size_t k = 0; k < count; ++k)
        MPI_Scatterv(all.data() + k * rows, mumps.sizes.data(), mumps.starts.data(), MPI_DOUBLE, solution + k * own,
                     static_cast<int>(own), MPI_DOUBLE, 0, PETSC_COMM_WORLD);
}

void SparseFactor::solve(Mat right, Mat solution)
{
    with_columns(right, solution, [&](PetscInt columns, const double* from, double* to) { solve(columns, from, to); });
}

void SparseFactor::solve(Vec right, Vec solution)
{
    with_columns(right, solution, [&](PetscInt columns, const double* from, double* to) { solve(columns, from, to); });
}

}  // namespace deadpoint::fem
