#include "deadpoint/io/binary_file.hpp"

#include "../../scratch_folder.hpp"
#include "deadpoint/error.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <doctest/doctest.h>
#include <limits>
#include <optional>
#include <sstream>
#include <sys/stat.h>
#include <variant>

using namespace deadpoint;

namespace {

constexpr std::string_view kind = "test-kind-1\n";

struct Leaf {
    double value = 0;
    bool flag = false;
};
constexpr auto members(const Leaf*) { return std::tuple{&Leaf::value, &Leaf::flag}; }

struct Tree {
    std::string name;
    std::vector<Leaf> leaves;
    std::vector<std::vector<double>> columns;
    std::vector<bool> flags;
    int count = 0;
};
constexpr auto members(const Tree*)
{
    return std::tuple{&Tree::name, &Tree::leaves, &Tree::columns, &Tree::flags, &Tree::count};
}

enum class Colour : std::uint8_t { green, brown };
constexpr Colour last_value(const Colour*) { return Colour::brown; }
struct Nothing {};
constexpr auto members(const Nothing*) { return std::tuple{}; }

struct Fruit {
    Colour colour = Colour::green;
    std::array<double, 2> sizes{};
    std::optional<double> weight;
    std::optional<Leaf> leaf;
    std::variant<Nothing, Leaf, double> form;
};
constexpr auto members(const Fruit*)
{
    return std::tuple{&Fruit::colour, &Fruit::sizes, &Fruit::weight, &Fruit::leaf, &Fruit::form};
}

Tree example()
{
    constexpr double smallest = std::numeric_limits<double>::denorm_min();
    return {"oak\n", {{0.1, true}, {-0.0, false}}, {{}, {1e300, smallest, -1e-3}}, {true, false, true}, -7};
}

std::string bytes_of(const Tree& tree)
{
    std::ostringstream out;
    BinaryWriter writer(out, kind);
    writer(tree, 2.5);
    writer.finish();
    return out.str();
}

void read_all(const std::filesystem::path& file, Tree& tree, double& last)
{
    BinaryReader reader(file, kind, "write it again");
    reader(tree, last);
}

/// The message with which a file of these bytes is refused; empty if it is not.
std::string refusal(const ScratchFolder& folder, const std::string& bytes)
{
    Tree tree;
    double last = 0;
    try {
        read_all(folder.file("file", bytes), tree, last);
    } catch (const IoError& error) {
        return error.what();
    }
    return {};
}

/// A length and a checksum that fit, as somebody would write them who means harm.
std::string stamped(std::string bytes)
{
    bytes.resize(bytes.size() - sizeof(std::uint64_t));
    StableHash hash;
    hash.add(bytes);
    const auto checksum = hash.value();
    return bytes.append(reinterpret_cast<const char*>(&checksum), sizeof checksum);
}

}  // namespace

TEST_CASE("what is written is read bit by bit")
{
    const ScratchFolder folder;
    const auto tree = example();
    Tree read{"old", {{}, {}, {}}, {{1}}, {}, 3};
    double last = 0;
    read_all(folder.file("file", bytes_of(tree)), read, last);
    CHECK(read.name == tree.name);
    REQUIRE(read.leaves.size() == 2);
    CHECK(read.leaves[0].value == 0.1);
    CHECK(read.leaves[0].flag);
    CHECK(std::signbit(read.leaves[1].value));
    REQUIRE(read.columns.size() == 2);
    CHECK(read.columns[0].empty());
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(std::bit_cast<std::uint64_t>(read.columns[1][i]) == std::bit_cast<std::uint64_t>(tree.columns[1][i]));
    CHECK(read.flags == tree.flags);
    CHECK(read.count == -7);
    CHECK(last == 2.5);
}

TEST_CASE("arrays, optional values, variants and enumerations are read as they were written")
{
    const ScratchFolder folder;
    std::ostringstream out;
    BinaryWriter writer(out, kind);
    writer(Fruit{Colour::brown, {1, 2}, 0.25, {}, Leaf{3, true}}, Fruit{});
    writer.finish();
    Fruit ripe, none{Colour::brown, {5, 6}, 7, Leaf{}, 8.0};
    BinaryReader(folder.file("fruit", out.str()), kind, "write it again")(ripe, none);
    CHECK(ripe.colour == Colour::brown);
    CHECK(ripe.sizes == std::array<double, 2>{1, 2});
    CHECK(ripe.weight == 0.25);
    CHECK_FALSE(ripe.leaf);
    REQUIRE(std::holds_alternative<Leaf>(ripe.form));
    CHECK(std::get<Leaf>(ripe.form).value == 3);
    CHECK(none.colour == Colour::green);
    CHECK(none.sizes == std::array<double, 2>{0, 0});
    CHECK_FALSE(none.weight);
    CHECK_FALSE(none.leaf);
    CHECK(std::holds_alternative<Nothing>(none.form));
}

TEST_CASE("a variant of a form that does not exist is refused")
{
    const ScratchFolder folder;
    std::ostringstream out;
    BinaryWriter writer(out, kind);
    writer(std::uint8_t{3});
    writer.finish();
    std::variant<Nothing, Leaf, double> form;
    BinaryReader reader(folder.file("form", out.str()), kind, "write it again");
    CHECK_THROWS_WITH_AS(reader(form), doctest::Contains("a form that does not exist"), IoError);
}

