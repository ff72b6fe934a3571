#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/drift/chain.hpp"
#include "deadpoint/exchange/bare_machine.hpp"
#include "deadpoint/reduce/online/dense_terms.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"

#include <cmath>
#include <memory>
#include <utility>

/// A reduced press without any build: each part of a case is a lump of one temperature and, for its gap, one expansion.
/// It has all that a real one has, so it runs, and its files are read like those of `deadpoint reduce`.
class LumpedPress {
public:
    LumpedPress(const deadpoint::casefile::Case& input, const deadpoint::Machine& machine)
        : machine_(without_mesh(machine)), parts_(static_cast<Eigen::Index>(machine.parts.size()))
    {
        describe(input);
        add_joints();
        add_pieces(input);
        terms_.functionals.resize(static_cast<Eigen::Index>(terms_.geometry.layout.count()), parts_);
        fill_functionals(input);
        if (input.chain)
            observe();
        press_.machine = std::move(machine_);
        press_.terms = std::make_shared<const deadpoint::reduce::PreparedTerms>(std::move(terms_));
        press_.states = static_cast<std::size_t>(parts_);
    }
    [[nodiscard]] deadpoint::twin::ReducedPress press() const { return press_; }

private:
    using Vector = Eigen::VectorXd;

    void describe(const deadpoint::casefile::Case& input)
    {
        press_.version = "test";
        press_.name = input.machine.name;
        press_.case_hash = "of the test";
        press_.fixed_part = deadpoint::twin::fixed_part(input);
        press_.cells = press_.unknowns = 100;
        press_.reference = input.machine.initial_temperature;
        press_.box = {{"ambient", deadpoint::reduce::FreeCoefficient::Kind::ambient, {0}, {press_.reference}, -10, 10}};
        press_.errors = {{"anywhere in the box, to the large model", 0.1, 1e-7}};
        auto& layout = terms_.geometry.layout;
        layout.parts = machine_.parts.size();
        layout.interfaces = machine_.interfaces.size();
        layout.bodies = input.heat_sources.size();
        layout.probes = input.probes.size();
        terms_.solid = Eigen::MatrixXd::Zero(parts_, parts_);
        terms_.parts = Eigen::MatrixXd::Zero(parts_, parts_);
        for (Eigen::Index p = 0; p < parts_; ++p)
            terms_.parts(p, p) = root_of_capacity(static_cast<std::size_t>(p));
        terms_.uniform = terms_.parts.rowwise().sum();
    }
    // States are temperatures times the roots of the capacities [(J K)^(1/2)].
    [[nodiscard]] double root_of_capacity(std::size_t part) const { return std::sqrt(460 * machine_.parts[part].mass); }
    // States to the temperature of a part [K].
    [[nodiscard]] Vector of_part(std::size_t part) const
    {
        Vector row = Vector::Zero(parts_);
        row[static_cast<Eigen::Index>(part)] = 1 / root_of_capacity(part);
        return row;
    }

    void add_joints()
    {
        for (const auto& contact : machine_.interfaces) {
            const double root = std::sqrt(contact.area);
            const Vector a = root * of_part(contact.part_a), b = root * of_part(contact.part_b);
            terms_.joints.push_back({{a}, {b}, {a - b}, {a - b}});
            terms_.geometry.interface_names.push_back(contact.name);
            terms_.geometry.interface_area.push_back(contact.area);
        }
    }

    // Conditions of surfaces, part by part.
    void add_pieces(const deadpoint::casefile::Case& input)
    {
        for (const auto& surface : machine_.surfaces) {
            const auto& given = input.surfaces.at(surface.name);
            if (!given.film && !given.temperature && given.temperature_formula.empty() && !given.heat_flux)
                continue;
            for (const auto& [part, area] : surface.figures.parts) {
                terms_.films.push_back({std::sqrt(area) * of_part(part)});
                terms_.geometry.surface_area.push_back(area);
                pieces_.emplace_back(part, area);
            }
        }
        terms_.geometry.layout.surfaces = pieces_.size();
    }

    void fill_functionals(const deadpoint::casefile::Case& input)
    {
        const auto& layout = terms_.geometry.layout;
        auto& rows = terms_.functionals;
        rows.setZero();
        const auto set = [&](std::size_t row, const Vector& to) {
            rows.row(static_cast<Eigen::Index>(row)) = to.transpose();
        };
        for (std::size_t i = 0; i < layout.interfaces; ++i) {
            set(layout.mean(i, false), of_part(machine_.interfaces[i].part_a));
            set(layout.mean(i, true), of_part(machine_.interfaces[i].part_b));
        }
        for (std::size_t p = 0; p < layout.parts; ++p)
            set(layout.part(p), of_part(p));
        for (std::size_t s = 0; s < layout.surfaces; ++s)
            set(layout.surface(s), pieces_[s].second * of_part(pieces_[s].first));
        for (std::size_t k = 0; k < layout.bodies; ++k)
            set(layout.body(k), of_part(0));
        std::size_t probe = 0;
        for (const auto& [name, at] : input.probes) {
            for (std::size_t p = 0; p < layout.parts; ++p)
                if (machine_.parts[p].name == at.part)
                    set(layout.probe(probe), of_part(p));
            ++probe;
        }
    }

    // Dimensions and the growth of one bearing, then E_SW and the growth part by part.
    void observe()
    {
        constexpr Eigen::Index bearings = 1, meant = deadpoint::drift::dimension_count + bearings;
        press_.adjoints = static_cast<std::size_t>(meant);
        press_.first_frame = press_.adjoints;
        press_.chain.emplace();
        press_.chain->figures = {static_cast<int>(bearings), 0.5, 1};
        press_.chain->first_gap = press_.adjoints;
        auto& rows = terms_.observed;
        rows.setZero(meant + (1 + bearings) * parts_, parts_);
        for (Eigen::Index p = 0; p < parts_; ++p) {
            const Vector row = 1e-6 * of_part(static_cast<std::size_t>(p));  // a micrometre a kelvin
            for (Eigen::Index k = 0; k < meant; ++k)
                rows.row(k) += (p % 2 == 0 ? 1.0 : -1.0) * row.transpose();
            rows.row(meant + p) = (p % 2 == 0 ? 1.0 : -1.0) * row.transpose();
            rows.row(meant + parts_ + p) = rows.row(meant + p);
        }
    }

    deadpoint::Machine machine_;
    Eigen::Index parts_;
    deadpoint::reduce::DenseTerms terms_;
    std::vector<std::pair<std::size_t, double>> pieces_;  ///< part and area [m2]
    deadpoint::twin::ReducedPress press_;
};
