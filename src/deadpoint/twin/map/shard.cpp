#include "deadpoint/twin/map/shard.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/press/machine/model_part.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>
#include <unordered_map>

namespace deadpoint::twin {

Shard read_shard(const std::string& text)
{
    constexpr int most = 100000;
    Shard shard;
    char slash = 0, more = 0;
    std::istringstream in(text);
    if (!(in >> shard.number >> slash >> shard.count) || slash != '/' || in >> more)
        throw InputError(fmt::format("--shard '{}' is not a share such as 2/4\n  help: give the number of this share "
                                     "and how many there are",
                                     text));
    if (shard.count < 1 || shard.count > most || shard.number < 1 || shard.number > shard.count)
        throw InputError(
            fmt::format("--shard {}: there is no share {} of {}\n  help: shares count from 1: 1/{} to {}/{}", text,
                        shard.number, shard.count, std::clamp(shard.count, 1, most), std::clamp(shard.count, 1, most),
                        std::clamp(shard.count, 1, most)));
    return shard;
}

std::vector<std::size_t> points_of(const Shard& shard, const std::vector<std::size_t>& order)
{
    const auto begin_of = [&](int number) {
        return order.begin() + static_cast<std::ptrdiff_t>(order.size() * static_cast<std::size_t>(number - 1) /
                                                           static_cast<std::size_t>(shard.count));
    };
    std::vector<std::size_t> points(begin_of(shard.number), begin_of(shard.number + 1));
    std::ranges::sort(points);
    return points;
}

std::vector<std::size_t> order_by_model(const std::vector<casefile::Case>& cases)
{
    std::unordered_map<std::string, std::size_t> first;  // point with that model
    std::vector<std::size_t> model, order;
    for (std::size_t p = 0; p < cases.size(); ++p) {
        model.push_back(first.emplace(press::model_key(cases[p]), p).first->second);
        order.push_back(p);
    }
    std::ranges::stable_sort(order, {}, [&](std::size_t point) { return model[point]; });
    return order;
}

}  // namespace deadpoint::twin
