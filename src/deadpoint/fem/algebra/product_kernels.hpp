#pragma once

#include <string>
#include <string_view>

/// Dense products by OpenBLAS, which has kernels for each kind of processor.
namespace deadpoint::fem {

/// What a processor can do.
struct Instructions {
    bool avx2 = false;    ///< with fused multiplications
    bool avx512 = false;  ///< of servers since Skylake
};

/// OpenBLAS before 0.3.25 takes its oldest kernels, those of the Prescott, on Intel processors that it does not know,
/// and large products then take 4.7 times as long (AVX-512).
/// @param chosen  the kernels that OpenBLAS took
/// @return the kernels to take instead; empty: those are right
std::string_view better_kernels(std::string_view chosen, const Instructions& processor);

/// Makes OpenBLAS take better_kernels(). Does nothing where OPENBLAS_CORETYPE is set, with another BLAS, and where
/// there are other threads: a product that one of them computes meanwhile would be wrong. Call it first in
/// main(), or where a module is loaded.
void choose_product_kernels();

/// The kernels that OpenBLAS takes now; empty with another BLAS.
std::string product_kernels();

}  // namespace deadpoint::fem
