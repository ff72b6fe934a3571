#include "deadpoint/io/csv_table.hpp"

#include "deadpoint/error.hpp"

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

TEST_CASE("cells divided by semicolons have decimal commas or points")
{
    const auto table = parse_csv("time [s];top, left [degC];name\n0;1,5;a\n1.5;-2,25e1;\"b;c\"\n", "a.csv");
    REQUIRE(table.columns.size() == 3);
    CHECK(table.columns[1].name == "top, left");
    CHECK(table.numbers(0) == std::vector<double>{0, 1.5});
    CHECK(table.numbers(1) == std::vector<double>{1.5, -22.5});
    CHECK(table.rows[1][2] == "b;c");
    CHECK_THROWS_AS(parse_csv("a;b\n1.000,5;2\n", "a.csv").numbers(0),
                    InputError);  // neither 1.0005 nor 1000.5 for sure
}
