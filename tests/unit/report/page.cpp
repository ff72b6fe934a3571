#include "deadpoint/report/page/page.hpp"

#include "../../scratch_folder.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/mesh/view_file.hpp"
#include "deadpoint/report/page/sweep_page.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

using namespace deadpoint;
using namespace deadpoint::report;
namespace fs = std::filesystem;

namespace {

using Folder = ScratchFolder;

// Into a folder of results, which is then listed as it is.
void put(const fs::path& path, const std::string& text)
{
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
    write_manifest(path.parent_path());
}

std::string encoded(const std::string& text)
{
    return base64(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

bool has(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

nlohmann::json data_of(const std::string& page)
{
    const std::string mark = "id=\"data\">";
    const auto start = page.find(mark) + mark.size();
    return nlohmann::json::parse(page.substr(start, page.find("</script>", start) - start));
}

// A study of two points, one of which has left nothing.
void put_study(const fs::path& folder, const std::string& name)
{
    put(folder / "sweep.json", R"({"version": "1", "study": {"name": ")" + name + R"(", "base": "case.toml", "note": "",
        "overrides": []}, "warnings": ["<b>hot</b>"], "limits": {"largest_um": null, "end_um": null}, "sets": [{"name": "s",
        "axes": [], "window": {"text": "speed 1 rpm to 2 rpm", "points": 1}}],
        "points": [{"name": "one", "state": "done", "case_hash": "77"}, {"name": "../elsewhere", "state": "failed"}]})");
    put(folder / "sweep.csv", "# columns: point, largest_gap, reason\npoint,largest E_SW "
                              "[um],reason\none,-12.345678,\n\"../elsewhere\",,<i>\n");
    put(folder / "points/one/summary.json", R"({"version": "1", "case": {"name": "press", "hash": "77"},
        "initial_temperature_degC": 20, "probe_rises_K": {"P": {"end": 4}}, "gaps": {"force": {"final_kN": 3}},
        "left_out": ["play"]})");
    std::string history = "# columns: time, probe_temperature, dimension\ntime [s],P [degC],E_SW [um]\n";
    for (int i = 0; i <= 1000; ++i)
        history +=
            std::to_string(36 * i) + "," + std::to_string(20 + 0.004 * i) + "," + std::to_string(-0.01 * i) + "\n";
    put(folder / "points/one/history.csv", history);
    put(folder / "elsewhere/summary.json", "not to be read");
}

}  // namespace

TEST_CASE("quantised values are off by at most half a step, and the ends by nothing")
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> somewhere(-3e-5, 2e-4);
    std::vector<double> values(5000);
    for (auto& value : values)
        value = somewhere(random);
    const auto [low, high] = std::ranges::minmax(values);
    const auto q = quantise(values);
    CHECK(q.step == near((high - low) / 65535, 1e-5));
    for (std::size_t i = 0; i < values.size(); ++i)
        REQUIRE(std::abs(q.low + q.step * q.numbers[i] - values[i]) <= 0.5000001 * q.step);
    CHECK(*std::ranges::max_element(q.numbers) == 65535);
    CHECK(*std::ranges::min_element(q.numbers) == 0);
}

TEST_CASE("equal values quantise to themselves, none to nothing, and what is not finite is refused")
{
    const auto same = quantise(std::vector<double>{293.15, 293.15});
    CHECK(same.low == 293.15);
    CHECK(same.step == 0);
    CHECK(same.numbers == std::vector<std::uint16_t>{0, 0});
    CHECK(quantise(std::vector<double>{}).numbers.empty());
    CHECK_THROWS_AS(quantise(std::vector<double>{1, std::numeric_limits<double>::infinity()}), DomainError);
    CHECK_THROWS_AS(quantise(std::vector<double>{std::nan("")}), DomainError);
}

TEST_CASE("base64 gives the test vectors of RFC 4648")
{
    CHECK(encoded("") == "");
    CHECK(encoded("f") == "Zg==");
    CHECK(encoded("fo") == "Zm8=");
    CHECK(encoded("foo") == "Zm9v");
    CHECK(encoded("foob") == "Zm9vYg==");
    CHECK(encoded("fooba") == "Zm9vYmE=");
    CHECK(encoded("foobar") == "Zm9vYmFy");
    CHECK(encoded("\xff\xfe\xfd") == "//79");
}

TEST_CASE("a long table is thinned evenly, with comments, header, first and last row")
{
    std::string text = "# one\n# two\ntime [s],x\n";
    for (int i = 0; i <= 100; ++i)
        text += std::to_string(i) + "," + std::to_string(2 * i) + "\n";
    CHECK(thinned_csv(text, 5) == "# one\n# two\ntime [s],x\n0,0\n25,50\n50,100\n75,150\n100,200\n");
    CHECK(thinned_csv(text, 101) == text);
    CHECK(thinned_csv(text, 5000) == text);
    CHECK(thinned_csv("a,b\n1,2", 10) == "a,b\n1,2\n");
    CHECK(thinned_csv("", 10) == "");
}

