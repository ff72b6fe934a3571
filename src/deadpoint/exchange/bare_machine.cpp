#include "deadpoint/exchange/bare_machine.hpp"

namespace deadpoint {
namespace {

template <class Value>
std::vector<Value> listed_part(const std::vector<Value>& values);

template <class Value>
Value listed_part(const Value& value)
{
    if constexpr (requires { members(&value); }) {
        Value result;
        std::apply([&](auto... member) { ((result.*member = listed_part(value.*member)), ...); }, members(&value));
        return result;
    } else {
        return value;
    }
}

template <class Value>
std::vector<Value> listed_part(const std::vector<Value>& values)
{
    std::vector<Value> result;
    for (const auto& value : values)
        result.push_back(listed_part(value));
    return result;
}

}  // namespace

Machine without_mesh(const Machine& machine) { return listed_part(machine); }

}  // namespace deadpoint
