#pragma once

#include "deadpoint/casefile/syntax/diagnostics.hpp"
#include "deadpoint/casefile/syntax/file_access.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace deadpoint::casefile {

inline constexpr std::size_t most_names = 10'000;    ///< in one table; they are compared with each other
inline constexpr std::size_t longest_name = 100;     ///< [characters]; names become names of files
inline constexpr std::size_t longest_text = 10'000;  ///< [characters]

/// A TOML value with its place in the text; keeps the rest of the program free of the TOML library.
struct Node {
    enum class Kind { table, array, string, integer, real, boolean, date };

    Kind kind = Kind::table;
    Place place;        ///< of the value
    Place key_place;    ///< of the key in its table
    std::string key;    ///< in its table; empty for items of an array
    std::string text;   ///< string
    double number = 0;  ///< integer, real
    std::int64_t integer = 0;
    bool flag = false;           ///< boolean
    std::string near;            ///< of a table that an override made: a table beside it that it may have meant
    std::vector<Node> children;  ///< members of a table in the order of the text, or items of an array

    [[nodiscard]] Node* find(std::string_view name);
    [[nodiscard]] const Node* find(std::string_view name) const;
};

/// Name of a kind of value: "a table", "text", ...
std::string_view kind_name(Node::Kind kind);

/// Parses one TOML text, already in `diagnostics.sources` as `file`.
/// @return the root table; empty, with an error in `diagnostics`, if the text is not TOML
Node parse_toml(const std::string& text, int file, Diagnostics& diagnostics);

/// A case file with everything it includes, as one tree.
struct Document {
    Node root;
    std::filesystem::path folder;  ///< files must lie below it, except those that an override names; empty: anywhere
    int first_override = 1 << 30;  ///< index of the first source that is one
    std::vector<std::filesystem::path> paths;  ///< of each source, by its index; empty for texts that are not files
};

/// True if `path` lies in `folder` or below, after following links.
bool lies_below(const std::filesystem::path& path, const std::filesystem::path& folder);

/// Reads a case file and its includes, and applies the overrides.
///
/// Includes are relative to the file that names them and must be allowed by `files`; tables of
/// several files are merged, a key stated twice is an error. A file's list `replace` holds texts "path=value" that
/// replace what all files state, in the order of the files. An override is "path=value" with
/// numbers for items of lists ("operation.0.speed=400 rpm"); a value that is not TOML is taken as
/// text. Every text and every name is checked to be one line of printable characters of limited
/// length, so that files and terminals can show it.
///
/// @throws IoError if the case file itself cannot be read; all else goes to `diagnostics`
Document load_document(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                       Diagnostics& diagnostics, FileAccess files = FileAccess::below);

/// Applies overrides to a document, or to that part of it which they touch, and checks the texts of what is there.
void apply_overrides(Document& document, const std::vector<std::string>& overrides, Diagnostics& diagnostics);

/// Steps of the path of an override: "operation", "0", "speed". Empty if it has no path.
std::vector<std::string> override_steps(const std::string& text);

/// Place of the value at a path such as "joints.crank.bodies.1", or of its nearest existing parent. An item of a list
/// is given by its number, from 0, or by its `name`: "joints.crank.interfaces.pin".
Place place_of(const Node& root, const std::string& path);

}  // namespace deadpoint::casefile
