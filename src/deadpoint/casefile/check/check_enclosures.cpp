#include "deadpoint/casefile/check/check_enclosures.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/case_films.hpp"
#include "deadpoint/casefile/describe/case_heat.hpp"
#include "deadpoint/casefile/describe/findings.hpp"

#include <fmt/format.h>

namespace deadpoint::casefile {
namespace {

std::optional<Finding> check_film(const std::string& path, const std::string& name, const Surface& surface)
{
    const auto wrong = [&](const std::string& message, const std::string& help) {
        return Finding{"inconsistent", path, message, help};
    };
    if (!surface.film)
        return wrong(fmt::format("surface '{}' has no `film` to the air of the enclosure", name),
                     fmt::format("add film = {{ coefficient = \"5 W/m^2/K\" }} to [surfaces.{}]", name));
    if (surface.film->ambient)
        return wrong(fmt::format("the film of surface '{}' states its own `ambient`", name),
                     "remove it: the enclosure gives the temperature of the air");
    if (std::holds_alternative<EnclosedFilm>(surface.film->law))
        return wrong(fmt::format("the film of surface '{}' already includes enclosed air", name),
                     "choose a law of open air, like \"vertical\"");
    return {};
}

// A surface that radiates inside an enclosure, where no other does.
std::optional<Finding> check_radiation(const Case& c, const std::string& name, const Enclosure& enclosure)
{
    std::string last;
    int count = 0;
    for (const auto& surface : enclosure.surfaces)
        if (const auto found = c.surfaces.find(surface);
            found != c.surfaces.end() && found->second.film && found->second.film->emissivity > 0) {
            last = surface;
            ++count;
        }
    if (count != 1)
        return {};
    return Finding{
        "unused", fmt::format("surfaces.{}.film.emissivity", last),
        fmt::format("surface '{}' radiates to nothing: no other surface of enclosure '{}' states an emissivity", last,
                    name),
        "state an emissivity for the others too, or remove this one", true};
}

}  // namespace

std::vector<Finding> check_enclosures(const Case& c)
{
    std::vector<Finding> findings;
    std::map<std::string, std::string> faced;
    for (const auto& [name, enclosure] : c.enclosures) {
        if (auto finding = check_radiation(c, name, enclosure))
            findings.push_back(std::move(*finding));
        for (std::size_t i = 0; i < enclosure.surfaces.size(); ++i) {
            const auto found = c.surfaces.find(enclosure.surfaces[i]);
            if (found == c.surfaces.end())
                continue;
            const auto path = fmt::format("enclosures.{}.surfaces.{}", name, i);
            if (auto finding = check_film(path, found->first, found->second))
                findings.push_back(std::move(*finding));
            const auto [other, fresh] = faced.emplace(found->first, name);
            if (!fresh)
                findings.push_back({"duplicate-name", path,
                                    fmt::format("surface '{}' faces two enclosures", found->first),
                                    fmt::format("name it once; enclosure '{}' has it already", other->second)});
        }
    }
    return findings;
}

}  // namespace deadpoint::casefile
