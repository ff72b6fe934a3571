#pragma once

#include "deadpoint/core/hash.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace deadpoint::casefile {

/// A range of one line of a source text.
struct Place {
    int file = -1;   ///< index into Sources, -1: nowhere
    int line = 0;    ///< from 1
    int column = 0;  ///< from 1, in characters (not bytes)
    int width = 1;   ///< characters to underline
};

/// The texts that were read, for quoting them in messages.
class Sources {
public:
    /// @param shown  name of the text in messages
    /// @return its index
    int add(const std::string& shown, const std::string& text);
    [[nodiscard]] const std::string& name(int file) const { return files_.at(static_cast<std::size_t>(file)).shown; }
    /// @return the line's text, empty if there is none
    [[nodiscard]] std::string line(const Place& place) const;
    /// Hash of all names and texts, to see whether they are the same. @param before  that of the texts before them
    [[nodiscard]] StableHash hash(StableHash before = {}) const;

private:
    struct File {
        std::string shown;
        std::vector<std::string> lines;
    };
    std::vector<File> files_;
};

enum class Severity { error, warning };

struct Diagnostic {
    Severity severity = Severity::error;
    std::string code;            ///< short kebab-case name of the kind of mistake
    Place place;                 ///< where
    std::string path;            ///< of the key: "joints.crank_pin.centre"
    std::string message;         ///< the mistake
    std::string help;            ///< the remedy; may be empty
    std::optional<Place> other;  ///< a related second place ("first stated here")
    std::string other_note;
};

/// Collects all mistakes and warnings of a case, to show them together.
class Diagnostics {
public:
    Sources sources;

    /// Beyond a few hundred of one severity they are only counted.
    void add(Diagnostic diagnostic);
    [[nodiscard]] std::size_t error_count() const { return errors_; }
    [[nodiscard]] std::size_t size() const { return errors_ + warnings_; }
    [[nodiscard]] const std::vector<Diagnostic>& items() const { return items_; }
    /// All errors in order of place, then a line that counts them; ends without a line break.
    /// @param outcome  end of that line: the kind of file, and the work that was not done
    [[nodiscard]] std::string render_errors(std::string_view outcome = "the case file; nothing was computed") const;
    /// Each warning as a text of its own.
    [[nodiscard]] std::vector<std::string> render_warnings() const;

private:
    [[nodiscard]] std::vector<Diagnostic> sorted() const;
    [[nodiscard]] std::string render(const Diagnostic& diagnostic) const;
    [[nodiscard]] std::string quote(const Place& place) const;

    std::vector<Diagnostic> items_;
    std::size_t errors_ = 0;
    std::size_t warnings_ = 0;
};

}  // namespace deadpoint::casefile
