#include "deadpoint/report/schema/column.hpp"

namespace deadpoint::report::schema {

std::string filled(std::string_view pattern, const std::string& name)
{
    const auto open = pattern.find('{');
    if (open == std::string_view::npos) {
        return std::string(pattern);
    }
    return std::string(pattern.substr(0, open)) + name + std::string(pattern.substr(pattern.find('}') + 1));
}

std::string name_in(std::string_view pattern, const std::string& text)
{
    const auto open = pattern.find('{');
    if (open == std::string_view::npos) {
        return {};
    }
    const auto before = pattern.substr(0, open);
    const auto behind = pattern.substr(pattern.find('}') + 1);
    if (text.size() <= before.size() + behind.size() || !text.starts_with(before) || !text.ends_with(behind)) {
        return {};
    }
    return text.substr(before.size(), text.size() - before.size() - behind.size());
}

}  // namespace deadpoint::report::schema
