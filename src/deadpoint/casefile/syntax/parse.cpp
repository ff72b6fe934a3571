#include "deadpoint/casefile/syntax/document.hpp"
#include "deadpoint/error.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>
#include <string>

// Version 3.3 of toml++ asserts on some malformed texts. The Scanner below catches the known ones first; an
// assertion that is still reached becomes an error message instead of the end of the program.
constexpr void require_in_parser(bool holds)
{
    if (!holds) {
        throw std::logic_error("assertion in the TOML parser");
    }
}
#define TOML_ASSERT(expression) require_in_parser(static_cast<bool>(expression))
#include <toml++/toml.h>

namespace deadpoint::casefile {
namespace {

constexpr std::size_t most_nested = 40;
// A value takes about a hundred times its text in memory.
constexpr std::size_t most_values = 1'000'000;

struct Complaint {
    int line = 0;
    int column = 0;
    std::string message;
    std::string help;
};

/// Scans a TOML text outside of strings and comments for constructs that toml++ 3.3 does not handle safely.
class Scanner {
public:
    explicit Scanner(const std::string& text) : text_(text) {}

    /// @return the first error, if any
    std::optional<Complaint> run()
    {
        while (!complaint_ && position_ < text_.size()) {
            step();
        }
        if (!complaint_ && !open_.empty()) {
            complain(fmt_open(open_.back()), "close it", open_.back().line, open_.back().column);
        }
        return complaint_;
    }

private:
    struct Bracket {
        char closing;
        int line;
        int column;
    };

    static std::string fmt_open(const Bracket& bracket)
    {
        return std::string("this '") + (bracket.closing == ']' ? '[' : '{') + "' is never closed";
    }

    void complain(std::string message, std::string help, int line, int column)
    {
        if (!complaint_) {
            complaint_ = Complaint{line, column, std::move(message), std::move(help)};
        }
    }
    void complain(std::string message, std::string help)
    {
        complain(std::move(message), std::move(help), line_, column_);
    }

    [[nodiscard]] char peek(std::size_t ahead = 0) const
    {
        return position_ + ahead < text_.size() ? text_[position_ + ahead] : '\0';
    }

    void advance(std::size_t count = 1)
    {
        for (; count > 0 && position_ < text_.size(); --count, ++position_) {
            if (text_[position_] == '\n') {
                ++line_;
                column_ = 1;
                begins_line_ = true;
            } else if ((static_cast<unsigned char>(text_[position_]) & 0xC0U) != 0x80U) {
                ++column_;
            }
        }
    }

    void skip_string(char quote)
    {
        const int line = line_;
        const int column = column_;
        const bool many = peek(1) == quote && peek(2) == quote;
        advance(many ? 3 : 1);
        while (position_ < text_.size()) {
            if (quote == '"' && peek() == '\\') {
                advance(2);
                continue;
            }
            if (!many && peek() == '\n') {
                break;
            }
            const bool ends = peek() == quote && (!many || (peek(1) == quote && peek(2) == quote));
            if (ends) {
                advance(many ? 3 : 1);
                while (many && peek() == quote) {
                    advance();
                }
                return;
            }
            advance();
        }
        complain("this text is never closed", std::string("end it with ") + quote, line, column);
    }

    void begin_line()
    {
        begins_line_ = false;
        const char first = peek();
        const auto starts_key = [](char c) {
            return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '"' || c == '\'';
        };
        std::size_t ahead = 0;
        if (first == '[') {
            ahead = peek(1) == '[' ? 2 : 1;
            while (peek(ahead) == ' ' || peek(ahead) == '\t') {
                ++ahead;
            }
        }
        if (!starts_key(peek(ahead)) && static_cast<unsigned char>(peek(ahead)) < 0x80U) {
            complain(first == '[' ? "a section needs a name of letters, digits, '_' or '-'"
                                  : "a line begins with a key, a [section] or a # comment",
                     first == '[' ? "write it like [machine]" : "write it like key = value");
        }
    }

    // Each of these leads to at most one more value.
    void count_values(char c)
    {
        if (c == ',' || c == '=' || c == '[' || c == '{' || c == '.') {
            ++values_;
        }
        if (values_ > most_values) {
            complain("there are too many values", fmt::format("at most {} are read", most_values));
        }
    }

    // Each step of a dotted key and each bracket nests one table deeper; recursive walks over the tree go as deep.
    void count_nesting(char c)
    {
        if (c == '.') {
            ++dots_;
        } else if (c == '=' || c == ',' || c == '\n' || c == '[' || c == '{') {
            dots_ = 0;
        }
        if (open_.size() + dots_ > most_nested) {
            complain("values or names are nested too deep", fmt::format("at most {} levels are read", most_nested));
        }
    }

