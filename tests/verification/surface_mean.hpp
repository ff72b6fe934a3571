#pragma once

#include "deadpoint/exchange/deformation.hpp"
#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/study/translate_heat.hpp"

#include <string>

namespace verification {

/// Mean of a displacement component over a surface.
inline deadpoint::Functional mean_over(const deadpoint::Machine& machine, const std::string& surface, int component)
{
    deadpoint::Functional result;
    double area = 0;
    for (const auto& entry : machine.surfaces[deadpoint::study::surface_index(machine, surface)].faces)
        for (const auto& point : deadpoint::face_points(machine, machine.faces[entry.face])) {
            deadpoint::PointWeight weight{entry.face, point.position, {}};
            weight.weight[component] = point.weight;
            area += point.weight;
            result.points.push_back(weight);
        }
    for (auto& point : result.points)
        point.weight[component] /= area;
    return result;
}

}  // namespace verification
