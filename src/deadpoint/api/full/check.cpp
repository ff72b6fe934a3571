#include "deadpoint/api/full/press_parts.hpp"
#include "deadpoint/api/twin/diagnostics.hpp"
#include "deadpoint/api/twin/listener.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/report/page/named_things.hpp"

namespace deadpoint {

std::vector<Diagnostic> check_press(const CheckedCase& read, full::Press& press, Observer& observer)
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
