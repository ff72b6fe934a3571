#pragma once

#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/exchange/laws/material.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/translate/lookup.hpp"
#include "deadpoint/press/translate/materials.hpp"
#include "solved_case.hpp"

/// A case's machine with its finite elements, for deformations without a run.
namespace verification {

struct Elastic {
    deadpoint::Machine machine;
    deadpoint::fem::Model model;

    explicit Elastic(const Case& input)
        : machine(meshed(input)), model(machine, deadpoint::press::describe_materials(input, machine),
                                        deadpoint::press::describe_orders(input, machine), observer())
    {}
    /// Functionals of the deformation for a temperature field above 20 degC.
    std::vector<double> values(const std::string& feet, const deadpoint::fem::Field& field,
                               const std::vector<deadpoint::Functional>& wanted)
    {
        model.support(deadpoint::press::surface_index(machine, feet));
        return model.evaluate(wanted, model.displacement(field, 293.15));
    }

private:
    static deadpoint::Observer& observer()
    {
        static deadpoint::Observer silent;
        return silent;
    }
    static deadpoint::Machine meshed(const Case& input)
    {
        return deadpoint::full::prepare_machine(input, 1, observer());
    }
};

/// The integral over a surface of weight(x) times a displacement component, faces by their share in the surface.
inline deadpoint::Functional integral_over(const deadpoint::Machine& machine, const std::string& surface,
                                           std::size_t component,
                                           const std::function<double(const deadpoint::Vec3&)>& weight)
{
    deadpoint::Functional result;
    for (const auto& entry : machine.surfaces[deadpoint::press::surface_index(machine, surface)].faces)
        for (const auto& point : deadpoint::face_points(machine, machine.faces[entry.face])) {
            deadpoint::PointWeight at{entry.face, point.position, {}};
            at.weight[component] = entry.fraction * point.weight * weight(point.position);
            result.points.push_back(at);
        }
    return result;
}

/// Mean of a displacement component over a surface.
inline deadpoint::Functional mean_over(const deadpoint::Machine& machine, const std::string& surface,
                                       std::size_t component)
{
    double area = 0;
    for (const auto& entry : machine.surfaces[deadpoint::press::surface_index(machine, surface)].faces)
        for (const auto& point : deadpoint::face_points(machine, machine.faces[entry.face]))
            area += entry.fraction * point.weight;
    return integral_over(machine, surface, component, [=](const deadpoint::Vec3&) { return 1 / area; });
}

}  // namespace verification
