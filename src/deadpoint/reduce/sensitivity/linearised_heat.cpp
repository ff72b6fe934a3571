#include "deadpoint/reduce/sensitivity/linearised_heat.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/reduce/online/conduction_terms.hpp"

#include <utility>

namespace deadpoint::reduce {
namespace {

constexpr double ring_difference_step = 1e-4;  // [K]

bool is_film(const SurfaceCondition& condition) { return condition.kind == SurfaceCondition::Kind::film; }

bool is_constant_film(const SurfaceCondition& condition)
{
    return is_film(condition) && !heat::follows_temperature(condition);
}

}  // namespace

LinearisedHeat::LinearisedHeat(const PreparedTerms& terms, const HeatProblem& problem, std::size_t segment,
                               std::shared_ptr<const TridiagonalForm> form, const LinearisedHeat* like)
    : prepared_(&terms), problem_(&problem), laws_(&problem.segments[segment]), segment_(segment),
      joints_(problem, terms.terms.geometry), films_(problem, terms.terms.geometry), self_(problem.sources.size(), 0.0)
{
    joints_.enter(*laws_);
    films_.enter(*laws_);
    inner_ = inner_layout(problem, *laws_, geometry(), joints_);
    for (std::size_t i = 0; i < joints_.laws().size(); ++i)
        if (const double share = film_share(i); share > 0)
            self_[static_cast<std::size_t>(joints_.laws()[i].source)] +=
                share * share / (joints_.area(i) * joints_.film_sum(i));
    set_basis(std::move(form), like);
    add_loads();
}

void LinearisedHeat::set_basis(std::shared_ptr<const TridiagonalForm> form, const LinearisedHeat* like)
{
    const auto& terms = prepared_->terms;
    const bool is_linear = inner_.films.empty();
    if (is_linear && form) {
        form_ = std::move(form);
    } else {
        const auto conduction = prepared_->conduction(conduction_terms(terms, *problem_, joints_.laws()));
        if (is_linear)
            form_ = conduction->form();
        else
            stiffness_ = conduction->matrix();
    }
    if (like && like->form_ == form_) {
        functionals_ = like->functionals_;
        return;
    }
    // column by column, since a row of RowMatrix is one of its transpose
    Eigen::MatrixXd columns = terms.functionals.transpose();
    if (form_)
        form_->into_basis(columns);
    functionals_ = std::make_shared<const RowMatrix>(columns.transpose());
}

void LinearisedHeat::add_loads()
{
    loads_ = Eigen::MatrixXd::Zero(prepared_->terms.uniform.size(), inner_.count());
    const auto& layout = geometry().layout;
    for (std::size_t r = 0; r < self_.size(); ++r)
        for (const auto& [functional, weight] : joints_.source_load(r))
            loads_.col(InnerLayout::heat(r)) += weight * row(functional);
    for (std::size_t i = 0; i < inner_.oil_of.size(); ++i)
        if (inner_.oil_of[i] >= 0)
            for (const bool side_b : {false, true})
                loads_.col(inner_.oil_of[i]) += joints_.area(i) * joints_.laws()[i].oil *
                                                joints_.side_share(i, side_b) * row(layout.mean(i, side_b));
    for (std::size_t s = 0; s < problem_->surfaces.size(); ++s)
        if (const auto& condition = problem_->surfaces[s]; is_constant_film(condition) && condition.enclosure >= 0)
            loads_.col(inner_.air(static_cast<std::size_t>(condition.enclosure))) +=
                condition.coefficient * row(layout.surface(s));
    for (const auto& [surface, outside, slope, inside] : inner_.films) {
        loads_.col(outside) = -row(layout.surface(surface));
        if (inside >= 0)
            loads_.col(inside) = loads_.col(outside);
    }
}

Eigen::VectorXd LinearisedHeat::row(std::size_t functional) const
{
    return functionals_->row(static_cast<Eigen::Index>(functional)).transpose();
}

double LinearisedHeat::film_share(std::size_t i) const
{
    const auto& law = joints_.laws()[i];
    return law.source >= 0 && law.heat_part < 0 ? joints_.heat_share(i) : 0;
}

double LinearisedHeat::zoned_heat(std::size_t i) const
{
    const auto& law = joints_.laws()[i];
    if (law.source < 0 || !law.load_zone)
        return 0;
    return laws_->zoned_heat[static_cast<std::size_t>(law.source)] * joints_.heat_share(i);
}

Eigen::MatrixXd LinearisedHeat::into_basis(const Eigen::MatrixXd& states) const
{
    Eigen::MatrixXd result = states;
    if (form_)
        form_->into_basis(result);
    return result;
}
Eigen::MatrixXd LinearisedHeat::from_basis(const Eigen::MatrixXd& states) const
{
    Eigen::MatrixXd result = states;
    if (form_)
        form_->from_basis(result);
    return result;
}

LinearisedState LinearisedHeat::at(const heat::StageRecord& record, const Eigen::VectorXd& states,
                                   const heat::StepTimes& step)
{
    LinearisedState result;
    result.time = record.time;
    result.step = step;
    result.ambient = step.value(laws_->ambient, record.time);
    films_.set_step(step);
    result.states = states;
    const Eigen::VectorXd values = *functionals_ * states;
    result.values.assign(values.begin(), values.end());
    std::vector<double> watts(result.values.size(), 0.0), air;
    for (const auto& flow : record.air)
        air.push_back(flow.temperature);
    joints_.set_oil(record.oil_temperature);
    joints_.evaluate(result.values, result.balance, watts);
    result.balance.air = record.air;
    for (std::size_t s = 0; s < problem_->surfaces.size(); ++s)
        result.faced.push_back(is_film(problem_->surfaces[s]) ? films_.surroundings(s, record.time, air) : 0);
    result.rows = Eigen::MatrixXd::Zero(states.size(), inner_.count());
    result.inner = Eigen::MatrixXd::Zero(inner_.count(), inner_.count());
    add_sources(result);
    add_oil(result);
    add_air(result);
    if (!inner_.films.empty()) {
        evaluate_films(result);
        add_films(result);
        add_rooms(result);
    }
    return result;
}

Eigen::VectorXd LinearisedHeat::ring_functional(std::size_t r) const
{
    const auto mean = [&](const std::vector<InterfaceSide>& sides) {
        Eigen::VectorXd sum = Eigen::VectorXd::Zero(functionals_->cols());
        double area = 0;
        for (const auto& side : sides) {
            const auto i = static_cast<std::size_t>(side.interface);
            sum += joints_.area(i) * row(geometry().layout.mean(i, side.b));
            area += joints_.area(i);
        }
        return Eigen::VectorXd(sum / area);
    };
    const auto& source = problem_->sources[r];
    return mean(source.inner_rings) - mean(source.outer_rings);
}

double LinearisedHeat::ring_difference(std::size_t r, const std::vector<double>& values) const
{
    const auto mean = [&](const std::vector<InterfaceSide>& sides) {
        double sum = 0, area = 0;
        for (const auto& side : sides) {
            const auto i = static_cast<std::size_t>(side.interface);
            sum += joints_.area(i) * values[geometry().layout.mean(i, side.b)];
            area += joints_.area(i);
        }
        return sum / area;
    };
    return mean(problem_->sources[r].inner_rings) - mean(problem_->sources[r].outer_rings);
}

void LinearisedHeat::add_sources(LinearisedState& state) const
{
    state.inner.topLeftCorner(static_cast<Eigen::Index>(self_.size()), static_cast<Eigen::Index>(self_.size()))
        .diagonal()
        .setConstant(-1);
    for (std::size_t r = 0; r < self_.size(); ++r) {
        const auto place = InnerLayout::heat(r);
        const double slope = state.balance.source_slope[r];
        state.rows.col(place) = slope * loads_.col(place);
        if (!laws_->heat[r] || laws_->ring_heat.empty() || !laws_->ring_heat[r])
            continue;
        const auto& law = laws_->ring_heat[r];
        const double difference = ring_difference(r, state.values), step = ring_difference_step;
        const double by_rings = (law(difference + step) - law(difference - step)) / (2 * step);
        state.rows.col(place) += problem_->sources[r].share * by_rings * (1 + self_[r] * slope) * ring_functional(r);
    }
    for (std::size_t i = 0; i < inner_.oil_of.size(); ++i)
        if (const auto& law = joints_.laws()[i]; inner_.oil_of[i] >= 0 && film_share(i) > 0) {
            const auto r = static_cast<std::size_t>(law.source);
            state.inner(InnerLayout::heat(r), inner_.oil_of[i]) +=
                state.balance.source_slope[r] * film_share(i) * law.oil / joints_.film_sum(i);
        }
}

double LinearisedHeat::heat_by_law(std::size_t r, const LinearisedState& at) const
{
    const auto& law = laws_->heat[r];
    if (!law)
        return 0;
    const bool by_rings = !laws_->ring_heat.empty() && laws_->ring_heat[r];
    return law(at.balance.source_temperature[r]).value +
           (by_rings ? laws_->ring_heat[r](ring_difference(r, at.values)) : 0);
}

double LinearisedHeat::oil_heat(const OilStop& stop, const LinearisedState& at) const
{
    double heat = 0;
    for (const auto i : stop.interfaces)
        heat += joints_.laws()[i].oil * joints_.area(i) * (at.balance.film[i] - at.balance.oil_temperature[i]);
    return heat;
}

// factor times the derivative of a stop's heat, to the equation of an inner value.
void LinearisedHeat::add_stop(const OilStop& stop, double factor, InnerPlace row, LinearisedState& state) const
{
    state.rows.col(row) += factor * loads_.col(stop.place);
    for (const auto i : stop.interfaces) {
        const auto& law = joints_.laws()[i];
        const double share = law.oil / joints_.film_sum(i);
        state.inner(row, stop.place) -= factor * law.oil * joints_.area(i) * (1 - share);
        if (film_share(i) > 0)
            state.inner(row, InnerLayout::heat(static_cast<std::size_t>(law.source))) += factor * share * film_share(i);
    }
}

void LinearisedHeat::add_oil(LinearisedState& state) const
{
    using Feed = OilPath::Feed;
    for (const auto& path : inner_.oil) {
        if (path.stops.empty())
            continue;
        const auto first = path.stops.front().place;
        if (path.feed == Feed::cooler)
            state.inner(first, first) = -1;
        else if (path.feed == Feed::sump) {
            state.inner(first, first) = -problem_->oil[path.circuit].sump_loss;
            for (const auto& stop : path.stops)
                if (path.flow > 0)
                    add_stop(stop, 1, first, state);
        }
        for (std::size_t k = 1; k < path.stops.size(); ++k) {
            const auto place = path.stops[k].place;
            state.inner(place, place) -= 1;
            state.inner(place, path.stops[k - 1].place) += 1;
            if (path.flow > 0)
                add_stop(path.stops[k - 1], 1 / path.flow, place, state);
        }
    }
}

void LinearisedHeat::add_air(LinearisedState& state) const
{
    for (std::size_t e = 0; e < problem_->enclosures.size(); ++e) {
        const auto place = inner_.air(e);
        state.rows.col(place) = loads_.col(place);
        state.inner(place, place) = -problem_->enclosures[e].exchange;
    }
    for (std::size_t s = 0; s < problem_->surfaces.size(); ++s)
        if (const auto& condition = problem_->surfaces[s]; is_constant_film(condition) && condition.enclosure >= 0) {
            const auto place = inner_.air(static_cast<std::size_t>(condition.enclosure));
            state.inner(place, place) -= condition.coefficient * geometry().surface_area[s];
        }
}

// The factor's columns after the first, times their products with the states.
Eigen::VectorXd LinearisedHeat::bend(std::size_t surface, const Eigen::VectorXd& states) const
{
    const auto& factor = prepared_->terms.films[surface].factor;
    const auto deviations = factor.rightCols(factor.cols() - 1);
    return deviations * (deviations.transpose() * states);
}

void LinearisedHeat::evaluate_films(LinearisedState& state) const
{
    state.loads = loads_;
    std::vector<SymmetricMatrix::Term> slopes;
    for (const auto& [surface, outside, slope, inside] : inner_.films) {
        const double area = geometry().surface_area[surface];
        const Eigen::VectorXd bent = bend(surface, state.states);
        state.loads.col(slope) = -bent;
        state.films.push_back(film_state([&](double faced) { return films_.law(surface, faced); },
                                         problem_->surfaces[surface].emissivity, inside >= 0,
                                         state.values[geometry().layout.surface(surface)] / area,
                                         bent.dot(state.states) / area, state.faced[surface]));
        slopes.push_back({state.films.back().slope, &prepared_->film(surface).matrix()});
    }
    state.stiffness = stiffness_.plus(slopes);
}

// What K's slopes leave: fluxes by the mean beyond the slope and by the variance, and the slope's change.
void LinearisedHeat::add_films(LinearisedState& state) const
{
    for (std::size_t k = 0; k < inner_.films.size(); ++k) {
        const auto& [surface, outside, slope, inside] = inner_.films[k];
        const auto& film = state.films[k];
        const double area = geometry().surface_area[surface];
        const Eigen::VectorXd mean = row(geometry().layout.surface(surface)) / area;
        state.rows.col(outside) =
            (film.by_mean - film.slope) * mean - 2 * film.by_variance / area * state.loads.col(slope);
        state.rows.col(slope) = film.slope_by_mean * mean;
        state.inner(outside, outside) = state.inner(slope, slope) = -1;
        if (inside >= 0)
            state.inner(inside, inside) = -1;
        if (const int enclosure = problem_->surfaces[surface].enclosure; enclosure >= 0) {
            const auto air = inner_.air(static_cast<std::size_t>(enclosure));
            state.inner(outside, air) = film.by_faced;
            state.inner(slope, air) = film.slope_by_faced;
            state.inner(air, outside) = area;
            state.rows.col(air) += area * film.slope * mean;
        }
    }
}

// A surface of a room gives off emissivity (its emission - mean emission of what it exchanges with).
void LinearisedHeat::add_rooms(LinearisedState& state) const
{
    const auto film_of = [&](int surface) {
        std::size_t k = 0;
        while (inner_.films[k].surface != static_cast<std::size_t>(surface))
            ++k;
        return k;
    };
    for (const auto& room : problem_->radiation) {
        const auto count = static_cast<Eigen::Index>(room.surfaces.size());
        Eigen::MatrixXd emitted(state.states.size(), count);
        for (Eigen::Index j = 0; j < count; ++j) {
            const auto k = film_of(room.surfaces[static_cast<std::size_t>(j)]);
            const auto& film = inner_.films[k];
            const auto by = emission(state.films[k].mean, state.films[k].variance);
            emitted.col(j) = (by.by_mean * row(geometry().layout.surface(film.surface)) -
                              2 * by.by_variance * state.loads.col(film.slope)) /
                             geometry().surface_area[film.surface];
        }
        const auto exchange = Eigen::Map<const RowMatrix>(room.exchange.data(), count, count);
        for (Eigen::Index i = 0; i < count; ++i) {
            const auto& film = inner_.films[film_of(room.surfaces[static_cast<std::size_t>(i)])];
            const Eigen::VectorXd received = emitted * (exchange.row(i).transpose() / exchange.row(i).sum());
            state.rows.col(film.inside) = problem_->surfaces[film.surface].emissivity * (emitted.col(i) - received);
        }
    }
}

const Eigen::MatrixXd& LinearisedHeat::loads(const LinearisedState& at) const
{
    return at.loads.size() > 0 ? at.loads : loads_;
}

Eigen::MatrixXd LinearisedHeat::conduct(const LinearisedState& at, const Eigen::MatrixXd& x) const
{
    if (!form_) {
        Eigen::MatrixXd result(x.rows(), x.cols());
        for (Eigen::Index k = 0; k < x.cols(); ++k)
            result.col(k) = at.stiffness.times(x.col(k));
        return result;
    }
    const Eigen::Index n = x.rows(), beside = n - 1;
    Eigen::MatrixXd result = form_->diagonal.asDiagonal() * x;
    result.topRows(beside) += form_->beside.asDiagonal() * x.bottomRows(beside);
    result.bottomRows(beside) += form_->beside.asDiagonal() * x.topRows(beside);
    return result;
}

}  // namespace deadpoint::reduce
