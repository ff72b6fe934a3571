#include "deadpoint/exchange/solid_print.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>

namespace deadpoint {
namespace {

constexpr double litre = 1e-3;
constexpr double millimetre = 1e-3;

/// Millimetres to a tenth of a micrometre, without zeros at the end; never -0.
double rounded(double length) { return std::round(length / millimetre * 1e4) / 1e4 + 0.0; }

}  // namespace

std::string text_of(const SolidPrint& print)
{
    const auto& [x, y, z] = print.centre;
    return fmt::format("{:.5g} L, {} x {} x {} mm at ({}, {}, {}) mm", print.volume / litre, rounded(print.size[0]),
                       rounded(print.size[1]), rounded(print.size[2]), rounded(x), rounded(y), rounded(z));
}

std::optional<SolidPrint> solid_print(const std::string& text)
{
    SolidPrint print;
    auto& [volume, size, centre] = print;
    int end = 0;
    const int read = std::sscanf(text.c_str(), "%lf L, %lf x %lf x %lf mm at (%lf, %lf, %lf) mm%n", &volume, &size[0],
                                 &size[1], &size[2], &centre[0], &centre[1], &centre[2], &end);
    const std::array<double, 7> all{volume, size[0], size[1], size[2], centre[0], centre[1], centre[2]};
    const bool sound = std::ranges::all_of(all, [](double value) { return std::isfinite(value); }) && volume >= 0 &&
                       std::ranges::all_of(size, [](double edge) { return edge >= 0; });
    if (read != 7 || end != static_cast<int>(text.size()) || !sound) {
        return std::nullopt;
    }
    const auto metres = [](const Vec3& lengths) { return millimetre * lengths; };
    return SolidPrint{volume * litre, metres(size), metres(centre)};
}

std::string text_of(const SolidReference& reference)
{
    return reference.fingerprint.empty() ? reference.name : reference.name + "\n" + reference.fingerprint;
}

SolidReference solid_reference(const std::string& text)
{
    const auto end = text.find('\n');
    return {text.substr(0, end), end == std::string::npos ? "" : text.substr(end + 1)};
}

}  // namespace deadpoint
