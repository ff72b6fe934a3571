#pragma once

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/films.hpp"
#include "deadpoint/heat/functionals.hpp"
#include "deadpoint/heat/system.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <deque>
#include <span>
#include <utility>
#include <vector>

/// Internal to reduce/ and fem/, since it shows Eigen: the adjoint of a heat problem's steps on few fields.
namespace deadpoint::reduce {

/// True if joints with these laws conduct and cool alike.
inline bool conduct_alike(const std::vector<InterfaceLaw>& a, const std::vector<InterfaceLaw>& b)
{
    return std::ranges::equal(a, b, [](const InterfaceLaw& x, const InterfaceLaw& y) {
        return x.film_a == y.film_a && x.film_b == y.film_b && x.oil == y.oil && x.turns_fully == y.turns_fully;
    });
}

/// A full system on a basis V of its fields, for the adjoint of the steps (heat/adjoint.hpp). The basis is orthonormal
/// in M and grows while it is used:
///
///     V^T M V = 1,   K_V = V^T K V,   functionals b_V = V^T b
///
/// A vector holds the weights V^T l of a load l, or the factors of the fields in a solution. The matrices for the laws
/// of a segment are projected when its laws are first set, and completed when the basis has grown. The full system has
/// its adjoint begun and prescribes no temperature.
template <class System>
class ProjectedSystem {
public:
    using Vector = Eigen::VectorXd;
    using Field = typename System::Vector;

    ProjectedSystem(System& full, const HeatProblem& problem) : full_(full), product_(full.make_vector())
    {
        for (std::size_t i = 0; i < problem.surfaces.size(); ++i)
            if (heat::follows_temperature(problem.surfaces[i]))
                following_.push_back(i);
        coefficients_.assign(problem.surfaces.size(), 0.0);
    }

    [[nodiscard]] std::size_t size() const { return basis_.size(); }
    /// V^T load.
    [[nodiscard]] Vector project(const Field& load) const
    {
        Vector result = make_vector();
        for (std::size_t k = 0; k < size(); ++k)
            result[index(k)] = full_.dot(basis_[k], load);
        return result;
    }
    /// M V x: the load whose weights are x.
    void load_of(const Vector& x, Field& load)
    {
        lift(x, product_);
        full_.apply_mass(product_, load);
    }
    /// The same of the field that was added last.
    void load_of_last(Field& load) const { full_.apply_mass(basis_.back(), load); }
    /// V x.
    void lift(const Vector& x, Field& field) const
    {
        std::vector<heat::Scaled<Field>> sum;
        for (std::size_t k = 0; k < size(); ++k)
            sum.emplace_back(x[index(k)], &basis_[k]);
        full_.combine(sum, field);
    }
    /// Solves (M + factor K) y = load in the full system with the present laws and coefficients, from the solution
    /// on the basis, and adds y to the basis.
    /// @return whether the basis lacked any of it
    bool enrich(double factor, const Field& load)
    {
        auto field = full_.make_vector();
        Vector solution = make_vector();
        solve_adjoint(factor, project(load), solution);
        lift(solution, field);
        use_laws();
        if (!following_.empty())
            full_.set_film_coefficients(coefficients_);
        iterations_ += full_.solve_adjoint(factor, load, field, solve_tolerance_);
        const bool lacked = append(std::move(field));
        complete();
        sum_films();
        return lacked;
    }
    [[nodiscard]] int iterations() const { return iterations_; }

    // a vector space
    [[nodiscard]] Vector make_vector() const { return Vector::Zero(index(size())); }
    void copy(const Vector& from, Vector& to) const { to = from; }
    void combine(const std::vector<heat::Scaled<Vector>>& sum, Vector& result) const
    {
        result.setZero();
        for (const auto& [factor, term] : sum)
            result += factor * *term;
    }
    void add(double factor, const Vector& term, Vector& sum) const { sum += factor * term; }

    // functionals
    [[nodiscard]] const heat::HeatGeometry& geometry() const { return full_.geometry(); }
    [[nodiscard]] std::vector<double> evaluate(std::span<const std::size_t> which, const Vector& x) const
    {
        const Vector all = laws_->functionals * x;
        std::vector<double> result;
        for (const auto k : which)
            result.push_back(all[index(k)]);
        return result;
    }

    // terms
    void set_laws(const std::vector<InterfaceLaw>& laws, const std::vector<heat::Loads>& source_loads)
    {
        laws_ = nullptr;
        for (auto& known : known_)
            if (known.laws == &laws)
                laws_ = &known;
        if (!laws_)
            laws_ = &known_.emplace_back(Laws{&laws, source_loads, {}, {}});
        complete();
        sum_films();
    }

    // prescribed temperatures: none
    [[nodiscard]] bool some_prescribed() const { return false; }
    void clear_prescribed(Vector&) const {}

