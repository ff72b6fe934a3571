#pragma once

#include "deadpoint/exchange/linkage.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

/// Linkages of the mechanism tests.
namespace linkages {

using namespace deadpoint;

inline LinkageJoint revolute(std::string name, int a, int b, Vec2 centre)
{
    return {std::move(name), LinkageJoint::Kind::revolute, a, b, centre, {0, 1}, true};
}
inline LinkageJoint slide(std::string name, int a, int b, Vec2 centre, Vec2 direction)
{
    return {std::move(name), LinkageJoint::Kind::slide, a, b, centre, direction, true};
}

/// Crank at the origin, assembled at outer dead point along x; the guide's line may be offset in y.
inline Linkage slider_crank(double crank, double rod, double offset = 0)
{
    const Vec2 pin{std::sqrt(std::pow(crank + rod, 2) - offset * offset), offset};
    const Vec2 crank_pin = (crank / (crank + rod)) * pin;
    Linkage linkage;
    linkage.bodies = {"frame", "crank", "rod", "slide"};
    linkage.joints = {revolute("crank_bearing", 1, 0, {0, 0}), revolute("crank_pin", 2, 1, crank_pin),
                      revolute("wrist_pin", 2, 3, pin), slide("guide", 3, 0, pin, {1, 0})};
    linkage.driver = 0;
    linkage.slide_body = 3;
    linkage.stroke_direction = {1, 0};
    return linkage;
}

/// Crank whose pin drives a block along a guide that itself turns about a fixed point.
inline Linkage quick_return()
{
    Linkage linkage;
    linkage.bodies = {"frame", "crank", "guide", "block"};
    linkage.joints = {revolute("crank_bearing", 1, 0, {0, 0}), revolute("pin", 1, 3, {0.1, 0.05}),
                      revolute("pivot", 2, 0, {0, -0.3}), slide("track", 3, 2, {0.1, 0.05}, {0.1, 0.35})};
    linkage.driver = 0;
    linkage.slide_body = 3;
    return linkage;
}

inline const nlohmann::json& row_at(const nlohmann::json& rows, double theta)
{
    for (const auto& row : rows)
        if (row["theta_deg"].get<double>() == theta)
            return row;
    throw std::runtime_error("no such crank angle in the reference data");
}

/// Bodies of twelve_body(), by the source's numbers.
inline const std::array<std::string, 12> twelve_body_names{"ground", "2", "3", "4",  "5",  "6",
                                                           "7",      "8", "9", "10", "11", "12"};

inline int body_of(std::string number)
{
    if (number.ends_with('R'))
        number.pop_back();  // right half
    for (int i = 1; i < 12; ++i)
        if (twelve_body_names[i] == number)
            return i;
    return -1;
}

/// Body that carries a joint of the reference data.
inline int carrier_of(const std::string& joint)
{
    if (joint == "23")
        return body_of("2");
    if (joint == "34")
        return body_of("3");
    if (joint == "56" || joint == "57")
        return body_of("5");
    if (joint == "78")
        return body_of("7");
    if (joint == "811")
        return body_of("8");
    if (joint == "910")
        return body_of("9");
    if (joint == "1112")
        return body_of("11");
    return -1;
}

/// Half of the paper's linkage (x >= 0), assembled from the joint positions at bottom dead point of the reference data.
inline Linkage twelve_body(const nlohmann::json& rows)
{
    const nlohmann::json& joints = row_at(rows, 270)["joint"];
    const auto at = [&](const char* name) { return joints[name]["p"].get<Vec2>(); };
    const Vec2 pivot_h{0, -0.79817};
    const Vec2 p18{0.39, -0.44};
    Linkage linkage;
    linkage.bodies.assign(twelve_body_names.begin(), twelve_body_names.end());
    const auto b = [](const char* number) { return body_of(number); };
    linkage.joints = {revolute("12", b("2"), 0, {0, 0}),
                      revolute("23", b("3"), b("2"), at("23")),
                      revolute("34", b("3"), b("4"), at("34")),
                      revolute("45", b("5"), b("4"), at("34")),
                      revolute("56", b("5"), b("6"), at("56")),
                      revolute("61", b("6"), 0, pivot_h),
                      revolute("57", b("5"), b("7"), at("57")),
                      revolute("78", b("7"), b("8"), at("78")),
                      revolute("89", b("9"), b("8"), at("78")),
                      revolute("81", b("8"), 0, p18),
                      revolute("910", b("9"), b("10"), at("910")),
                      revolute("811", b("11"), b("8"), at("811")),
                      revolute("1112", b("11"), b("12"), at("1112")),
                      slide("guide_4", b("4"), 0, at("34"), {0, 1}),
                      slide("guide_10", b("10"), 0, {0, at("910")[1]}, {0, 1}),
                      slide("guide_12", b("12"), 0, at("1112"), {0, 1})};
    linkage.driver = 0;
    linkage.slide_body = b("10");
    return linkage;
}

}  // namespace linkages