    void step()
    {
        const char c = peek();
        count_nesting(c);
        count_values(c);
        if (complaint_) {
            return;
        }
        if (c == '\n' || c == ' ' || c == '\t' || c == '\r') {
            return advance();
        }
        if (c == '#') {
            while (position_ < text_.size() && peek() != '\n') {
                advance();
            }
            return;
        }
        if (c == '\0' || text_.starts_with("\xff\xfe") || text_.starts_with("\xfe\xff")) {
            return complain("the file is not plain text in UTF-8; it looks like UTF-16",
                            "save it as UTF-8 in your editor");
        }
        if (static_cast<unsigned char>(c) >= 0x80U) {
            return complain("a character outside of quotes that is not plain ASCII",
                            "use straight quotes \" around text, and letters a-z, digits, '_' or '-' in keys");
        }
        if (begins_line_ && open_.empty()) {
            begin_line();
            if (complaint_) {
                return;
            }
        }
        begins_line_ = false;
        if (c == '"' || c == '\'') {
            // toml++ reads such a quote as part of the text before it, and the text after it as plain characters.
            if (position_ > 0 &&
                std::string_view(" \t\r\n=,.[{").find(text_[position_ - 1]) == std::string_view::npos) {
                return complain("a quote in the middle of a name or value", "put all of the text in quotes");
            }
            return skip_string(c);
        }
        if (c == '[') {
            open_.push_back({']', line_, column_});
        }
        if (c == '{') {
            open_.push_back({'}', line_, column_});
        }
        if (c == ']' || c == '}') {
            if (open_.empty()) {
                return complain(std::string("this '") + c + "' has no opening bracket", "remove it");
            }
            if (open_.back().closing != c) {
                return complain(std::string("'") + c + "' where '" + open_.back().closing + "' is expected",
                                std::string("close with '") + open_.back().closing + "'");
            }
            open_.pop_back();
        }
        advance();
    }

