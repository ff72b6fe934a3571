#pragma once

#include <concepts>
#include <functional>
#include <string>
#include <utility>
#include <vector>

/// Smooth curves of a temperature: the only form in which a physical law reaches the field solver.
namespace deadpoint {

struct LawValue {
    double value = 0;
    double slope = 0;      ///< derivative by the temperature
    bool in_range = true;  ///< false outside the law's well-tested range
};

/// Friction heat of a joint, of the whole press [W], over its temperature [K].
using HeatLaw = std::function<LawValue(double temperature)>;
/// Additional friction heat due to the ring temperature difference (inner less outer) [K] through
/// the preload, of the whole press [W].
using RingHeatLaw = std::function<double(double difference)>;
/// Heat transfer coefficient of a surface [W/m2/K] over its temperature [K].
using FilmLaw = std::function<LawValue(double surface_temperature)>;

/// A law as the name of its formula and its parameters, in SI units. Another program can evaluate
/// it from these.
struct LawFormula {
    std::string name;
    std::vector<std::pair<std::string, double>> parameters;  ///< in the order of the formula
    bool operator==(const LawFormula&) const = default;
};
/// "name: parameter = 1.5, parameter = 2".
std::string text_of(const LawFormula& formula);
/// Hash of the name and all numbers: equal on every machine.
std::string hash_of(const LawFormula& formula);

/// The convection law of a surface at an ambient temperature [K].
struct FilmLawAt {
    FilmLawAt(LawFormula formula_, std::function<FilmLaw(double)> curve_)
        : formula(std::move(formula_)), curve(std::move(curve_))
    {}
    /// A convection law without a name.
    template <std::invocable<double> Curve>
    FilmLawAt(Curve curve_) : curve(std::move(curve_))
    {}
    [[nodiscard]] FilmLaw operator()(double ambient) const { return curve(ambient); }

    LawFormula formula;
    std::function<FilmLaw(double ambient)> curve;
};

}  // namespace deadpoint
