#include "deadpoint/twin/map/drift_window.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace deadpoint::twin {
namespace {

using Steps = std::vector<std::size_t>;
using Mask = std::vector<char>;

constexpr double most_choices = 1e6;
constexpr double same_share = 1e-12;  ///< smaller differences of shares are rounding

/// An axis as the search goes through it.
struct SearchAxis {
    std::size_t index = 0;  ///< index in the original grid
    Steps order;            ///< its steps, sorted by number
    bool ordered = false;
    std::vector<double> numbers;

    [[nodiscard]] double choices() const
    {
        const auto n = static_cast<double>(order.size());
        return ordered ? n * (n + 1) / 2 : std::pow(2.0, n) - 1;
    }
    /// Share of the axis that the given steps cover; steps are positions in `order`.
    [[nodiscard]] double share(const Steps& chosen) const
    {
        if (numbers.empty()) {
            return static_cast<double>(chosen.size()) / static_cast<double>(order.size());
        }
        const auto number = [&](std::size_t place) { return numbers[order[place]]; };
        const double range = number(order.size() - 1) - number(0);
        return range > 0 ? (number(chosen.back()) - number(chosen.front())) / range : 1;
    }
};

SearchAxis search_axis(const WindowAxis& axis, std::size_t index)
{
    SearchAxis result{index, Steps(axis.steps), !axis.numbers.empty(), axis.numbers};
    std::iota(result.order.begin(), result.order.end(), std::size_t{0});
    if (result.ordered) {
        std::ranges::stable_sort(result.order, {}, [&](std::size_t step) { return axis.numbers[step]; });
    }
    return result;
}

/// Ordered axes first; last the one that a search gets for nothing: the one with the most choices without order, or
/// else the longest.
std::vector<SearchAxis> search_order(const std::vector<WindowAxis>& axes)
{
    std::vector<SearchAxis> result;
    for (std::size_t a = 0; a < axes.size(); ++a) {
        result.push_back(search_axis(axes[a], a));
    }
    const auto sort = [&] {
        std::ranges::stable_sort(result, [](const SearchAxis& a, const SearchAxis& b) {
            return std::pair(!a.ordered, a.order.size()) < std::pair(!b.ordered, b.order.size());
        });
    };
    sort();
    double choices = 1;
    for (std::size_t a = 0; a + 1 < result.size(); ++a) {
        choices *= result[a].choices();
    }
    if (choices > most_choices) {
        std::ranges::for_each(result, [](SearchAxis& axis) { axis.ordered = true; });
        sort();
    }
    return result;
}

/// Goes through all boxes axis by axis: a choice of steps of one axis leaves of the grid below it the places that are
/// inside for all of them.
class Search {
public:
    explicit Search(const std::vector<WindowAxis>& axes) : axes_(search_order(axes)), chosen_(axes.size()) {}

    DriftWindow run(const std::vector<WindowAxis>& given, const std::vector<bool>& inside)
    {
        descend(0, reordered(given, inside), 1, 0);
        return best_;
    }

private:
    /// The grid with its axes in the order of the search and their steps in the order of their numbers.
    [[nodiscard]] Mask reordered(const std::vector<WindowAxis>& given, const std::vector<bool>& inside) const
    {
        Mask mask(inside.size());
        Steps place(axes_.size(), 0);
        for (auto& cell : mask) {
            Steps steps(given.size());
            for (std::size_t a = 0; a < axes_.size(); ++a) {
                steps[axes_[a].index] = axes_[a].order[place[a]];
            }
            std::size_t index = 0;
            for (std::size_t a = 0; a < given.size(); ++a) {
                index = index * given[a].steps + steps[a];
            }
            cell = inside[index] ? 1 : 0;
            for (std::size_t a = axes_.size(); a-- > 0;) {
                if (++place[a] < axes_[a].order.size()) {
                    break;
                }
                place[a] = 0;
            }
        }
        return mask;
    }

    void descend(std::size_t depth, const Mask& mask, std::size_t points, double share)
    {
        const auto open = static_cast<std::size_t>(std::ranges::count(mask, 1));
        if (open == 0 || points * open < best_.points) {
            return;
        }
        if (depth == axes_.size()) {
            return consider(points, share);
        }
        if (depth + 1 == axes_.size()) {
            return last(depth, mask, points, share);
        }
        if (axes_[depth].ordered) {
            ranges(depth, mask, points, share);
        } else {
            subsets(depth, mask, points, share, 0, Mask());
        }
    }

    void choose(std::size_t depth, const Mask& rest, std::size_t points, double share)
    {
        descend(depth + 1, rest, points * chosen_[depth].size(), share + axes_[depth].share(chosen_[depth]));
    }

