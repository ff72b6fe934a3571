#pragma once

namespace deadpoint::casefile {

/// Which files a case may name. A case from elsewhere must not read other files of the machine
/// unless the user allows it.
enum class FileAccess {
    below,    ///< those in its own folder and below, after following links
    anywhere  ///< all files that the user may read
};

}  // namespace deadpoint::casefile