TEST_CASE("folders of one name are told apart by their paths")
{
    const std::vector<fs::path> alike{"a/results/", "b/results"};
    const auto sources = report_sources(alike);
    CHECK(sources[0].name == "a/results/");
    CHECK(sources[1].name == "b/results");
    const std::vector<fs::path> different{"a/cold/", "b/warm"};
    CHECK(report_sources(different)[0].name == "cold");
    CHECK(report_sources(different)[1].name == "warm");
}

TEST_CASE("names from a case cannot end the page's data or title")
{
    const Folder folder;
    put(folder.path / "r/summary.json",
        R"({"version": "1", "case": {"name": "</script><b>&", "hash": "1"}, "warnings": ["<!-- <script>"]})");
    const std::vector<fs::path> folders{folder.path / "r"};
    write_report(folder.path / "page.html", report_sources(folders));
    const auto page = content(folder.path / "page.html");
    CHECK(has(page, "<h1>&lt;/script&gt;&lt;b&gt;&amp;</h1>"));
    CHECK(has(page, "\\u003c/script>\\u003cb>&"));
    const auto data = page.find("id=\"data\">");
    const auto end = page.find("</script>", data);
    CHECK(page.find('<', data + 1) == end);
    CHECK(has(page, "Content-Security-Policy"));
    CHECK(has(page, "Mike Bostock"));  // the libraries' licences travel with them
    CHECK(has(page, "three.js authors"));
}

TEST_CASE("a folder without results, and one with a broken file, are refused with the remedy")
{
    const Folder folder;
    const std::vector<fs::path> empty{folder.path};
    CHECK_THROWS_WITH_AS(write_report(folder.path / "page.html", report_sources(empty)),
                         doctest::Contains("give a folder that 'deadpoint run'"), InputError);
    put(folder.path / "summary.json", "{\"version\": ");
    CHECK_THROWS_WITH_AS(write_report(folder.path / "page.html", report_sources(empty)),
                         doctest::Contains("summary.json' is not the JSON"), InputError);
    for (const std::string& text :
         {std::string("3"), std::string(R"({"case": "press"})"), std::string(R"({"probe_rises_K": {"P": 1}})"),
          std::string(R"({"warnings": [2]})")}) {
        CAPTURE(text);
        put(folder.path / "summary.json", text);
        CHECK_THROWS_WITH_AS(write_report(folder.path / "page.html", report_sources(empty)),
                             doctest::Contains("another version"), InputError);
    }
    // Deep enough to overrun the stack of what writes it again.
    put(folder.path / "summary.json", "{}");
    put(folder.path / "view.json", std::string(1'000'000, '[') + std::string(1'000'000, ']'));
    CHECK_THROWS_WITH_AS(write_report(folder.path / "page.html", report_sources(empty)),
                         doctest::Contains("view.json' is not the JSON"), InputError);
    CHECK(!fs::exists(folder.path / "page.html"));
}

TEST_CASE("brackets in strings are no levels of JSON")
{
    const Folder folder;
    put(folder.path / "a.json", R"({"a": ")" + std::string(100, '[') + R"(\\\"{{", "b": [[1]]})");
    CHECK(read_json(folder.path / "a.json")->at("b") == nlohmann::ordered_json{{1}});
    CHECK_FALSE(read_json(folder.path / "none.json").has_value());
}

TEST_CASE("numbers too small or too large for five digits do not stop the page of a study")
{
    const ScratchFolder folder;
    put_study(folder.path, "study");
    put(folder.path / "points/one/history.csv", "# columns: time, probe_temperature, dimension\ntime [s],P [degC],E_SW "
                                                "[um]\n0,20,4e-320\n3600,1.7976931348623157e308,1\n");
    write_sweep_report(folder.path / "page.html", folder.path);
    const auto data = data_of(content(folder.path / "page.html"));
    CHECK(data["points"]["one"]["course"]["E_SW"][0].get<double>() < 1e-300);
    CHECK(data["points"]["one"]["course"]["rises"]["P"][1].is_null());  // JSON has no infinity
}

