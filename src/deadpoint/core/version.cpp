#include "deadpoint/core/version.hpp"

namespace deadpoint {

std::string_view library_version() noexcept { return version; }

}  // namespace deadpoint
