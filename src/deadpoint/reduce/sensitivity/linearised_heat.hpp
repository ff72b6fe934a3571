#pragma once

#include "deadpoint/heat/balance.hpp"
#include "deadpoint/heat/films.hpp"
#include "deadpoint/heat/joints.hpp"
#include "deadpoint/reduce/dense/tridiagonal.hpp"
#include "deadpoint/reduce/online/dense_terms.hpp"
#include "deadpoint/reduce/sensitivity/film_state.hpp"
#include "deadpoint/reduce/sensitivity/inner_layout.hpp"

#include <Eigen/Dense>
#include <cstddef>
#include <memory>
#include <vector>

namespace deadpoint {
struct HeatProblem;
struct HeatSegment;
}  // namespace deadpoint

/// Internal to reduce/, since it shows Eigen: the heat balance of a reduced run, linearised.
namespace deadpoint::reduce {

/// One time of a run, as far as the derivatives of its rate need it. States are in the basis of LinearisedHeat.
struct LinearisedState {
    double time = 0;
    heat::StepTimes step;  ///< to which it belongs
    double ambient = 0;    ///< of the segment [K]
    Eigen::VectorXd states;
    std::vector<double> values;    ///< by functional [K]
    heat::HeatBalance balance;     ///< of joints, oil and air
    std::vector<double> faced;     ///< per surface condition: temperature that its film faces [K]
    std::vector<FilmState> films;  ///< per film that follows the temperature
    Eigen::MatrixXd rows;          ///< N: a column per inner value
    Eigen::MatrixXd inner;         ///< D
    Eigen::MatrixXd loads;         ///< L, where it depends on the states; else empty
    SymmetricMatrix stiffness;     ///< K where it depends on the states; else without rows
};

/// The heat balance of a segment, linearised. With the inner values v (heat of sources, oil, enclosed air, films that
/// follow the temperature; inner_layout.hpp) the states x have the rate f, and each v_k has a rate (oil of a sump with
/// a capacity, air) or an equation g_k = 0 of its own:
///   df = -K dx + L dv + (df by coefficients)      dg = N^T dx + D dv + (dg by coefficients)
/// L has the loads: b_r of one watt of source r, those of 1 K of oil and air, and of films.
/// An algebraic value stands in its own equation with -1. The heat of source r, with self_r and the slope H' of its
/// heat by the solids' part of the temperature of its contact layers, has
///   dH = H' (b_r . dx + sum of (share g / S) dT_oil) + (1 + self H') share H_ring' d(difference of ring temperatures).
/// Oil at a stop, with its heat Q = sum of g A (T_f - T_oil) over the stop's interfaces, goes on at T_oil + Q / flow; a
/// sump has the rate  sum of Q - loss (T - ambient), enclosed air  sum of film heat + power - exchange (T - ambient).
/// K has the slopes of films that follow the temperature; their inner values are what is left of their derivative.
///
/// Where no film follows the temperature, the basis of states is that in which K is tridiagonal.
class LinearisedHeat {
public:
    /// @param terms  they and the problem must outlive this
    /// @param form   of the segment's K; null: not known
    /// @param like   another segment, which shares what is the same
    LinearisedHeat(const PreparedTerms& terms, const HeatProblem& problem, std::size_t segment,
                   std::shared_ptr<const TridiagonalForm> form = nullptr, const LinearisedHeat* like = nullptr);
    LinearisedHeat(const LinearisedHeat&) = delete;

    [[nodiscard]] const PreparedTerms& prepared() const { return *prepared_; }
    [[nodiscard]] const HeatProblem& problem() const { return *problem_; }
    [[nodiscard]] const HeatSegment& laws() const { return *laws_; }
    [[nodiscard]] std::size_t segment() const { return segment_; }
    [[nodiscard]] const heat::HeatGeometry& geometry() const { return prepared_->terms.geometry; }
    [[nodiscard]] const heat::JointBalance& joints() const { return joints_; }
    [[nodiscard]] const heat::FilmBalance& films() const { return films_; }
    [[nodiscard]] const InnerLayout& inner() const { return inner_; }
    /// Temperature of a source's contact layers per watt of its own [K/W].
    [[nodiscard]] double self(std::size_t source) const { return self_[source]; }
    /// Share of its source's heat that enters an interface's contact layer.
    [[nodiscard]] double film_share(std::size_t interface) const;
    /// Heat of an interface by load zone, per unit of the source's share [W].
    [[nodiscard]] double zoned_heat(std::size_t interface) const;
    /// Temperature difference of a source's rings [K].
    [[nodiscard]] double ring_difference(std::size_t source, const std::vector<double>& values) const;
    /// Heat of a source per unit of its share, by its law; 0 without one [W].
    [[nodiscard]] double heat_by_law(std::size_t source, const LinearisedState& at) const;
    /// Heat of the oil at a stop [W].
    [[nodiscard]] double oil_heat(const OilStop& stop, const LinearisedState& at) const;

    /// Q^T x: columns of states into the basis.
    [[nodiscard]] Eigen::MatrixXd into_basis(const Eigen::MatrixXd& states) const;
    [[nodiscard]] Eigen::MatrixXd from_basis(const Eigen::MatrixXd& states) const;
    /// Null where a film follows the temperature.
    [[nodiscard]] const std::shared_ptr<const TridiagonalForm>& form() const { return form_; }
    /// Functionals in the basis.
    [[nodiscard]] const RowMatrix& functionals() const { return *functionals_; }

    /// @param record  time, oil and air
    /// @param states  in the basis
    /// @param step    the times of its step
    [[nodiscard]] LinearisedState at(const heat::StageRecord& record, const Eigen::VectorXd& states,
                                     const heat::StepTimes& step = {});
    /// L
    [[nodiscard]] const Eigen::MatrixXd& loads(const LinearisedState& at) const;
    /// K x, of columns in the basis.
    [[nodiscard]] Eigen::MatrixXd conduct(const LinearisedState& at, const Eigen::MatrixXd& x) const;

private:
    void set_basis(std::shared_ptr<const TridiagonalForm> form, const LinearisedHeat* like);
    void add_loads();
    void evaluate_films(LinearisedState& state) const;
    void add_sources(LinearisedState& state) const;
    void add_oil(LinearisedState& state) const;
    void add_stop(const OilStop& stop, double factor, InnerPlace row, LinearisedState& state) const;
    void add_air(LinearisedState& state) const;
    void add_films(LinearisedState& state) const;
    void add_rooms(LinearisedState& state) const;
    [[nodiscard]] Eigen::VectorXd row(std::size_t functional) const;
    [[nodiscard]] Eigen::VectorXd ring_functional(std::size_t source) const;
    [[nodiscard]] Eigen::VectorXd bend(std::size_t surface, const Eigen::VectorXd& states) const;

    const PreparedTerms* prepared_;
    const HeatProblem* problem_;
    const HeatSegment* laws_;
    std::size_t segment_;
    heat::JointBalance joints_;
    heat::FilmBalance films_;
    InnerLayout inner_;
    std::vector<double> self_;
    SymmetricMatrix stiffness_;  ///< K without following films; without rows in tridiagonal form
    std::shared_ptr<const TridiagonalForm> form_;
    std::shared_ptr<const RowMatrix> functionals_;
    Eigen::MatrixXd loads_;  ///< L, without loads that depend on the states
};

}  // namespace deadpoint::reduce
