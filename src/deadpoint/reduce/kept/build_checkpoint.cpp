#include "deadpoint/reduce/kept/build_checkpoint.hpp"

#include "deadpoint/error.hpp"

#include <fmt/format.h>

namespace deadpoint::reduce {
namespace {

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

void BuildCheckpoint::require_own(const std::string& piece, const std::string& build) const
{
    if (build != build_)
        throw InputError(fmt::format("'{}' belongs to another build\n  it is:  {}\n  wanted: {}\n  help: give the same "
                                     "case file, --set and --size as before, or {}",
                                     file(piece).string(), build, build_, help));
}

void BuildCheckpoint::fill(const std::string& piece, const std::function<void(std::ostream&)>& write) const
{
    try {
        write_file(file(piece), write, Durability::synced);
    } catch (const IoError& error) {
        warn_(fmt::format("the build goes on without keeping '{}': {}", piece, first_line(error.what())));
    }
}

}  // namespace deadpoint::reduce
