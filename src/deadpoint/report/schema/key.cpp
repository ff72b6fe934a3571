#include "deadpoint/report/schema/key.hpp"

namespace deadpoint::report::schema {

Keys below(const std::string& at, const Keys& keys)
{
    Keys result = keys;
    for (auto& key : result) {
        key.path.insert(0, at + "/");
    }
    return result;
}

Keys joined(std::initializer_list<Keys> groups)
{
    Keys all;
    for (const auto& group : groups) {
        all.insert(all.end(), group.begin(), group.end());
    }
    return all;
}

}  // namespace deadpoint::report::schema
