#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace deadpoint::press {
struct LoadsResult;
struct ViewData;
}  // namespace deadpoint::press

namespace deadpoint {
struct DecimatedSurface;
struct Machine;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}

/// The light data of a run that its page shows in motion: view.json and motion.json.
namespace deadpoint::report {

/// Values as 16-bit numbers: value = low + step * number, off by at most half a step.
struct Quantised {
    double low = 0;
    double step = 0;  ///< 0 where all values are the same
    std::vector<std::uint16_t> numbers;
};
/// @throws DomainError if a value is not finite
Quantised quantise(std::span<const double> values);

/// Base64 (RFC 4648) of the bytes.
std::string base64(std::span<const std::uint8_t> bytes);

/// 16-bit numbers, little-endian, in base64.
std::string packed(std::span<const std::uint16_t> numbers);

/// The keys of a surface and its parts, as in view.json: half_model, merged_within_m, vertices, positions_m, parts.
nlohmann::ordered_json surface_json(const Machine& machine, const DecimatedSurface& surface);

/// Unit vectors of front, left and up of a case, as in view.json; the usual ones where the case contradicts itself.
nlohmann::ordered_json directions_json(const casefile::Case& input);

/// Surface, parts, probes, and temperature [K] and displacement [m] as modes over time. Numbers in `data` are unsigned
/// 16-bit integers, little-endian, in base64; a vector's components follow each other.
nlohmann::ordered_json view_json(const casefile::Case& input, const Machine& machine, const press::ViewData& view);

/// Poses of the bodies and places of the joints at up to 120 crank angles over a turn from bottom dead point.
nlohmann::ordered_json motion_json(const press::LoadsResult& loads);

}  // namespace deadpoint::report
