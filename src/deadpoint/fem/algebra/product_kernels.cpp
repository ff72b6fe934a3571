#include "deadpoint/fem/algebra/product_kernels.hpp"

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <iterator>

namespace deadpoint::fem {
namespace {

constexpr const char* variable = "OPENBLAS_CORETYPE";

Instructions instructions()
{
#ifdef __x86_64__
    return {__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"),
            __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
                __builtin_cpu_supports("avx512cd")};
#else
    return {};
#endif
}

bool has_other_threads()
{
    const std::filesystem::directory_iterator threads("/proc/self/task");
    return std::distance(begin(threads), end(threads)) > 1;
}

template <class Function>
Function* loaded(const char* name)
{
    return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

}  // namespace

std::string_view better_kernels(std::string_view chosen, const Instructions& processor)
{
    if (chosen != "Prescott")
        return {};
    return processor.avx512 ? "SkylakeX" : processor.avx2 ? "Haswell" : "";
}

void choose_product_kernels()
{
    auto* forget = loaded<void()>("gotoblas_dynamic_quit");
    auto* choose = loaded<void()>("gotoblas_dynamic_init");
    if (!forget || !choose || std::getenv(variable) || has_other_threads())
        return;
    const std::string better(better_kernels(product_kernels(), instructions()));
    if (better.empty())
        return;
    setenv(variable, better.c_str(), 1);
    forget();
    choose();
}

std::string product_kernels()
{
    auto* name = loaded<const char*()>("openblas_get_corename");
    return name ? name() : "";
}

}  // namespace deadpoint::fem
