#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace deadpoint::casefile {
struct Case;
}

/// Shares of a study that several calls compute, on one machine or many.
namespace deadpoint::twin {

/// One of `count` shares.
struct Shard {
    int number = 1;  ///< 1 to count
    int count = 1;
};

/// @param text  "2/4": the second of four
/// @throws InputError if it is none
Shard read_shard(const std::string& text);

/// Points of a shard: one block of the points in `order`, as large as the others' or one point less. All shards
/// together have each point once.
/// @param order  indices of the points
std::vector<std::size_t> points_of(const Shard& shard, const std::vector<std::size_t>& order);

/// All points, those that share meshes and model next to each other, so that few shards build the same ones.
std::vector<std::size_t> order_by_model(const std::vector<casefile::Case>& cases);

}  // namespace deadpoint::twin