TEST_CASE("the page of a study holds thinned courses of its points, whatever their names say")
{
    const ScratchFolder folder;
    put_study(folder.path, "a </script> study");
    CHECK(is_study(folder.path));
    CHECK_FALSE(is_study(folder.path / "points/one"));
    write_sweep_report(folder.path / "page.html", folder.path);
    const auto page = content(folder.path / "page.html");
    const auto data = data_of(page);
    const auto& course = data["points"]["one"]["course"];
    CHECK(course["hours"].size() == 300);
    CHECK(course["hours"].back() == 10);
    CHECK(course["E_SW"].back() == -10);
    CHECK(course["rises"]["P"].back() == 4);
    CHECK(data["points"]["one"]["gaps"]["force"]["final_kN"] == 3);
    CHECK(data["points"]["../elsewhere"].empty());
    CHECK(data["machine"] == "press");
    CHECK(data["left_out"][0] == "play");
    CHECK(data["sweep"]["study"]["name"] == "a </script> study");
    CHECK(has(page, "<h1>a &lt;/script&gt; study</h1>"));
}

TEST_CASE("without scripts the page of a study shows its table, windows and warnings")
{
    const ScratchFolder folder;
    put_study(folder.path, "study");
    write_sweep_report(folder.path / "page.html", folder.path);
    const auto page = content(folder.path / "page.html");
    const auto start = page.find("<noscript>");
    const auto shown = page.substr(start, page.find("</noscript>") - start);
    for (const char* piece : {"switched off", "speed 1 rpm to 2 rpm", "<th scope=\"col\">largest E_SW [um]</th>",
                              ">-12.346<", "&lt;b&gt;hot&lt;/b&gt;", "&lt;i&gt;", "Cite as: deadpoint 1"})
        CHECK_MESSAGE(has(shown, piece), piece);
}

TEST_CASE("without scripts the page of a run shows gap, corners, clearances, rises and warnings")
{
    const ScratchFolder folder;
    put(folder.path / "r/summary.json",
        R"({"version": "1", "case": {"name": "a & b", "hash": "1f"}, "warnings": ["w < 1"],
        "drift_um": {"largest_E_SW": -61.29, "time_of_largest_s": 5160, "final": {"E_BG": 12.34}},
        "gaps": {"parallelism": {"corners": {"front left": {"largest_um": -3.21, "final_um": 1.5}}},
                 "clearances": [{"name": "guide", "least_change_um": -20.04, "final_change_um": -19}]},
        "probe_rises_K": {"P1": {"end": 2.626}}, "energy_J": {"generated": 7.1e7}})");
    const std::vector<fs::path> folders{folder.path / "r"};
    write_report(folder.path / "page.html", report_sources(folders));
    const auto page = content(folder.path / "page.html");
    const auto start = page.find("<noscript>");
    const auto shown = page.substr(start, page.find("</noscript>") - start);
    for (const char* piece : {"a &amp; b", "E_SW, largest, after 1 h 26 min", ">-61.3<", ">+12.3<", "front left",
                              ">-3.2<", "guide", ">-20.0<", ">+2.63<", ">71<", "w &lt; 1", "hash 1f"})
        CHECK_MESSAGE(has(shown, piece), piece);
}

TEST_CASE("a page is not made from files of two runs, nor a study's from a point of another case")
{
    const ScratchFolder folder;
    put_study(folder.path, "study");
    const auto page = folder.path / "page.html";
    const std::vector<fs::path> point{folder.path / "points/one"};
    std::ofstream(folder.path / "points/one/history.csv")
        << "# columns: time, probe_temperature\ntime [s],P [degC]\n0,20\n";
    CHECK_THROWS_WITH_AS(write_report(page, report_sources(point)), doctest::Contains("history.csv' was changed"),
                         InputError);
    CHECK_THROWS_WITH_AS(write_sweep_report(page, folder.path), doctest::Contains("history.csv' was changed"),
                         InputError);
    put(folder.path / "points/one/summary.json", R"({"version": "1", "case": {"name": "press", "hash": "78"}})");
    CHECK_THROWS_WITH_AS(write_sweep_report(page, folder.path), doctest::Contains("hash 78"), InputError);
    std::ofstream(folder.path / "sweep.csv") << "point\n";
    CHECK_THROWS_WITH_AS(write_sweep_report(page, folder.path), doctest::Contains("sweep.csv' was changed"),
                         InputError);
    CHECK_FALSE(fs::exists(page));
}

TEST_CASE("a study that cannot be read is refused with the remedy")
{
    const ScratchFolder folder;
    CHECK_THROWS_WITH_AS(write_sweep_report(folder.path / "page.html", folder.path),
                         doctest::Contains("give a folder that 'deadpoint sweep' wrote"), InputError);
    put(folder.path / "sweep.csv", "# columns: point\npoint\n");
    put(folder.path / "sweep.json", R"({"points": 3})");
    CHECK_THROWS_WITH_AS(write_sweep_report(folder.path / "page.html", folder.path),
                         doctest::Contains("run the study again"), InputError);
    CHECK(!fs::exists(folder.path / "page.html"));
}
