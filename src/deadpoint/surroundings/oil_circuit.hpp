#pragma once

#include <cstddef>
#include <vector>

/// Circulating oil that cools the joints of a press one after the other.
namespace deadpoint::surroundings {

/// Where the oil goes after the last joint.
struct Sump {
    /// True: a cooler (or heater) brings the oil back to the inlet temperature. False: the inlet follows from the sump.
    bool cooler = true;
    double loss = 0;          ///< conductance from the sump to the ambient [W/K], >= 0
    double ambient = 293.15;  ///< [K]
};

/// A circuit and the joints it serves, in the order in which the oil reaches them.
struct OilCircuit {
    double inlet_temperature = 0;     ///< at the first joint [K]; unused without a cooler
    double mass_flow = 0;             ///< [kg/s], >= 0
    double heat_capacity = 0;         ///< c of the oil [J/kg/K], > 0 (mineral oil about 1900)
    std::vector<double> conductance;  ///< h A between joint film and oil, per joint [W/K], >= 0
    Sump sump;
};

/// Mass flow from volume flow [m3/s] and density [kg/m3].
double mass_flow_of(double volume_flow, double density);

/// What the oil's warming within a joint leaves of its coefficient against the oil that arrives: e / N = (1 - exp(-N))
/// / N with N = h A / (m c); 1 at N = 0, 0 at infinite N.
double mean_approach(double transfer_units);

/// A quantity per joint i that is linear in the joints' film temperatures: y_i = offset_i + sum_j matrix_ij T_j.
struct JointMap {
    std::vector<double> offset;  ///< one per joint
    std::vector<double> matrix;  ///< row-major, joints x joints: derivative of y_i by T_j

    /// @param temperatures  one per joint [K]
    [[nodiscard]] std::vector<double> operator()(const std::vector<double>& temperatures) const;
};

/// What the oil does at given film temperatures.
struct OilState {
    std::vector<double> inlet;      ///< where the oil reaches the joint [K]
    std::vector<double> outlet;     ///< where it leaves it [K]
    std::vector<double> mean;       ///< the oil temperature with heat = h A (T_film - mean) [K]
    std::vector<double> heat;       ///< taken from the joint, negative where the oil warms it [W]
    double inlet_temperature = 0;   ///< of the circuit [K]
    double return_temperature = 0;  ///< after the last joint [K]
    double total_heat = 0;          ///< sum of `heat` = m c (return - inlet) [W]
    double sump_loss = 0;           ///< from the sump to the ambient [W]
    double cooler_power = 0;        ///< taken by the cooler; negative: a heater [W]; zero without one
};

/// The oil along its way, a linear problem in the film temperatures T_j, solved once per circuit.
///
/// At joint i the oil warms from t_i towards the film temperature as in a heat exchanger with one side at constant
/// temperature (Kays and London, Compact Heat Exchangers):
///
///   e_i = 1 - exp(-N_i), N_i = h A_i / (m c),   t_(i+1) = t_i + e_i (T_i - t_i),   Q_i = h A_i (e_i / N_i) (T_i - t_i)
///
/// and the oil temperature that a film with the full conductance h A_i sees is mean_i = T_i - Q_i / (h A_i). Oil that
/// does not flow takes no heat; oil that flows without limit stays at the inlet temperature. The sump is well mixed and
/// steady: its temperature t_s follows from m c (return - t_s) = loss (t_s - ambient), and the cooler takes
/// m c (t_s - inlet), that is m c (return - inlet) where the sump loses nothing. Without a cooler inlet = t_s.
/// Left out: heat stored in oil and pipes, heat lost along the pipes, the pump's power, viscosity over temperature.
class OilLine {
public:
    /// @throws InputError if a flow, capacity, conductance or temperature is outside its range or not finite, or if
    ///         nothing fixes the temperature of the oil (no cooler, no loss, no joint that exchanges heat)
    explicit OilLine(const OilCircuit& circuit);

    /// @param film_temperatures  one per joint [K]
    /// @throws InputError if their number differs; DomainError if one is not finite
    [[nodiscard]] OilState at(const std::vector<double>& film_temperatures) const;

    /// Heat taken from each joint [W]; its matrix [W/K] is lower triangular with a cooler. A joint warms only those
    /// after it, so the entries off the diagonal are not above zero.
    [[nodiscard]] const JointMap& heat() const { return heat_; }
    /// Mean oil temperature at each joint [K].
    [[nodiscard]] const JointMap& mean_oil() const { return mean_; }
    [[nodiscard]] std::size_t joints() const { return circuit_.conductance.size(); }

private:
    /// Oil temperatures before each joint and after the last one.
    [[nodiscard]] std::vector<double> walk(double inlet, const std::vector<double>& film_temperatures) const;
    /// Inlet temperature without a cooler, above the ambient, with film temperatures above it too.
    [[nodiscard]] double relative_inlet(const std::vector<double>& relative_films) const;
    void build_maps();

    OilCircuit circuit_;
    double capacity_flow_ = 0;           ///< m c [W/K]
    std::vector<double> effectiveness_;  ///< e_i
    std::vector<double> approach_;       ///< e_i / N_i
    JointMap heat_;
    JointMap mean_;
};

}  // namespace deadpoint::surroundings
