#include "deadpoint/report/json_file.hpp"

#include "deadpoint/core/write_file.hpp"

namespace deadpoint::report {

void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& document)
{
    // A name taken from a file need not be valid UTF-8; replace what is not, rather than lose the whole summary.
    write_file(path, document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n');
}

}  // namespace deadpoint::report
