/// Writes the reduced press that the fuzzers begin with, and a certificate of it:
///     write_sound_press CASE FILE CERTIFICATE
#include "../lumped_press.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/full/model/prepare.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/reduce/certificate/residual_terms.hpp"
#include "deadpoint/twin/model/certificate_file.hpp"

using namespace deadpoint;

namespace {

/// Residual of vectors that are orthonormal in K'^-1, for terms that it does not see.
reduce::ResidualTerms residual_of(const twin::ReducedPress& press)
{
    const auto& terms = press.terms->terms;
    reduce::ResidualTerms residual;
    residual.states = terms.uniform.size();
    residual.lowest.assign(4 * terms.joints.size() + terms.films.size() + 1, 0.0);
    residual.highest.assign(residual.lowest.size(), 1e4);
    residual.first.assign(residual.lowest.size() + 1, 0);
    residual.factors.resize(residual.states, 0);
    residual.remainder.resize(0, residual.states);
    residual.functionals = terms.functionals.rows();
    residual.observed = static_cast<Eigen::Index>(press.adjoints);
    residual.root = reduce::RowMatrix::Identity(residual.count(), residual.count());
    return residual;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 4)
        return 2;
    const auto input = casefile::read_case(argv[1]).value;
    Observer quiet;
    const auto press = LumpedPress(input, full::prepare_machine(input, 3, quiet)).press();
    twin::write_reduced(argv[2], press);
    twin::write_certificate(argv[3], press, residual_of(press));
    return 0;
}