    const std::string& text_;
    std::size_t position_ = 0;
    int line_ = 1;
    int column_ = 1;
    bool begins_line_ = true;
    std::vector<Bracket> open_;
    std::size_t values_ = 0;
    std::size_t dots_ = 0;  ///< dots in the current key or number
    std::optional<Complaint> complaint_;
};

struct TooManyNames {
    Place place;
};

Place to_place(const toml::source_region& region, int file)
{
    Place place{file, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column), 1};
    if (region.end.line == region.begin.line) {
        place.width = std::max(static_cast<int>(region.end.column) - static_cast<int>(region.begin.column), 1);
    } else {
        place.width = 1 << 16;
    }
    return place;
}

bool stands_before(const Node& a, const Node& b)
{
    return std::pair(a.key_place.line, a.key_place.column) < std::pair(b.key_place.line, b.key_place.column);
}

Node convert(const toml::node& source, int file)
{
    Node node;
    node.place = to_place(source.source(), file);
    if (const auto* table = source.as_table()) {
        node.kind = Node::Kind::table;
        if (table->size() > most_names) {
            throw TooManyNames{to_place(source.source(), file)};
        }
        for (const auto& [key, value] : *table) {
            Node child = convert(value, file);
            child.key = std::string(key.str());
            child.key_place = to_place(key.source(), file);
            node.children.push_back(std::move(child));
        }
        std::ranges::stable_sort(node.children, stands_before);
    } else if (const auto* array = source.as_array()) {
        node.kind = Node::Kind::array;
        for (const auto& item : *array) {
            node.children.push_back(convert(item, file));
        }
    } else if (const auto* text = source.as_string()) {
        node.kind = Node::Kind::string;
        node.text = text->get();
    } else if (const auto* integer = source.as_integer()) {
        node.kind = Node::Kind::integer;
        node.integer = integer->get();
        node.number = static_cast<double>(node.integer);
    } else if (const auto* real = source.as_floating_point()) {
        node.kind = Node::Kind::real;
        node.number = real->get();
    } else if (const auto* flag = source.as_boolean()) {
        node.kind = Node::Kind::boolean;
        node.flag = flag->get();
    } else {
        node.kind = Node::Kind::date;
    }
    return node;
}

Diagnostic syntax_error(const Place& place, std::string message, std::string help)
{
    Diagnostic diagnostic;
    diagnostic.code = "syntax";
    diagnostic.place = place;
    diagnostic.message = std::move(message);
    diagnostic.help = std::move(help);
    return diagnostic;
}

/// What a line states: "[parts.bed]" or "size"; empty where it states nothing.
std::string_view stated(std::string_view line)
{
    const auto begin = line.find_first_not_of(" \t");
    if (begin == std::string_view::npos || line[begin] == '#') {
        return {};
    }
    const bool header = line[begin] == '[';
    const auto end = line.find(header ? ']' : '=', begin);
    if (end == std::string_view::npos) {
        return {};
    }
    const auto text = line.substr(begin, end + (header ? 1 : 0) - begin);
    return text.substr(0, text.find_last_not_of(" \t") + 1);
}

/// The line, from 1, that states the same section or key as a later one; 0 if there is none. A key is looked for in
/// its own section.
int first_statement(std::string_view text, int line)
{
    std::vector<std::string_view> lines;
    for (std::size_t begin = 0; begin < text.size() && static_cast<int>(lines.size()) < line;) {
        const auto end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    if (line < 1 || static_cast<int>(lines.size()) < line) {
        return 0;
    }
    const auto wanted = stated(lines.back());
    for (int i = line - 1; i > 0 && !wanted.empty(); --i) {
        const auto found = stated(lines[static_cast<std::size_t>(i) - 1]);
        if (found == wanted) {
            return i;
        }
        if (found.starts_with('[') && !wanted.starts_with('[')) {
            break;
        }
    }
    return 0;
}

}  // namespace

Node* Node::find(std::string_view name)
{
    const auto found = std::ranges::find_if(children, [&](const Node& child) { return child.key == name; });
    return found == children.end() ? nullptr : &*found;
}

const Node* Node::find(std::string_view name) const { return const_cast<Node*>(this)->find(name); }

std::string_view kind_name(Node::Kind kind)
{
    switch (kind) {
    case Node::Kind::table:
        return "a table";
    case Node::Kind::array:
        return "a list";
    case Node::Kind::string:
        return "text";
    case Node::Kind::integer:
        return "a whole number";
    case Node::Kind::real:
        return "a number";
    case Node::Kind::boolean:
        return "true or false";
    case Node::Kind::date:
        return "a date";
    }
    return "a value";
}

Node parse_toml(const std::string& text, int file, Diagnostics& diagnostics)
{
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // some editors write it at the start of UTF-8 files
    if (text.starts_with(byte_order_mark)) {
        return parse_toml(text.substr(byte_order_mark.size()), file, diagnostics);
    }
    Node root;
    root.place = Place{file, 1, 1, 1};
    if (const auto complaint = Scanner(text).run()) {
        diagnostics.add(
            syntax_error({file, complaint->line, complaint->column, 1}, complaint->message, complaint->help));
        return root;
    }
    try {
        const toml::table table = toml::parse(text);
        root = convert(table, file);
        root.place = Place{file, 1, 1, 1};
    } catch (const toml::parse_error& error) {
        std::string what(error.description());
        const auto colon = what.find(": ");
        if (what.starts_with("Error while parsing") && colon != std::string::npos) {
            what.erase(0, colon + 2);
        }
        const bool twice = what.find("redefine") != std::string::npos;
        const bool no_value = what.find("expected value") != std::string::npos;
        std::string help = "the file is TOML (toml.io): key = value lines below [sections]";
        if (what.find("utf-8") != std::string::npos) {
            what = "a letter that is not UTF-8: the file was saved in another encoding";
            help = "save it as UTF-8 in your editor";
        }
        if (what.find("escape") != std::string::npos) {
            help = "in double quotes a backslash begins an escape; write paths with '/', or between single quotes";
        }
        if (no_value) {
            help = "a value is \"text\", a number, true, false, a [list] or a { table }";
        }
        if (twice) {
            help = "state every key and every section once; rename one of the two, or merge them";
        }
        auto diagnostic = syntax_error(to_place(error.source(), file), what, help);
        if (twice) {
            diagnostic.code = "duplicate-key";
            if (const int first = first_statement(text, diagnostic.place.line)) {
                diagnostic.other = Place{file, first, 1, 1 << 16};
                diagnostic.other_note = "first stated here";
            }
        }
        diagnostics.add(std::move(diagnostic));
    } catch (const TooManyNames& error) {
        diagnostics.add(
            syntax_error(error.place, fmt::format("a table of more than {} names", most_names), "divide the table"));
    } catch (const std::logic_error&) {
        diagnostics.add(
            syntax_error({file, 0, 0, 1}, "the text is not TOML", "look for an unfinished line or a stray character"));
    }
    return root;
}

}  // namespace deadpoint::casefile
