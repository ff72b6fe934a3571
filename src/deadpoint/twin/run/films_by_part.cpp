#include "deadpoint/twin/run/films_by_part.hpp"

#include "deadpoint/exchange/machine.hpp"

namespace deadpoint::twin {
namespace {

/// The pieces of one condition.
struct Pieces {
    std::vector<int> conditions;  ///< indices into the split problem
    std::vector<double> shares;   ///< of the area
};

RadiantRoom split_room(const RadiantRoom& room, const std::vector<Pieces>& pieces)
{
    RadiantRoom result;
    std::vector<std::size_t> surface;
    std::vector<double> share;
    for (std::size_t i = 0; i < room.surfaces.size(); ++i) {
        const auto& own = pieces[static_cast<std::size_t>(room.surfaces[i])];
        for (std::size_t p = 0; p < own.conditions.size(); ++p) {
            result.surfaces.push_back(own.conditions[p]);
            surface.push_back(i);
            share.push_back(own.shares[p]);
        }
    }
    for (std::size_t p = 0; p < surface.size(); ++p)
        for (std::size_t q = 0; q < surface.size(); ++q)
            result.exchange.push_back(room.exchange[surface[p] * room.surfaces.size() + surface[q]] * share[p] *
                                      share[q]);
    return result;
}

}  // namespace

SplitProblem split_by_part(const HeatProblem& problem, const Machine& machine)
{
    SplitProblem split{problem, {}};
    split.problem.surfaces.clear();
    std::vector<Pieces> pieces(problem.surfaces.size());
    for (std::size_t s = 0; s < problem.surfaces.size(); ++s) {
        const auto& surface = machine.surfaces[static_cast<std::size_t>(problem.surfaces[s].surface)];
        for (const auto& [part, area] : surface.figures.parts) {
            pieces[s].conditions.push_back(static_cast<int>(split.problem.surfaces.size()));
            pieces[s].shares.push_back(area / surface.area);
            split.problem.surfaces.push_back(problem.surfaces[s]);
            split.problem.surfaces.back().part = static_cast<int>(part);
            split.whole.push_back(s);
        }
    }
    for (auto& room : split.problem.radiation)
        room = split_room(room, pieces);
    return split;
}

std::vector<double> summed(const SplitProblem& split, const std::vector<double>& by_piece, std::size_t count)
{
    std::vector<double> result(count, 0.0);
    for (std::size_t k = 0; k < by_piece.size(); ++k)
        result[split.whole[k]] += by_piece[k];
    return result;
}

}  // namespace deadpoint::twin
