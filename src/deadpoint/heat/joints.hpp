#pragma once

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/functionals.hpp"

#include <vector>

namespace deadpoint::heat {

struct HeatBalance;

/// Friction heat and contact layers of the joints, on scalars: from the mean temperatures of their
/// sides to watts by functional.
///
/// The contact layer of interface i has  T_f = (q + h_a T_a + h_b T_b + g T_oil) / S,  S = h_a +
/// h_b + g, with the friction heat q per area. A source r heats its interfaces at the temperature
/// tau_r of their contact layers, which depends on its own heat H_r:
///   tau_r = (solids' part) + (oil's part) + self_r H_r,   H_r = law(tau_r), solved by Newton's method.
class JointBalance {
public:
    JointBalance(const HeatProblem& problem, const HeatGeometry& geometry);

    /// Sets the laws of a segment; the oil then has the temperatures of the laws.
    /// @throws DomainError if an interface conducts nothing to either side nor to the oil
    void enter(const HeatSegment& segment);
    [[nodiscard]] const std::vector<InterfaceLaw>& laws() const { return *laws_; }

    /// Functionals that evaluate() reads.
    [[nodiscard]] std::vector<std::size_t> needed() const;
    /// b_r of each source: the load of one watt, less the share that goes directly to the oil.
    [[nodiscard]] const Loads& source_load(std::size_t source) const { return sources_[source].load; }
    /// Adds the heat of sources, contact layers and load zones to a balance and to the watts by
    /// functional.
    /// @param values  by functional, of the temperatures [K]
    void evaluate(const std::vector<double>& values, HeatBalance& balance, std::vector<double>& watts) const;

    /// Heat of the tangents at `before` less heat of the laws, both at the temperatures of `after`,
    /// per source [W].
    [[nodiscard]] std::vector<double> tangent_less_law(const HeatBalance& before, const HeatBalance& after) const;
    /// Adds these corrections to a balance.
    void correct(HeatBalance& balance, const std::vector<double>& corrections, std::vector<double>& watts) const;

    /// Temperature at which the oil reaches each interface [K].
    [[nodiscard]] const std::vector<double>& oil_temperature() const { return oil_temperature_; }
    void set_oil(const std::vector<double>& temperature);
    /// Temperature of an interface's contact layer if oil of another temperature reached it [K].
    [[nodiscard]] double film_with_oil(std::size_t interface, double film, double oil) const;
    [[nodiscard]] double area(std::size_t interface) const { return geometry_->interface_area[interface]; }
    /// S [W/m2/K].
    [[nodiscard]] double film_sum(std::size_t interface) const { return films_[interface].sum; }
    /// Share of its source's heat that an interface receives, 0 to 1.
    [[nodiscard]] double heat_share(std::size_t interface) const { return films_[interface].heat_share; }
    /// Share of the contact layer's heat that goes to side a or b: h / S [-].
    [[nodiscard]] double side_share(std::size_t interface, bool side_b) const;

private:
    struct FilmTerms {
        double sum = 0;         ///< S [W/m2/K]
        double heat_share = 0;  ///< of its source's heat
        double film_share = 0;  ///< the same, only of heat into its contact layer
    };
    struct SourceTerms {
        Loads load;
        double constant = 0;  ///< part of the film temperature from the oil [K]
        double self = 0;      ///< film temperature per watt of the source itself [K/W]
        double to_oil = 0;    ///< share of the heat that goes directly to the oil
    };
    void enter_interface(std::size_t interface, double weighted_area);
    void evaluate_source(std::size_t source, const std::vector<double>& values, HeatBalance& balance) const;
    void evaluate_interface(std::size_t interface, const std::vector<double>& values, HeatBalance& balance,
                            std::vector<double>& watts) const;
    void add_zone(std::size_t interface, std::vector<double>& watts) const;
    [[nodiscard]] double ring_difference(const HeatSource& source, const std::vector<double>& values) const;

    const HeatProblem* problem_;
    const HeatGeometry* geometry_;
    const HeatSegment* segment_ = nullptr;
    const std::vector<InterfaceLaw>* laws_;
    std::vector<FilmTerms> films_;
    std::vector<SourceTerms> sources_;
    std::vector<double> oil_temperature_;
};

}  // namespace deadpoint::heat
