#include "deadpoint/io/csv_style.hpp"

#include "deadpoint/error.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;

namespace {

/// As the program writes them: numbers, empty cells, quoted text with commas, semicolons and quotation marks.
const std::string table = "# deadpoint\n# columns: time, name\ntime [s],\"name, or not\",x\n"
                          "0.5,a,\n1e-05,\"1,5\",-3.25\n2,\"b;\"\"c\"\"\",7\n3,d;e,1.5 mm\n";

}  // namespace

TEST_CASE("tables lose their comments, and get semicolons and decimal commas, on request")
{
    CHECK(csv_in_style(table, CsvStyle::comments) == table);
    CHECK(csv_in_style("# a\nx,y\n1.5,2\n", CsvStyle::plain) == "x,y\n1.5,2\n");
    CHECK(csv_in_style("# a\nx,y\n1.5,2\n", CsvStyle::comma) == "x;y\n1,5;2\n");
    CHECK(csv_in_style(table, CsvStyle::comma) ==
          "time [s];\"name, or not\";x\n0,5;a;\n1e-05;\"1,5\";-3,25\n2;\"b;\"\"c\"\"\";7\n3;\"d;e\";1.5 mm\n");
    CHECK(csv_in_style("# only a comment", CsvStyle::plain).empty());
    CHECK(csv_comments(table) == std::vector<std::string>{"deadpoint", "columns: time, name"});
    CHECK_THROWS_AS(csv_style("german"), InputError);
}

TEST_CASE("the way back gives the same table")
{
    for (const auto style : {CsvStyle::comments, CsvStyle::plain, CsvStyle::comma}) {
        CHECK(csv_with_comments(csv_in_style(table, style), style, csv_comments(table)) == table);
    }
}
