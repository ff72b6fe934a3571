#pragma once

#include "deadpoint/report/schema/column.hpp"
#include "deadpoint/report/schema/key.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Every file of a result folder, with every column and every key in it: name, unit, meaning, each stated once.
///
/// Writers use its headings and units, readers and the page find columns by their kind, and
/// docs/result-files.md is printed from it. Names in braces stand for names of the case: "{joint}
/// heat" is the heading of "crank_pin heat".
namespace deadpoint::report::schema {

struct File {
    std::string name;        ///< "{number}" and "{name}" stand for what differs
    std::string written_by;  ///< command
    std::string meaning;
    std::vector<Column> columns;  ///< of a table
    std::vector<Key> keys;        ///< of a JSON file
    /// The column of a kind; null if there is none.
    [[nodiscard]] const Column* column(std::string_view kind) const;
};

/// All files, in the order of the page.
const std::vector<File>& files();
/// The file of a name. @throws std::logic_error if there is none, which is a defect of a writer
const File& file(std::string_view name);

/// A dimension of the chain: name, as in its column, and meaning.
struct Dimension {
    const char* name;
    const char* meaning;
};
/// In the order of the files: the gap first.
std::span<const Dimension> dimensions();

/// The page docs/result-files.md.
std::string page();
/// Data for the scripts of the page, as a JSON text: kinds of columns with heading and meaning,
/// dimensions.
std::string script_json();

}  // namespace deadpoint::report::schema
