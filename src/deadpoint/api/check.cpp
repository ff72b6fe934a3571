#include "deadpoint/api/diagnostics.hpp"
#include "deadpoint/api/listener.hpp"
#include "deadpoint/report/page/named_things.hpp"
#include "deadpoint/study/pipeline/press.hpp"

namespace deadpoint {

std::vector<Diagnostic> check_press(const CheckedCase& read, study::Press& press, Observer& observer)
{
    Listener listener(observer);
    std::vector<Diagnostic> mistakes;
    try {
        press.check(listener);
    } catch (const CaseError& error) {
        mistakes = error.diagnostics();
    } catch (const CaseDomainError& error) {
        mistakes = error.diagnostics();
    }
    auto found = read.diagnostics;
    for (const auto& warning : listener.warnings)
        found.push_back(report::taken_apart(warning));
    found.insert(found.end(), mistakes.begin(), mistakes.end());
    return found;
}

}  // namespace deadpoint
