#include "deadpoint/error.hpp"
#include "deadpoint/io/binary_file.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/reduce/online/dense_terms.hpp"
#include "deadpoint/reduce/online/terms_file.hpp"
#include "deadpoint/twin/model/reduced_members.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "deadpoint/twin/model/sound_press.hpp"

#include <tuple>

// Reading and writing of reduced_press.hpp, apart from it because the lists of members need its structs.
namespace deadpoint::twin {
namespace {

constexpr const char* help = "make it again with 'deadpoint reduce CASE -o FILE'";

ReducedPress read(const std::filesystem::path& file, reduce::Sums sums)
{
    BinaryReader reader(file, reduced_kind, help);
    ReducedPress press;
    std::apply([&](auto... member) { reader(press.*member...); }, head(&press));
    reduce::StoredTerms kept;
    reduce::DenseTerms terms;
    reader(terms.geometry, kept);
    try {
        reduce::restore(kept, terms);
        press.terms = std::make_shared<const reduce::PreparedTerms>(std::move(terms), sums);
    } catch (const InputError& error) {
        reader.refuse(error.what());
    }
    press.states = static_cast<std::size_t>(press.terms->terms.uniform.size());
    if (const auto flaw = flaw_of(press, file); !flaw.empty())
        reader.refuse(flaw);
    return press;
}

}  // namespace

void write_reduced(const std::filesystem::path& file, const ReducedPress& press)
{
    write_file(file, [&](std::ostream& out) {
        BinaryWriter writer(out, reduced_kind);
        std::apply([&](auto... member) { writer(press.*member...); }, head(&press));
        writer(press.terms->terms.geometry, reduce::stored(press.terms->terms));
        writer.finish();
    });
}

ReducedPress read_reduced(const std::filesystem::path& file) { return read(file, reduce::Sums::of_matrices); }

ReducedPress read_reduced_for_few_runs(const std::filesystem::path& file)
{
    return read(file, reduce::Sums::of_factors);
}

}  // namespace deadpoint::twin
