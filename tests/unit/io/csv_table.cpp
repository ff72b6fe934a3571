#include "deadpoint/io/csv_table.hpp"

#include "deadpoint/error.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <random>

using namespace deadpoint;
namespace fs = std::filesystem;

namespace {

struct Scratch {
    fs::path path = fs::temp_directory_path() / ("deadpoint-csv-" + std::to_string(std::random_device{}()) + ".csv");
    explicit Scratch(const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
    ~Scratch() { fs::remove(path); }
};

std::string error_of(const std::string& text, const std::string& column)
{
    const Scratch file(text);
    try {
        const auto table = read_csv(file.path);
        (void)table.numbers(table.column(column));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

bool has(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

}  // namespace

TEST_CASE("a CSV file is read with comments, units, quotes and either line end")
{
    const Scratch file(
        "# a comment\r\n\r\ntime [s], \"top, left [degC]\" ,name\r\n0,20,\"a \"\"b\"\"\"\r\n1.5e1,+2.25e1,c\n");
    const auto table = read_csv(file.path);
    REQUIRE(table.columns.size() == 3);
    CHECK(table.columns[0].name == "time");
    CHECK(table.columns[0].unit == "s");
    CHECK(table.columns[1].name == "top, left");
    CHECK(table.columns[1].unit == "degC");
    CHECK(table.columns[2].unit == "");
    CHECK(table.numbers(0) == std::vector<double>{0, 15});
    CHECK(table.numbers(1) == std::vector<double>{20, 22.5});
    CHECK(table.rows[0][2] == "a \"b\"");
    CHECK(table.lines == std::vector<int>{4, 5});
}

TEST_CASE("what is wrong with a CSV file is said with its line")
{
    CHECK(has(error_of("time,a\n0,1\n1,nan\n", "a"), ":3: 'nan' in column 'a' is not a finite number"));
    CHECK(has(error_of("time,a\n0,1\n1,\n", "a"), ":3: '' in column 'a'"));
    CHECK(has(error_of("time,a\n0,1 K\n", "a"), "'1 K'"));
    CHECK(has(error_of("time,a\n0,1,2\n", "a"), ":2: 3 cells below 2 headings"));
    CHECK(has(error_of("# nothing\n", "a"), "the file is empty"));
    CHECK(error_of("\xEF\xBB\xBFtime,a\n0,1\n", "time") == "");
    CHECK(has(error_of("time,upper\n0,1\n", "uper"), "did you mean 'upper'?"));
    CHECK(has(error_of("a\n" + std::string(10'000, ',') + "\n", "a"), ":2: the table is larger than 10000 columns"));
    CHECK_THROWS_AS((void)read_csv("no/such/file.csv"), IoError);
    CHECK_THROWS_AS((void)read_csv(fs::temp_directory_path()), IoError);
}

TEST_CASE("cells divided by semicolons have decimal commas or points, all of a file the same")
{
    const auto table = parse_csv("time [s];top, left [degC];name\n0;1,5;a\n1,5;-2,25e1;\"b;c\"\n", "a.csv");
    REQUIRE(table.columns.size() == 3);
    CHECK(table.columns[1].name == "top, left");
    CHECK(table.numbers(0) == std::vector<double>{0, 1.5});
    CHECK(table.numbers(1) == std::vector<double>{1.5, -22.5});
    CHECK(table.rows[1][2] == "b;c");
    CHECK(parse_csv("a;b\n0.5;12\n1.25;13\n", "a.csv").numbers(0) == std::vector<double>{0.5, 1.25});
    // Texts are no numbers, whatever marks they have.
    CHECK(parse_csv("date;b\n28.03.2026;1,5\n", "a.csv").numbers(1) == std::vector<double>{1.5});
}

TEST_CASE("a mark that could divide thousands is refused with its row and the reason")
{
    const auto mixed = error_of("time;a\n0;20,5\n20.6;1,234\n", "a");
    CHECK(has(mixed, ":3: '20,5' (line 2, column 'a') has a comma and '20.6' (line 3, column 'time') a point"));
    CHECK(has(error_of("time;a\n0;20,5\n20.6;1\n", "a"), "could divide thousands"));  // in another column
    for (const std::string number : {"1.000,5", "1,000.5", "1.234.567", "1,234,567", "1'234,5", "1 234,5"}) {
        const auto error = error_of("time;a\n0;2\n1;" + number + "\n", "a");
        CHECK(has(error, ":3: '" + number + "' in column 'a' has marks between thousands"));
    }
    CHECK(has(error_of("time,a\n0,\"1,234.5\"\n", "a"), "has marks between thousands"));
    CHECK(has(error_of("time,a\n0,\"20,5\"\n", "a"), "has a decimal comma\n  help: divide the cells by semicolons"));
    CHECK(has(error_of("time,a\n0,+-5\n", "a"), "is not a finite number"));
}

TEST_CASE("a heading that stands twice is refused with both columns, once it is asked for")
{
    const std::string text = "time,a [K],b,a [degC]\n0,1,2,3\n";
    CHECK(has(error_of(text, "a"), "the heading 'a' stands twice, in columns 2 and 4"));
    CHECK(error_of(text, "b") == "");
}

TEST_CASE("times that stand twice or run backward are refused with both rows")
{
    const auto table = parse_csv("# log\ntime,a\n0,1\n5,2\n5,3\n", "a.csv");
    CHECK_THROWS_WITH_AS(table.require_increasing(table.numbers(0)),
                         doctest::Contains("a.csv:5: the times do not increase: that of line 4 stands there again"),
                         InputError);
    CHECK_THROWS_WITH_AS(table.require_increasing({0, 7, 5}), doctest::Contains("that of line 4 is later"), InputError);
    CHECK_NOTHROW(table.require_increasing({0, 5, 5.001}));
}

TEST_CASE("gaps of a column are refused, or are no number where they are wanted")
{
    const auto table = parse_csv("time,a\n0,\n1,NaN\n2,na\n3,4\n", "a.csv");
    const auto values = table.numbers(1, CsvTable::Gaps::as_nan);
    CHECK(std::isnan(values[0]));
    CHECK(std::isnan(values[1]));
    CHECK(std::isnan(values[2]));
    CHECK(values[3] == 4);
    CHECK_THROWS_AS((void)table.numbers(1), InputError);
    CHECK_THROWS_AS((void)parse_csv("a\ninf\n", "a.csv").numbers(0, CsvTable::Gaps::as_nan), InputError);
}
