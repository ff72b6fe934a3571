#include "deadpoint/reduced_press.hpp"

#include "deadpoint/api/twin/diagnostics.hpp"
#include "deadpoint/api/twin/listener.hpp"
#include "deadpoint/api/twin/results.hpp"
#include "deadpoint/casefile/files/case_source.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/press/result/sensitivities.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "deadpoint/twin/run/run_reduced.hpp"
#include "deadpoint/twin/run/run_sensitivities.hpp"

namespace deadpoint {
namespace {

CheckedCase sound_case(const std::filesystem::path& file, const ReadOptions& options)
{
    auto read = read_with_diagnostics(file, options);
    if (!read.errors.empty())
        throw CaseError(read.errors, std::move(read.diagnostics));
    return read;
}

}  // namespace

struct ReducedPress::Implementation {
    twin::ReducedPress press;
    twin::SharedParts shared;
};

ReducedPress::ReducedPress(std::unique_ptr<Implementation> implementation) : implementation_(std::move(implementation))
{}
ReducedPress::~ReducedPress() = default;
ReducedPress::ReducedPress(ReducedPress&&) noexcept = default;
ReducedPress& ReducedPress::operator=(ReducedPress&&) noexcept = default;

ReducedPress ReducedPress::open(const std::filesystem::path& file)
{
    auto implementation = std::make_unique<Implementation>();
    implementation->press = twin::read_reduced(file);
    return ReducedPress(std::move(implementation));
}

const std::string& ReducedPress::name() const { return implementation_->press.name; }
std::size_t ReducedPress::states() const { return implementation_->press.states; }

std::vector<FreeRange> ReducedPress::ranges() const
{
    std::vector<FreeRange> result;
    for (const auto& one : implementation_->press.box)
        result.push_back({one.name, one.from, one.to});
    return result;
}

std::vector<StatedAccuracy> ReducedPress::accuracy() const
{
    std::vector<StatedAccuracy> result;
    for (const auto& error : implementation_->press.errors)
        result.push_back({error.of, error.temperature, error.gap});
    return result;
}

RunResult ReducedPress::run(const std::filesystem::path& case_file, const ReadOptions& options,
                            Observer* observer) const
{
    const auto read = sound_case(case_file, options);
    ObserverOrNone given(observer);
    Listener listener(given.get());
    for (const auto& warning : read.warnings)
        listener.warn(warning);
    const auto result = casefile::with_places(read.value, [&] {
        return twin::run_reduced(read.value, implementation_->press, {}, twin::ReducedDetail::all, listener, nullptr,
                                 &implementation_->shared);
    });
    return public_run(read.value, result, listener.warnings, {});
}

std::vector<Derivative> ReducedPress::derivatives(const std::filesystem::path& case_file, const ReadOptions& options,
                                                  Observer* observer) const
{
    const auto read = sound_case(case_file, options);
    ObserverOrNone given(observer);
    const auto found = casefile::with_places(read.value, [&] {
        twin::require_fit(read.value, implementation_->press);
        return twin::run_sensitivities(read.value, implementation_->press, given.get());
    });
    std::vector<Derivative> result;
    for (const auto& one : found.of) {
        Derivative derivative{one.coefficient, one.value, one.unit, one.gap, {}};
        for (std::size_t p = 0; p < found.probes.size(); ++p)
            derivative.temperatures.emplace_back(found.probes[p], one.temperature[p]);
        result.push_back(std::move(derivative));
    }
    return result;
}

}  // namespace deadpoint
