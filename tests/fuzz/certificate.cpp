/// Requirement: whatever stands in a certificate with a right checksum, reading it gives terms that fit the large
/// model, or an error of ours.
#include "deadpoint/error.hpp"
#include "deadpoint/reduce/certificate/residual_terms.hpp"
#include "deadpoint/twin/model/certificate_file.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "input_file.hpp"
#include "signed_file.hpp"

#include <cstdlib>
#include <string_view>

using namespace deadpoint;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const InputFile file(".certificate.rom");
    static const auto large = twin::read_reduced(DEADPOINT_SOURCE_DIR "/tests/fuzz/sound/press.rom");
    const auto bytes = signed_file(twin::certificate_kind, {reinterpret_cast<const char*>(data), size});
    file.write(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    try {
        const auto residual = twin::read_certificate(file.path(), large);
        if (residual->root.cols() != residual->count() || residual->states != static_cast<Eigen::Index>(large.states))
            std::abort();
    } catch (const Error&) {
    }
    return 0;
}
