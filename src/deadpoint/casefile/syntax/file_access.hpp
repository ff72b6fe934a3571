#pragma once

namespace deadpoint::casefile {

/// Which files a case may name. A case that came from somewhere else must not read what lies elsewhere on the machine
/// unless its user says so.
enum class FileAccess {
    below,    ///< those in its own folder and below, after following links
    anywhere  ///< all that the user may read
};

}  // namespace deadpoint::casefile
