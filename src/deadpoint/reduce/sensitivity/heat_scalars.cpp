#include "deadpoint/reduce/sensitivity/heat_scalars.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/films.hpp"

namespace deadpoint::reduce {
namespace {

const std::vector<InterfaceLaw>& laws_of(const HeatProblem& problem, std::size_t segment)
{
    const auto& own = problem.segments[segment].interfaces;
    return own.empty() ? problem.interfaces : own;
}

/// Collects what differs between two problems.
class Differences {
public:
    explicit Differences(double by) : by_(by) {}
    void add(std::size_t scalar, double less, double more)
    {
        if (more != less)
            changes_.emplace_back(scalar, (more - less) / by_);
    }
    [[nodiscard]] ScalarChanges take() { return std::move(changes_); }

private:
    double by_;
    ScalarChanges changes_;
};

double zoned_heat(const HeatSegment& segment, std::size_t source)
{
    return segment.zoned_heat.empty() ? 0 : segment.zoned_heat[source];
}

void add_joints(const ScalarLayout& layout, const std::vector<InterfaceLaw>& less,
                const std::vector<InterfaceLaw>& more, Differences& result)
{
    using enum JointScalar;
    for (std::size_t i = 0; i < less.size(); ++i) {
        result.add(layout.joint(i, film_a), less[i].film_a, more[i].film_a);
        result.add(layout.joint(i, film_b), less[i].film_b, more[i].film_b);
        result.add(layout.joint(i, oil), less[i].oil, more[i].oil);
        result.add(layout.joint(i, oil_temperature), less[i].oil_temperature, more[i].oil_temperature);
        result.add(layout.weight(i), less[i].heat_weight, more[i].heat_weight);
    }
}

void add_media(const ScalarLayout& layout, const HeatProblem& less, const HeatProblem& more, std::size_t segment,
               Differences& result)
{
    for (std::size_t k = 0; k < less.oil.size(); ++k) {
        result.add(layout.flow(k), less.segments[segment].oil_flow[k], more.segments[segment].oil_flow[k]);
        result.add(layout.inlet(k), less.oil[k].inlet_temperature, more.oil[k].inlet_temperature);
        result.add(layout.sump_loss(k), less.oil[k].sump_loss, more.oil[k].sump_loss);
    }
    for (std::size_t e = 0; e < less.enclosures.size(); ++e)
        result.add(layout.exchange(e), less.enclosures[e].exchange, more.enclosures[e].exchange);
}

}  // namespace

ScalarLayout::ScalarLayout(const HeatProblem& problem)
    : interfaces(problem.interfaces.size()), surfaces(problem.surfaces.size()), sources(problem.sources.size()),
      bodies(problem.body_heat.size()), circuits(problem.oil.size()), enclosures(problem.enclosures.size())
{}

ScalarChanges lasting_changes(const HeatProblem& less, const HeatProblem& more, double by, std::size_t segment)
{
    const ScalarLayout layout(less);
    Differences result(by);
    add_joints(layout, laws_of(less, segment), laws_of(more, segment), result);
    for (std::size_t s = 0; s < less.surfaces.size(); ++s)
        if (!heat::follows_temperature(less.surfaces[s]))
            result.add(layout.film(s), less.surfaces[s].coefficient, more.surfaces[s].coefficient);
    for (std::size_t r = 0; r < less.sources.size(); ++r) {
        result.add(layout.share(r), less.sources[r].share, more.sources[r].share);
        result.add(layout.zoned(r), zoned_heat(less.segments[segment], r), zoned_heat(more.segments[segment], r));
    }
    add_media(layout, less, more, segment, result);
    return result.take();
}

}  // namespace deadpoint::reduce