    /// The part of the grid that belongs to one step of an axis, intersected with `narrowed`.
    [[nodiscard]] Mask slice(std::size_t depth, const Mask& mask, std::size_t place, const Mask& narrowed) const
    {
        const std::size_t size = mask.size() / axes_[depth].order.size();
        Mask part(mask.begin() + static_cast<std::ptrdiff_t>(place * size),
                  mask.begin() + static_cast<std::ptrdiff_t>((place + 1) * size));
        for (std::size_t i = 0; i < narrowed.size(); ++i) {
            part[i] = static_cast<char>(part[i] & narrowed[i]);
        }
        return part;
    }

    void ranges(std::size_t depth, const Mask& mask, std::size_t points, double share)
    {
        for (std::size_t first = 0; first < axes_[depth].order.size(); ++first) {
            Mask rest;
            chosen_[depth].clear();
            for (std::size_t place = first; place < axes_[depth].order.size(); ++place) {
                rest = slice(depth, mask, place, rest);
                if (std::ranges::count(rest, 1) == 0) {
                    break;
                }
                chosen_[depth].push_back(place);
                choose(depth, rest, points, share);
            }
        }
        chosen_[depth].clear();
    }

    void subsets(std::size_t depth, const Mask& mask, std::size_t points, double share, std::size_t from,
                 const Mask& rest)
    {
        for (std::size_t place = from; place < axes_[depth].order.size(); ++place) {
            const Mask narrowed = slice(depth, mask, place, rest);
            if (std::ranges::count(narrowed, 1) == 0) {
                continue;
            }
            chosen_[depth].push_back(place);
            choose(depth, narrowed, points, share);
            subsets(depth, mask, points, share, place + 1, narrowed);
            chosen_[depth].pop_back();
        }
    }

    /// Innermost axis: without order all remaining steps, else every contiguous range of them.
    void last(std::size_t depth, const Mask& mask, std::size_t points, double share)
    {
        auto& chosen = chosen_[depth];
        chosen.clear();
        for (std::size_t place = 0; place < mask.size(); ++place) {
            if (mask[place] != 0) {
                chosen.push_back(place);
            }
            const bool ends = place + 1 == mask.size() || (axes_[depth].ordered && mask[place] == 0);
            if (ends && !chosen.empty()) {
                consider(points * chosen.size(), share + axes_[depth].share(chosen));
                chosen.clear();
            }
        }
    }

    void consider(std::size_t points, double share_sum)
    {
        const double share = axes_.empty() ? 1 : share_sum / static_cast<double>(axes_.size());
        if (points < best_.points || (points == best_.points && share <= best_.share + same_share)) {
            return;
        }
        best_ = {points, std::vector<Steps>(axes_.size()), share};
        for (std::size_t a = 0; a < axes_.size(); ++a) {
            for (const std::size_t place : chosen_[a]) {
                best_.steps[axes_[a].index].push_back(axes_[a].order[place]);
            }
        }
    }

    std::vector<SearchAxis> axes_;
    std::vector<Steps> chosen_;  ///< per axis of the search: positions in its order
    DriftWindow best_;
};

}  // namespace

DriftWindow best_window(const std::vector<WindowAxis>& axes, const std::vector<bool>& inside)
{
    std::size_t places = 1;
    for (const auto& axis : axes) {
        if (axis.steps == 0 || (!axis.numbers.empty() && axis.numbers.size() != axis.steps)) {
            throw DomainError("each axis of a window needs a step, and a number for each or for none");
        }
        places *= axis.steps;
    }
    if (inside.size() != places) {
        throw DomainError("a window needs to know of every place whether it is inside");
    }
    return Search(axes).run(axes, inside);
}

bool keeps(const DriftLimits& limits, const std::optional<PointDrift>& drift)
{
    return drift && std::isfinite(drift->largest) && std::isfinite(drift->final) &&
           (!limits.largest || drift->largest <= *limits.largest) && (!limits.final || drift->final <= *limits.final);
}

std::size_t grid_index(const SweepSet& set, const std::vector<std::size_t>& steps)
{
    std::size_t index = 0;
    for (std::size_t a = 0; a < set.axes.size(); ++a) {
        index = index * set.axes[a].values.size() + steps[a];
    }
    return index;
}

std::optional<DriftWindow> best_window(const SweepStudy& study, std::size_t set, const std::vector<SweepPoint>& points,
                                       const std::vector<std::optional<PointDrift>>& drift)
{
    if (!study.limits.largest && !study.limits.final) {
        return std::nullopt;
    }
    const auto& grid = study.sets.at(set);
    std::vector<WindowAxis> axes;
    std::size_t places = 1;
    for (const auto& axis : grid.axes) {
        axes.push_back({axis.values.size(), axis.numbers});
        places *= axis.values.size();
    }
    std::vector<bool> inside(places, false);
    for (std::size_t p = 0; p < points.size(); ++p) {
        for (const auto& place : points[p].places) {
            if (place.set == set) {
                inside.at(grid_index(grid, place.steps)) = keeps(study.limits, drift.at(p));
            }
        }
    }
    return best_window(axes, inside);
}

}  // namespace deadpoint::twin
