#pragma once

#include "deadpoint/fem/algebra/petsc.hpp"

#include <cstddef>
#include <span>
#include <vector>

/// Internal to fem/: entries of vectors that other ranks own.
namespace deadpoint::fem {

/// The ghosts that this rank's rows of a matrix need of a vector. Collective.
class Ghosts {
public:
    /// @param matrix  by whose columns vectors are distributed @param ghosts  global numbers, sorted
    Ghosts(Mat matrix, std::span<const PetscInt> ghosts);

    [[nodiscard]] std::size_t count() const { return count_; }

    /// Fetches the ghosts of a vector: this rank's entries, then room for count(). Values, numbers or blocks of
    /// numbers, go as bytes.
    template <class Value>
    void fetch(std::vector<Value>& vector) const
    {
        std::vector<std::vector<Value>> parcels(exchanges_.size());
        Requests requests;
        for (std::size_t k = 0; k < exchanges_.size(); ++k) {
            const auto& exchange = exchanges_[k];
            for (const auto place : exchange.sent)
                parcels[k].push_back(vector[static_cast<std::size_t>(place)]);
            requests.push_back(receive(exchange, vector.data() + own_ + exchange.first, sizeof(Value)));
            requests.push_back(send(exchange, parcels[k].data(), sizeof(Value)));
        }
        wait(requests);
    }

private:
    using Requests = std::vector<MPI_Request>;
    struct Exchange {
        int rank = 0;
        std::vector<PetscInt> sent;  ///< local columns that this rank needs
        std::size_t first = 0;       ///< where what it sends begins among the ghosts
        std::size_t count = 0;
    };
    void find_exchanges(Mat matrix, std::span<const PetscInt> ghosts);
    MPI_Request receive(const Exchange& exchange, void* to, std::size_t size) const;
    MPI_Request send(const Exchange& exchange, const void* from, std::size_t size) const;
    static void wait(Requests& requests);

    MPI_Comm communicator_;
    std::size_t own_ = 0, count_ = 0;
    std::vector<Exchange> exchanges_;
};

}  // namespace deadpoint::fem