/// The message with which a value is refused that was written as one of another type.
template <class Read, class... Written>
std::string refusal_of(const ScratchFolder& folder, const Written&... written)
{
    std::ostringstream out;
    BinaryWriter writer(out, kind);
    writer(written...);
    writer.finish();
    Read value{};
    try {
        BinaryReader(folder.file("value", out.str()), kind, "write it again")(value);
    } catch (const IoError& error) {
        return error.what();
    }
    return {};
}

TEST_CASE("numbers that are not finite, and values that a bool or an enumeration lacks, are refused with their place")
{
    const ScratchFolder folder;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
    for (const double value : {std::nan(""), infinite, -infinite}) {
        CHECK(has(refusal_of<double>(folder, value), "its value at byte 12 is not a finite number"));
        // A count of 8 bytes, two numbers, then the one that is refused.
        CHECK(
            has(refusal_of<std::vector<double>>(folder, std::vector{1.0, 2.0, value, 4.0}), "value at byte 36 is not"));
        CHECK(
            has(refusal_of<std::vector<float>>(folder, std::vector{1.F, static_cast<float>(value)}), "byte 24 is not"));
    }
    CHECK(has(refusal_of<bool>(folder, std::uint8_t{2}), "its value at byte 12 is neither 0 nor 1"));
    CHECK(has(refusal_of<Colour>(folder, std::uint8_t{2}), "its value at byte 12 names a kind that does not exist"));
    CHECK(refusal_of<Colour>(folder, std::uint8_t{1}).empty());
    CHECK(refusal_of<std::vector<double>>(folder, std::vector{1e308, -1e308}).empty());
}

TEST_CASE("a file of many gigabytes that states another length is refused before it is summed")
{
    const ScratchFolder folder;
    const auto file = folder.file("file", bytes_of(example()));
    std::filesystem::resize_file(file, std::uintmax_t{1} << 40);  // sparse; to sum it would take minutes
    CHECK_THROWS_WITH_AS(BinaryReader(file, kind, ""), doctest::Contains("it is cut short"), IoError);
}

TEST_CASE("a file that was cut anywhere is refused with its name and what to do")
{
    const ScratchFolder folder;
    const auto whole = bytes_of(example());
    CHECK(refusal(folder, whole).empty());
    for (std::size_t size = 0; size < whole.size(); ++size) {
        CAPTURE(size);
        const auto message = refusal(folder, whole.substr(0, size));
        CHECK(message.find("file' is broken") != std::string::npos);
        CHECK(message.find("write it again") != std::string::npos);
    }
    CHECK_FALSE(refusal(folder, whole + '\0').empty());
    CHECK_FALSE(refusal(folder, whole + whole).empty());
}

TEST_CASE("a file of another version of its format is refused with both versions")
{
    const ScratchFolder folder;
    const auto refused_as = [&](const std::string& first_line) {
        return refusal(folder, first_line + bytes_of(example()).substr(kind.size()));
    };
    for (const std::string version : {"0", "2", "10", "1234567"}) {
        CAPTURE(version);
        CHECK(refused_as("test-kind-" + version + "\n")
                  .find("file' has version " + version + " of its format; this program reads version 1\n") !=
              std::string::npos);
    }
    for (const std::string first_line :
         {"test-kind-\n", "test-kind-x\n", "best-kind-2\n", "test-kind 2\n", "2\n", "\n"}) {
        CAPTURE(first_line);
        CHECK(refused_as(first_line).find("does not begin with 'test-kind-1'") != std::string::npos);
    }
}

TEST_CASE("a file in which any bit has changed is refused")
{
    const ScratchFolder folder;
    const auto whole = bytes_of(example());
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        auto changed = whole;
        changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << bit % 8));
        CAPTURE(bit);
        CHECK_FALSE(refusal(folder, changed).empty());
    }
}

TEST_CASE("no count is believed that the file is too short for, even with a checksum that fits")
{
    const ScratchFolder folder;
    const auto whole = bytes_of(example());
    int refused = 0;
    for (std::size_t at = kind.size(); at + 3 * sizeof(std::uint64_t) <= whole.size(); ++at)
        for (const std::uint64_t count : {std::uint64_t{1} << 20, std::uint64_t{1} << 61, ~std::uint64_t{0}}) {
            auto changed = whole;
            std::memcpy(changed.data() + at, &count, sizeof count);
            refused += refusal(folder, stamped(changed)).empty() ? 0 : 1;
        }
    CHECK(refused > 100);  // wherever a count was met; other places are numbers
}

TEST_CASE("reading on beyond the last value is refused")
{
    const ScratchFolder folder;
    BinaryReader reader(folder.file("file", bytes_of(example())), kind, "");
    Tree tree;
    double last = 0;
    reader(tree, last);
    CHECK_THROWS_AS(reader(last), IoError);
    CHECK_THROWS_AS(BinaryReader(folder.path / "none", kind, ""), IoError);
    CHECK_THROWS_AS(BinaryReader(folder.file("other", bytes_of(example())), "test-kind-2\n", ""), IoError);
}

TEST_CASE("a folder or a pipe in the place of the file is refused at once")
{
    const ScratchFolder folder;
    const auto pipe = folder.path / "pipe";
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    for (const auto& file : {folder.path, pipe})
        CHECK_THROWS_WITH_AS(BinaryReader(file, kind, ""), doctest::Contains("it is not a file"), IoError);
}
