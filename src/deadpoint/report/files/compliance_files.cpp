#include "deadpoint/report/files/compliance_files.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/study/result/press_compliance.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::report {
namespace {

constexpr double per_kilonewton = 1e3 * micrometre;  // from m/N to um/kN, and from 1/N to um/m per kN
constexpr double kilonewton_per_millimetre = 1e-6;   // from N/m

double largest_force(const casefile::Case& input)
{
    double largest = 0;
    for (const auto& segment : input.operation)
        largest = std::max(largest, segment.force);
    return largest;
}

}  // namespace

nlohmann::ordered_json compliance_json(const casefile::Case& input, const study::PressCompliance& compliance)
{
    nlohmann::ordered_json json;
    json["terms"] = "elastic opening of the gap under the process force at bottom dead point, apart from heat; frame, "
                    "table, slide, links and crankshaft as solids, without clearances, oil films, rolling elements, tool "
                    "and foundation";
    json["opening_um_per_kN"] = per_kilonewton * compliance.opening;
    json["stiffness_kN_per_mm"] = kilonewton_per_millimetre * compliance.stiffness();
    for (const auto& corner : compliance.corners)
        json["corners_um_per_kN"][corner.name] = per_kilonewton * corner.opening;
    if (!compliance.corners.empty()) {
        json["left_to_right_um_per_m_per_kN"] = per_kilonewton * compliance.left_right;
        json["front_to_back_um_per_m_per_kN"] = per_kilonewton * compliance.front_back;
    }
    for (const auto& segment : input.operation)
        if (segment.force > 0)
            json["segments"].push_back({{"name", segment.name},
                                        {"force_N", segment.force},
                                        {"opening_um", micrometre * compliance.opening * segment.force}});
    return json;
}

std::string compliance_text(const casefile::Case& input, const study::PressCompliance& compliance)
{
    std::string text =
        fmt::format("  static, apart from heat: {:.3g} um/kN open the gap, {:.4g} kN/mm of solid parts alone\n",
                    per_kilonewton * compliance.opening, kilonewton_per_millimetre * compliance.stiffness());
    const double force = largest_force(input);
    if (!(force > 0))
        return text;
    text += fmt::format("    at {:.4g} kN: {:.1f} um", 1e-3 * force, micrometre * compliance.opening * force);
    if (!compliance.corners.empty())
        text += fmt::format(", left to right {:+.1f} um/m, front to back {:+.1f} um/m",
                            micrometre * compliance.left_right * force, micrometre * compliance.front_back * force);
    return text + "\n";
}

}  // namespace deadpoint::report
