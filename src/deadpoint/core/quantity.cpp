#include "deadpoint/core/quantity.hpp"

#include "deadpoint/core/names/suggest.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/error.hpp"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <udunits2.h>
#include <utility>
#include <vector>

namespace deadpoint {
namespace {

using D = Dimension;

constexpr std::array<DimensionInfo, 30> dimensions{{
    {D::none, "a plain number", "", "", "0.3"},
    {D::length, "a length", "m", "mm", "200 mm"},
    {D::area, "an area", "m^2", "m^2", "0.5 m^2"},
    {D::mass, "a mass", "kg", "kg", "184.5 kg"},
    {D::density, "a density", "kg/m^3", "kg/m^3", "7850 kg/m^3"},
    {D::time, "a time", "s", "s", "30 min"},
    {D::angle, "an angle", "rad", "deg", "90 deg"},
    {D::angular_velocity, "an angular velocity", "rad/s", "rpm", "200 rpm"},
    {D::velocity, "a velocity", "m/s", "um/h", "1 um/h"},
    {D::force, "a force", "N", "kN", "300 kN"},
    {D::power, "a power", "W", "W", "150 W"},
    {D::pressure, "a pressure", "Pa", "GPa", "210 GPa"},
    {D::temperature, "a temperature", "K", "degC", "20 degC"},
    {D::temperature_difference, "a temperature difference", "K", "K", "5 K"},
    {D::conductivity, "a thermal conductivity", "W/m/K", "W/m/K", "46 W/m/K"},
    {D::specific_heat, "a specific heat", "J/kg/K", "J/kg/K", "500 J/kg/K"},
    {D::heat_transfer_coefficient, "a heat transfer coefficient", "W/m^2/K", "W/m^2/K", "5 W/m^2/K"},
    {D::thermal_resistance, "a thermal resistance of an area", "m^2 K/W", "m^2 K/W", "6e-6 m^2 K/W"},
    {D::expansion, "a thermal expansion coefficient", "1/K", "1/K", "1.1e-5 1/K"},
    {D::kinematic_viscosity, "a kinematic viscosity", "m^2/s", "mm^2/s", "32 mm^2/s"},
    {D::stiffness, "a stiffness", "N/m", "N/m", "5e8 N/m"},
    {D::damping, "a damping coefficient", "N s/m", "N s/m", "1e4 N s/m"},
    {D::inertia, "a moment of inertia", "kg m^2", "kg m^2", "2.5 kg m^2"},
    {D::heat_flux, "a heat flux", "W/m^2", "W/m^2", "1 kW/m^2"},
    {D::thermal_conductance, "a thermal conductance", "W/K", "W/K", "20 W/K"},
    {D::volume, "a volume", "m^3", "L", "100 L"},
    {D::volume_flow, "a volume flow", "m^3/s", "L/min", "5 L/min"},
    {D::heat_capacity, "a heat capacity", "J/K", "J/K", "1200 J/K"},
    {D::acceleration, "an acceleration", "m/s^2", "m/s^2", "9.81 m/s^2"},
    {D::bedding, "a stiffness per area", "N/m^3", "N/mm^3", "0.5 N/mm^3"},
}};

/// value [SI] = factor * number + offset
struct Scale {
    double factor = 1;
    double offset = 0;
};

struct NamedScale {
    std::string_view unit;
    Dimension dimension;
    Scale scale;
};

constexpr double pi = std::numbers::pi;
/// Units read without UDUNITS-2: it takes an angle for a plain number, so it could not refuse a wrong one.
constexpr std::array named_scales{
    NamedScale{"deg", D::angle, {pi / 180, 0}},
    NamedScale{"degree", D::angle, {pi / 180, 0}},
    NamedScale{"degrees", D::angle, {pi / 180, 0}},
    NamedScale{"\u00b0", D::angle, {pi / 180, 0}},
    NamedScale{"rad", D::angle, {1, 0}},
    NamedScale{"mrad", D::angle, {1e-3, 0}},
    NamedScale{"rpm", D::angular_velocity, {pi / 30, 0}},
    NamedScale{"rad/s", D::angular_velocity, {1, 0}},
    NamedScale{"deg/s", D::angular_velocity, {pi / 180, 0}},
    NamedScale{"K", D::temperature, {1, 0}},
    NamedScale{"kelvin", D::temperature, {1, 0}},
    NamedScale{"degC", D::temperature, {1, zero_celsius}},
    NamedScale{"celsius", D::temperature, {1, zero_celsius}},
    NamedScale{"\u00b0C", D::temperature, {1, zero_celsius}},
    NamedScale{"degF", D::temperature, {5.0 / 9.0, 459.67 * 5.0 / 9.0}},
    NamedScale{"fahrenheit", D::temperature, {5.0 / 9.0, 459.67 * 5.0 / 9.0}},
    NamedScale{"\u00b0F", D::temperature, {5.0 / 9.0, 459.67 * 5.0 / 9.0}},
};

const NamedScale* named_scale(std::string_view unit)
{
    for (const auto& entry : named_scales) {
        if (entry.unit == unit) {
            return &entry;
        }
    }
    return nullptr;
}

/// The number at the start of the text, independent of the locale; infinite if it is too large.
double number_in(std::string_view text)
{
    if (text.starts_with('+')) {
        text.remove_prefix(1);
    }
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    return result.ec == std::errc::result_out_of_range ? HUGE_VAL : value;
}

struct FreeUnit {
    void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct FreeConverter {
    void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;
using Converter = std::unique_ptr<cv_converter, FreeConverter>;

/// The unit database. UDUNITS-2 keeps shared state, so every use of it holds the lock.
class UnitSystem {
public:
    static UnitSystem& instance()
    {
        static UnitSystem system;
        return system;
    }
    UnitSystem(const UnitSystem&) = delete;
    UnitSystem& operator=(const UnitSystem&) = delete;

    [[nodiscard]] bool knows(const std::string& unit)
    {
        const std::scoped_lock lock(mutex_);
        return parse(unit) != nullptr;
    }

    /// Scale from `unit` to `si`; nothing if their dimensions differ or the relation is not linear.
    [[nodiscard]] std::optional<Scale> scale(const std::string& unit, const std::string& si)
    {
        const std::scoped_lock lock(mutex_);
        if (const auto known = scales_.find({unit, si}); known != scales_.end()) {
            return known->second;
        }
        if (scales_.size() >= most_scales) {
            scales_.clear();
        }
        return scales_[{unit, si}] = found_scale(unit, si);
    }

private:
    static constexpr std::size_t most_scales = 1000;  // a hostile file may name any number of units

    [[nodiscard]] std::optional<Scale> found_scale(const std::string& unit, const std::string& si)
    {
        const Unit from = parse(unit);
        ut_unit* const to = si_unit(si);
        if (!from || to == nullptr || ut_are_convertible(from.get(), to) == 0) {
            return std::nullopt;
        }
        const Converter converter(ut_get_converter(from.get(), to));
        if (!converter) {
            return std::nullopt;
        }
        const double offset = cv_convert_double(converter.get(), 0.0);
        const double factor = cv_convert_double(converter.get(), 1.0) - offset;
        const double check = cv_convert_double(converter.get(), 8.0);
        const bool is_line = std::abs(check - (8.0 * factor + offset)) <= 1e-12 * (std::abs(check) + std::abs(offset));
        if (!is_line || !(factor > 0)) {
            return std::nullopt;
        }
        // The database's arithmetic leaves noise in the last digit (an inch is 0.025400000000000002 m).
        return Scale{number_in(fmt::format("{:.15g}", factor)), offset};
    }

    UnitSystem()
    {
        ut_set_error_message_handler(ut_ignore);
        system_ = ut_read_xml(nullptr);
        if (system_ == nullptr) {
            system_ = ut_read_xml("/usr/share/xml/udunits/udunits2.xml");
        }
        if (system_ == nullptr) {
            throw IoError("the unit database of UDUNITS-2 cannot be read: install libudunits2-data, or set "
                          "UDUNITS2_XML_PATH to udunits2.xml");
        }
    }
    ~UnitSystem()
    {
        si_units_.clear();
        ut_free_system(system_);
    }

    [[nodiscard]] Unit parse(const std::string& unit) const { return Unit(ut_parse(system_, unit.c_str(), UT_UTF8)); }
    [[nodiscard]] ut_unit* si_unit(const std::string& si)
    {
        auto& unit = si_units_[si];
        if (!unit) {
            unit = parse(si);
        }
        return unit.get();
    }

    ut_system* system_ = nullptr;
    std::map<std::string, Unit> si_units_;  ///< SI units of our dimensions, parsed
    std::map<std::pair<std::string, std::string>, std::optional<Scale>> scales_;  ///< by unit and SI unit
    std::mutex mutex_;
};

std::string_view trim(std::string_view text)
{
    const auto first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// What follows a number that was written "1.000.000 N", "100 000 N" or "100'000 N".
bool has_mark_in_number(std::string_view unit)
{
    const auto digit = [&](std::size_t at) {
        return unit.size() > at && std::isdigit(static_cast<unsigned char>(unit[at])) != 0;
    };
    const bool mark = unit.starts_with('.') || unit.starts_with('\'');
    // "1/min" is a unit that begins with a digit.
    return (mark && digit(1)) || (digit(0) && !unit.starts_with("1/") && !unit.starts_with("1 /"));
}

/// Whether the text after a number continues with a comma and a digit: "293,15 K", "1,000 mm".
bool has_decimal_comma(std::string_view rest)
{
    return rest.size() > 1 && rest[0] == ',' && rest[1] >= '0' && rest[1] <= '9';
}

bool is_angular(Dimension d) { return d == D::angle || d == D::angular_velocity; }

/// Refuses what UDUNITS-2 would take as arithmetic or as a shifted origin ("5 mm", "m @ 3", "K from 273").
bool has_unit_syntax(std::string_view unit)
{
    const bool starts_well = (unit.front() < '0' || unit.front() > '9') || unit.starts_with("1/");
    if (!starts_well || unit.front() == '-' || unit.front() == '+' || unit.front() == '.') {
        return false;
    }
    for (const std::string_view refused : {"@", " from ", " since ", " after ", " ref ", "lg(", "ln(", "lb("}) {
        if (unit.find(refused) != std::string_view::npos) {
            return false;
        }
    }
    return true;
}

const DimensionInfo* dimension_of(std::string_view unit)
{
    if (const auto* named = named_scale(unit)) {
        return &dimension_info(named->dimension);
    }
    for (const auto& info : dimensions) {
        const bool skip = info.dimension == D::none || is_angular(info.dimension) ||
                          info.dimension == D::temperature_difference || info.si_unit.empty();
        if (!skip && UnitSystem::instance().scale(std::string(unit), std::string(info.si_unit))) {
            return &info;
        }
    }
    return nullptr;
}

std::optional<Scale> unit_scale(std::string_view unit, Dimension dimension)
{
    if (is_angular(dimension) || dimension == D::temperature) {
        const auto* named = named_scale(unit);
        return named != nullptr && named->dimension == dimension ? std::optional(named->scale) : std::nullopt;
    }
    const auto* named = named_scale(unit);
    if (named != nullptr && is_angular(named->dimension)) {
        return std::nullopt;
    }
    auto scale = UnitSystem::instance().scale(std::string(unit), std::string(dimension_info(dimension).si_unit));
    if (scale && scale->offset != 0) {
        return std::nullopt;
    }
    return scale;
}

/// k where `factor` is 10^k up to the noise of the database's arithmetic, k != 0.
std::optional<int> power_of_ten(double factor)
{
    const double exponent = std::round(std::log10(factor));
    const bool is_power = exponent != 0 && std::abs(factor / std::pow(10.0, exponent) - 1) < 1e-13;
    return is_power ? std::optional(static_cast<int>(exponent)) : std::nullopt;
}

/// @param digits  text of the number: decimal factors move its point, so that no digit is rounded twice
double to_si(std::string_view digits, double number, const Scale& scale)
{
    const auto shift = scale.offset == 0 ? power_of_ten(scale.factor) : std::nullopt;
    if (!shift || number == 0) {  // a zero may have any exponent
        return number * scale.factor + scale.offset;
    }
    const auto e = digits.find_first_of("eE");
    const int own = e == std::string_view::npos ? 0 : static_cast<int>(number_in(digits.substr(e + 1)));
    return number_in(fmt::format("{}e{}", digits.substr(0, e), own + *shift));
}

QuantityProblem mismatch(std::string_view unit, const DimensionInfo& wanted)
{
    const std::string example = fmt::format("write it like \"{}\"", wanted.example);
    if (wanted.dimension == D::temperature_difference) {
        const auto* named = named_scale(unit);
        if (named != nullptr && named->dimension == D::temperature) {
            return {"unit-mismatch",
                    fmt::format("'{}' is a point on a scale, but this key needs {}", unit, wanted.name),
                    "write K, like \"5 K\" (a difference of 1 degC is 1 K, one of 9 degF is 5 K)"};
        }
    }
    if (wanted.dimension == D::angular_velocity && (unit == "Hz" || unit == "1/s" || unit == "1/min")) {
        return {"unit-mismatch", fmt::format("'{}' does not say whether turns or radians are counted", unit), example};
    }
    if (const auto* found = dimension_of(unit)) {
        return {"unit-mismatch", fmt::format("'{}' is {}, but this key needs {}", unit, found->name, wanted.name),
                example};
    }
    return {"unit-mismatch", fmt::format("'{}' is not {}", unit, wanted.name), example};
}

QuantityProblem unknown_unit(std::string_view unit, const DimensionInfo& wanted)
{
    static const std::vector<std::string> common{
        "mm",  "m",      "um",  "in",    "kg",    "g",      "t",     "s",      "min",     "h",
        "deg", "rad",    "rpm", "rad/s", "N",     "kN",     "MN",    "W",      "kW",      "Pa",
        "MPa", "GPa",    "K",   "degC",  "degF",  "kg/m^3", "W/m/K", "J/kg/K", "W/m^2/K", "m^2 K/W",
        "1/K", "mm^2/s", "cSt", "N/m",   "N s/m", "kg m^2", "W/m^2", "um/h",   "mm/s"};
    std::vector<std::string> fitting;
    for (const auto& name : common) {
        if (unit_scale(name, wanted.dimension)) {
            fitting.push_back(name);
        }
    }
    const std::string suggestion = closest_name(unit, fitting);
    std::string help = fmt::format("write it like \"{}\"", wanted.example);
    if (!suggestion.empty()) {
        help = fmt::format("did you mean '{}'? {}", suggestion, help);
    }
    return {"unknown-unit", fmt::format("'{}' is not a known unit; this key needs {}", unit, wanted.name), help};
}

/// `number` with the fewest digits that give `value` exactly when read with `unit`.
std::optional<std::string> exact_text(double value, double number, std::string_view unit, Dimension dimension)
{
    for (const int digits : {12, 14, 15, 16, 17}) {
        const double rounded = number_in(fmt::format("{:.{}g}", number, digits));
        std::string text = fmt::format("{} {}", rounded, unit);
        const auto back = try_parse_quantity(text, dimension);
        if (const auto* read = std::get_if<double>(&back); read != nullptr && *read == value) {
            return text;
        }
    }
    return std::nullopt;
}

}  // namespace

const DimensionInfo& dimension_info(Dimension dimension) { return dimensions.at(static_cast<std::size_t>(dimension)); }

std::span<const DimensionInfo> all_dimensions() { return dimensions; }

std::variant<double, QuantityProblem> try_parse_quantity(std::string_view text, Dimension dimension)
{
    const auto& wanted = dimension_info(dimension);
    const std::string example = fmt::format("write it like \"{}\"", wanted.example);
    std::string_view body = trim(text);
    if (body.starts_with('+')) {
        body.remove_prefix(1);
    }
    double number = 0;
    const auto [end, error] = std::from_chars(body.data(), body.data() + body.size(), number);
    if (error == std::errc::result_out_of_range) {
        return QuantityProblem{"not-finite", fmt::format("'{}' is beyond the range of numbers", text), example};
    }
    if (error != std::errc()) {
        return QuantityProblem{"not-a-quantity", fmt::format("'{}' does not begin with a number", text), example};
    }
    if (!std::isfinite(number)) {
        return QuantityProblem{"not-finite", fmt::format("'{}' is not a finite number", text), example};
    }
    const std::string_view unit = trim(body.substr(static_cast<std::size_t>(end - body.data())));
    if (has_decimal_comma(unit)) {
        return QuantityProblem{
            "decimal-comma", fmt::format("'{}' has a comma in its number", text),
            fmt::format("write decimals with a point and thousands without any mark, like \"{}\"", wanted.example)};
    }
    if (has_mark_in_number(unit)) {
        return QuantityProblem{
            "marks-in-number", fmt::format("'{}' has a mark or a space within its number", text),
            fmt::format("write decimals with a point and thousands without any mark, like \"{}\"", wanted.example)};
    }
    if (dimension == D::none) {
        if (unit.empty()) {
            return number;
        }
        return QuantityProblem{"unit-mismatch", fmt::format("'{}' is a unit, but this key is a plain number", unit),
                               example};
    }
    if (unit.empty()) {
        return QuantityProblem{"missing-unit", fmt::format("'{}' has no unit; this key needs {}", text, wanted.name),
                               example};
    }
    const bool is_named = named_scale(unit) != nullptr, is_read = is_named || has_unit_syntax(unit);
    const auto scale = is_read ? unit_scale(unit, dimension) : std::nullopt;
    if (!scale) {
        const bool is_known = is_named || (is_read && UnitSystem::instance().knows(std::string(unit)));
        return is_known ? mismatch(unit, wanted) : unknown_unit(unit, wanted);
    }
    const double value = to_si(body.substr(0, static_cast<std::size_t>(end - body.data())), number, *scale);
    if (!std::isfinite(value)) {
        return QuantityProblem{"not-finite", fmt::format("'{}' is beyond the range of numbers", text), example};
    }
    return value;
}

double parse_quantity(std::string_view text, Dimension dimension)
{
    const auto result = try_parse_quantity(text, dimension);
    if (const auto* problem = std::get_if<QuantityProblem>(&result)) {
        throw InputError(problem->message + ": " + problem->help);
    }
    return std::get<double>(result);
}

std::string format_quantity(double value, Dimension dimension)
{
    const auto& info = dimension_info(dimension);
    if (dimension == D::none) {
        return format_number(value);
    }
    if (const auto scale = unit_scale(info.preferred, dimension)) {
        const double number = (value - scale->offset) / scale->factor;
        if (auto text = exact_text(value, number, info.preferred, dimension)) {
            return *text;
        }
    }
    return fmt::format("{} {}", value, info.si_unit);
}

std::string format_number(double value)
{
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".en") == std::string::npos) {
        text += ".0";
    }
    return text;
}

}  // namespace deadpoint