    // the adjoint of the steps
    void begin_adjoint() {}
    void set_film_coefficients(const std::vector<double>& coefficients)
    {
        coefficients_ = coefficients;
        sum_films();
    }
    void apply_mass(const Vector& in, Vector& out) const { out = in; }
    void apply_stiffness(const Vector& in, Vector& out) const { out.noalias() = stiffness_ * in; }
    int solve_adjoint(double factor, const Vector& right, Vector& solution, double = 0) const
    {
        const Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(right.size(), right.size()) + factor * stiffness_;
        solution = matrix.llt().solve(right);
        return 0;
    }
    [[nodiscard]] std::vector<double> prescribed_shares(const Vector&, const Vector&, double, double) const
    {
        return std::vector<double>(coefficients_.size(), 0.0);
    }
    /// Completes V^T M (T - T_reference) of the temperatures from which a run started.
    void complete_start(const Field& temperature, double reference, Vector& start)
    {
        auto known = start.size();
        start.conservativeResize(index(size()));
        for (; known < start.size(); ++known) {
            full_.apply_mass(basis_[static_cast<std::size_t>(known)], product_);
            start[known] = full_.start_shares(product_, temperature, reference).back();
        }
    }
    /// @param start  of complete_start()
    [[nodiscard]] std::vector<double> start_shares(const Vector& weights, const Vector& start, double) const
    {
        std::vector<double> shares(coefficients_.size(), 0.0);
        shares.push_back(weights.dot(start));
        return shares;
    }

private:
    using Index = Eigen::Index;
    struct Laws {
        const std::vector<InterfaceLaw>* laws;
        std::vector<heat::Loads> loads;
        Eigen::MatrixXd stiffness;    ///< without films that follow the temperature
        Eigen::MatrixXd functionals;  ///< a row for each
    };
    static Index index(std::size_t k) { return static_cast<Index>(k); }

    // Gram and Schmidt, twice, since the first pass leaves what rounding leaves.
    bool append(Field field)
    {
        full_.apply_mass(field, product_);
        const double whole = std::sqrt(full_.dot(field, product_));
        auto part = full_.make_vector();
        for (int pass = 0; pass < 2; ++pass) {
            lift(project(product_), part);
            full_.add(-1, part, field);
            full_.apply_mass(field, product_);
        }
        const double rest = std::sqrt(std::max(0.0, full_.dot(field, product_)));
        if (!(rest > least_ * whole))
            return false;
        full_.combine({{1 / rest, &field}}, part);
        basis_.push_back(std::move(part));
        return true;
    }

    void use_laws()
    {
        if (std::exchange(in_use_, laws_) != laws_)
            full_.set_laws(*laws_->laws, laws_->loads);
    }
    // Projects the present laws, and the films, on the fields that were added since.
    void complete()
    {
        if (laws_->functionals.cols() < index(size())) {
            use_laws();
            if (!following_.empty())
                full_.set_film_coefficients(std::vector<double>(coefficients_.size(), 0.0));
            project_functionals();
            for (const auto& known : known_)
                if (conduct_alike(*known.laws, *laws_->laws) && known.stiffness.cols() > laws_->stiffness.cols())
                    laws_->stiffness = known.stiffness;
            project_stiffness(laws_->stiffness);
        }
        films_.resize(following_.size());
        for (std::size_t i = 0; i < following_.size(); ++i)
            if (films_[i].cols() < index(size()))
                project_film(i);
    }
    void project_functionals()
    {
        auto& rows = laws_->functionals;
        const auto first = rows.cols();
        std::vector<std::size_t> all(geometry().layout.count());
        for (std::size_t k = 0; k < all.size(); ++k)
            all[k] = k;
        rows.conservativeResize(index(all.size()), index(size()));
        for (Index k = first; k < rows.cols(); ++k) {
            const auto values = full_.evaluate(all, basis_[static_cast<std::size_t>(k)]);
            rows.col(k) = Eigen::Map<const Vector>(values.data(), index(values.size()));
        }
    }
    void project_stiffness(Eigen::MatrixXd& matrix)
    {
        const auto first = matrix.cols();
        matrix.conservativeResize(index(size()), index(size()));
        for (Index k = first; k < matrix.cols(); ++k) {
            full_.apply_stiffness(basis_[static_cast<std::size_t>(k)], product_);
            matrix.col(k) = project(product_);
            matrix.row(k) = matrix.col(k).transpose();
        }
    }
    // As the difference that a coefficient of 1 W/m2/K makes.
    void project_film(std::size_t i)
    {
        std::vector<double> one(coefficients_.size(), 0.0);
        one[following_[i]] = 1;
        use_laws();
        full_.set_film_coefficients(one);
        Eigen::MatrixXd with = films_[i].cols() > 0
                                   ? films_[i] + laws_->stiffness.topLeftCorner(films_[i].rows(), films_[i].cols())
                                   : Eigen::MatrixXd();
        project_stiffness(with);
        films_[i] = with - laws_->stiffness;
    }
    void sum_films()
    {
        stiffness_ = laws_->stiffness;
        for (std::size_t i = 0; i < following_.size(); ++i)
            stiffness_ += coefficients_[following_[i]] * films_[i];
    }

    static constexpr double solve_tolerance_ = 1e-5;  ///< a field need not be exact to be of use
    static constexpr double least_ = 1e-4;            ///< below this share of it, a field is what solves leave

    System& full_;
    std::vector<Field> basis_;
    std::deque<Laws> known_;
    Laws* laws_ = nullptr;
    const Laws* in_use_ = nullptr;        ///< by the full system
    std::vector<std::size_t> following_;  ///< surfaces whose films follow the temperature
    std::vector<double> coefficients_;    ///< of their films, per surface condition [W/m2/K]
    std::vector<Eigen::MatrixXd> films_;  ///< per following surface, for 1 W/m2/K
    Eigen::MatrixXd stiffness_;           ///< K_V with the present laws and coefficients
    Field product_;
    int iterations_ = 0;
};

}  // namespace deadpoint::reduce
