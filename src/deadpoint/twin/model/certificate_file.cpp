#include "deadpoint/twin/model/certificate_file.hpp"

#include "deadpoint/core/version.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/binary_file.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/reduce/certificate/residual_file.hpp"
#include "deadpoint/reduce/certificate/residual_terms.hpp"
#include "deadpoint/reduce/online/dense_terms.hpp"
#include "deadpoint/reduce/online/terms_file.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"

#include <fmt/format.h>

namespace deadpoint::twin {
namespace {

constexpr const char* certificate_help = "make it again with 'deadpoint reduce CASE -o FILE --certify'";

reduce::ResidualSizes sizes_of(const ReducedPress& large)
{
    const auto& terms = large.terms->terms;
    return {large.states, static_cast<std::uint64_t>(terms.functionals.rows()), large.adjoints,
            4 * terms.joints.size() + terms.films.size() + 1};
}

}  // namespace

std::filesystem::path certificate_file(const std::filesystem::path& press)
{
    return press.parent_path() / (press.stem().string() + ".certificate" + press.extension().string());
}

void write_certificate(const std::filesystem::path& file, const ReducedPress& large,
                       const reduce::ResidualTerms& residual)
{
    write_file(file, [&](std::ostream& out) {
        BinaryWriter writer(out, certificate_kind);
        writer(std::string(version), reduce::mark_of(large.terms->terms), reduce::stored(residual));
        writer.finish();
    });
}

std::shared_ptr<const reduce::ResidualTerms> read_certificate(const std::filesystem::path& file,
                                                              const ReducedPress& large)
{
    BinaryReader reader(file, certificate_kind, certificate_help);
    std::string written_by, model;
    reduce::StoredResidual kept;
    reader(written_by, model, kept);
    if (model != reduce::mark_of(large.terms->terms))
        throw InputError(fmt::format("the certificate '{}' belongs to another reduced press\n  help: {}", file.string(),
                                     certificate_help));
    reduce::ResidualTerms residual;
    try {
        residual = reduce::restored(kept, sizes_of(large));
    } catch (const InputError& error) {
        reader.refuse(error.what());
    }
    return std::make_shared<const reduce::ResidualTerms>(std::move(residual));
}

}  // namespace deadpoint::twin
