#include "deadpoint/report/page/named_things.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/names/pattern.hpp"

#include <algorithm>
#include <charconv>
#include <regex>
#include <string_view>

namespace deadpoint::report {
namespace {

using Kind = NamedThing::Kind;
using casefile::Case;

std::vector<std::string> split(std::string_view text, char at)
{
    std::vector<std::string> words;
    for (std::size_t begin = 0; begin <= text.size();) {
        const auto end = std::min(text.find(at, begin), text.size());
        words.emplace_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return words;
}

class Things {
public:
    explicit Things(const Case& input) : input_(input) {}

    std::vector<NamedThing> list;

    void add_path(const std::string& path)
    {
        const auto words = split(path, '.');
        if (words.size() >= 2)
            add_item(words[0], words[1], words);
        if (words.size() >= 2 && words[0] == "chain" && input_.chain)
            add_chain(words[1]);
    }

    /// By its name alone, of whatever kind.
    void add_name(const std::string& name)
    {
        if (input_.parts.contains(name))
            add(Kind::part, name);
        else if (input_.joints.contains(name))
            add(Kind::joint, name);
        else if (input_.probes.contains(name))
            add(Kind::probe, name);
        else if (input_.surfaces.contains(name))
            add(Kind::surface, name);
        else if (input_.bodies.contains(name))
            add(Kind::body, name);
        else
            add_interface(name);
    }

private:
    void add(Kind kind, const std::string& name)
    {
        const NamedThing thing{kind, name};
        if (std::ranges::find(list, thing) == list.end())
            list.push_back(thing);
    }

    void add_item(const std::string& section, const std::string& name, const std::vector<std::string>& words)
    {
        if (section == "parts" && input_.parts.contains(name))
            add(Kind::part, name);
        else if (section == "bodies" && input_.bodies.contains(name))
            add(Kind::body, name);
        else if (section == "probes" && input_.probes.contains(name))
            add(Kind::probe, name);
        else if (section == "surfaces" && input_.surfaces.contains(name))
            add(Kind::surface, name);
        else if (section == "joints" && input_.joints.contains(name))
            add_joint(name, words);
        else if (section == "heat_sources")
            add_heat(name);
        else if (section == "preload")
            add_rods(name);
    }

    void add_joint(const std::string& name, const std::vector<std::string>& words)
    {
        const auto before = list.size();
        if (words.size() >= 4 && words[2] == "interfaces")
            add_interface(name + "." + interface_name(input_.joints.at(name), words[3]));
        if (list.size() == before)
            add(Kind::joint, name);
    }

    /// Items of lists go by their number or their name.
    static std::string interface_name(const casefile::Joint& joint, const std::string& item)
    {
        std::size_t number = 0;
        const auto [end, error] = std::from_chars(item.data(), item.data() + item.size(), number);
        const bool counted = error == std::errc() && end == item.data() + item.size();
        return counted && number < joint.interfaces.size() ? joint.interfaces[number].name : item;
    }

    void add_interface(const std::string& name)
    {
        const auto dot = name.find('.');
        const auto joint = input_.joints.find(name.substr(0, dot));
        if (dot == std::string::npos || joint == input_.joints.end())
            return;
        const auto& interfaces = joint->second.interfaces;
        if (std::ranges::find(interfaces, name.substr(dot + 1), &casefile::Interface::name) != interfaces.end())
            add(Kind::interface, name);
    }

    void add_heat(const std::string& name)
    {
        const auto source = input_.heat_sources.find(name);
        if (source == input_.heat_sources.end())
            return;
        if (input_.surfaces.contains(source->second.surface))
            add(Kind::surface, source->second.surface);
        add_parts(source->second.parts);
    }

    void add_rods(const std::string& name)
    {
        if (const auto preload = input_.preload.find(name); preload != input_.preload.end())
            add_parts(preload->second.parts);
    }

    void add_parts(const std::vector<std::string>& patterns)
    {
        for (const auto& pattern : patterns)
            for (const auto& [part, unused] : input_.parts)
                if (matches(pattern, part))
                    add(Kind::part, part);
    }

    void add_chain(const std::string& key)
    {
        const auto& chain = *input_.chain;
        if (key == "crank_joint" || key == "bearing_play" || key == "reaction_angle")
            add_item("joints", chain.crank_joint, {});
        else if (key == "slide_surface" || key == "slide_body")
            add_item("surfaces", chain.slide_surface, {});
        else if (key == "table_surface")
            add_item("surfaces", chain.table_surface, {});
        else if (key == "ground_surface")
            add_item("surfaces", chain.ground_surface, {});
    }

    const Case& input_;
};

/// Calls back with each match of the first group of a pattern.
template <class Action>
void for_matches(const std::string& text, const std::regex& pattern, const Action& action)
{
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
        action((*it)[1].str());
}

}  // namespace

std::vector<NamedThing> things_of(const Diagnostic& found, const Case& input)
{
    static const std::regex quoted("'([^']+)'");
    static const std::regex keyed("\\b((?:parts|bodies|joints|surfaces|probes)(?:\\.\\w+)+)");
    Things things(input);
    things.add_path(found.path);
    if (!things.list.empty())
        return things.list;
    for_matches(found.message, keyed, [&](const std::string& path) { things.add_path(path); });
    for_matches(found.message, quoted, [&](const std::string& name) { things.add_name(name); });
    return things.list;
}

Diagnostic taken_apart(const std::string& warning)
{
    static const std::regex first("(?:(.*?):(\\d{1,9}):(\\d{1,9}): )?warning\\[([\\w-]+)\\](?:: (.*))?");
    static const std::regex indented("\\s{2}(\\S.*)");
    Diagnostic result;
    result.severity = DiagnosticSeverity::warning;
    const auto lines = split(warning, '\n');
    std::smatch head, line;
    if (!std::regex_match(lines.front(), head, first)) {
        const auto said = split_help(warning);
        result.message = said.message;
        result.help = said.help;
        return result;
    }
    if (head[1].matched)
        result.place = {head[1], std::stoi(head[2]), std::stoi(head[3])};
    result.code = head[4];
    result.path = head[5];
    static const std::string help = "  help: ";
    for (std::size_t i = 1; i < lines.size(); ++i)
        if (lines[i].starts_with(help))
            result.help = lines[i].substr(help.size());
        else if (i == 1 && std::regex_match(lines[i], line, indented))
            result.message = line[1];
    return result;
}

}  // namespace deadpoint::report
