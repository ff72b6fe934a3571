#include "deadpoint/core/names/plain_text.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;

TEST_CASE("printable text stays as it is, in any script")
{
    for (const char* text :
         {"", "link 3", "Pleuel \xc3\xbc", "\xe9\x80\xa3\xe7\xb5\x90", "\xf0\x9f\x94\xa5", "5 \xc2\xb5m"}) {
        CAPTURE(text);
        CHECK(first_unprintable(text).empty());
        CHECK(one_line(text) == text);
        CHECK(printable(text) == text);
        CHECK(masked(text) == text);
    }
    CHECK(character_count("\xe9\x80\xa3\xe7\xb5\x90") == 2);
}

TEST_CASE("controls, marks of direction and broken UTF-8 are named and made visible")
{
    const auto check = [](const std::string& text, const char* name, const char* line) {
        CAPTURE(line);
        CHECK(first_unprintable(text) == name);
        CHECK(one_line(text) == line);
        CHECK(character_count(masked(text)) == character_count(text));
        CHECK(first_unprintable(one_line(text)).empty());
    };
    check("a\x1b[31m", "U+001B", "a\\u001b[31m");
    check(std::string("a\0b", 3), "U+0000", "a\\u0000b");
    check("a\x7f", "U+007F", "a\\u007f");
    check("a\xc2\x9b"
          "b",
          "U+009B", "a\\u009bb");
    check("a\xe2\x80\xae"
          "b",
          "U+202E", "a\\u202eb");
    check("\xef\xbb\xbf"
          "a",
          "U+FEFF", "\\ufeffa");
    check("\xf3\xa0\x81\x81", "U+E0041", "\\ue0041");
    check("\xef\xbf\xbf", "U+FFFF", "\\uffff");
    check("a\xff", "byte 0xff", "a\\xff");
    check("\xc0\x80", "byte 0xc0", "\\xc0\\x80");           // zero, too long
    check("\xed\xa0\x80", "byte 0xed", "\\xed\\xa0\\x80");  // half of a pair
    check("\xe9\x80", "byte 0xe9", "\\xe9\\x80");           // cut short
    check("two\nlines\tand\rmore", "U+000A", "two lines and more");
}

TEST_CASE("a terminal keeps line breaks and tabs, and nothing else that moves its cursor")
{
    CHECK(printable("one\n\ttwo\r\x1b[2J") == "one\n\ttwo\\u000d\\u001b[2J");
}

TEST_CASE("text in XML is text, and a comment ends where it should")
{
    CHECK(xml_text("<a b=\"&\">\x01") == "&lt;a b=&quot;&amp;&quot;&gt;\\u0001");
    CHECK(xml_comment("a --> <b> ---\nc") == "<!-- a - -> <b> - - - c -->\n");
}
