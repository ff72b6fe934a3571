#include "deadpoint/casefile/files/write.hpp"

#include "deadpoint/casefile/syntax/case_bytes.hpp"
#include "deadpoint/casefile/syntax/value_texts.hpp"
#include "deadpoint/core/hash.hpp"

#include <fmt/format.h>
#include <optional>
#include <utility>

namespace deadpoint::casefile {
namespace {

class Writer final : public ValueTexts {
public:
    /// @param only  path of the only table to write, as of case_parts(); empty: all
    explicit Writer(std::string only = {}) : only_(std::move(only)) {}

    std::string run(Case& c)
    {
        frames_.push_back({Layout::block, "", "", true});
        describe(*this, c);
        return frames_.back().body;
    }

    using ValueTexts::quantities;
    void quantities(const Key& key, std::map<std::string, double>& value, Dimension dimension) override
    {
        if (value.empty() || !is_wanted(key)) {
            return;
        }
        const bool below_root = frames_.size() == 1;
        frames_.push_back({below_root ? Layout::block : Layout::braces, std::string(key.name), "", true});
        for (const auto& [name, number] : value) {
            emit({name, ""}, value_text(number, dimension));
        }
        end_table();
    }

protected:
    void put(const Key& key, std::optional<std::string> text) override
    {
        if (text && is_wanted(key)) {
            emit(key, *text);
        }
    }
    bool begin_table(const Key& key, bool present) override
    {
        if (!present || !is_wanted(key)) {
            return false;
        }
        const bool below_root = frames_.size() == 1;
        frames_.push_back({below_root ? Layout::block : Layout::braces, std::string(key.name), "", true});
        return true;
    }
    void end_table() override
    {
        const Frame frame = take();
        if (frame.layout == Layout::braces) {
            emit({frame.name, ""}, braces(frame));
        } else {
            top().body += fmt::format("\n[{}]\n{}", frame.name, frame.body);
        }
    }
    bool begin_group(const Key& key, std::vector<std::string>& names, std::string_view) override
    {
        if (names.empty() || (!only_.empty() && !only_.starts_with(fmt::format("{}.", key.name)))) {
            return false;
        }
        frames_.push_back({Layout::block, std::string(key.name), "", true});
        return true;
    }
    bool begin_member(const std::string& name) override
    {
        if (!only_.empty() && only_ != fmt::format("{}.{}", top().name, name)) {
            return false;
        }
        frames_.push_back({Layout::block, fmt::format("{}.{}", top().name, key_text(name)), "", true});
        return true;
    }
    void end_member() override
    {
        const Frame frame = take();
        top().body += fmt::format("\n[{}]\n{}", frame.name, frame.body);
    }
    void end_group() override
    {
        const Frame frame = take();
        top().body += frame.body;
    }
    bool begin_list(const Key& key, std::size_t& count) override
    {
        if (count == 0 || !is_wanted(key)) {
            return false;
        }
        const bool below_root = frames_.size() == 1;
        frames_.push_back({below_root ? Layout::block : Layout::list, std::string(key.name), "", true});
        return true;
    }
    bool begin_item(std::size_t) override
    {
        frames_.push_back({top().layout == Layout::block ? Layout::block : Layout::braces, "", "", true});
        return true;
    }
    void end_item() override
    {
        const Frame frame = take();
        if (frame.layout == Layout::braces) {
            add_item(top(), braces(frame));
        } else {
            top().body += fmt::format("\n[[{}]]\n{}", top().name, frame.body);
        }
    }
    void end_list() override
    {
        const Frame frame = take();
        if (frame.layout == Layout::list) {
            emit({frame.name, ""}, list_in(top(), frame));
        } else {
            top().body += frame.body;
        }
    }

private:
    enum class Layout { block, braces, list };
    struct Frame {
        Layout layout;
        std::string name;
        std::string body;
        bool first;
    };

    static std::string braces(const Frame& frame) { return "{ " + frame.body + " }"; }

    /// Writes each item of a list in a section on its own line, and a list in braces on one line.
    void add_item(Frame& list, const std::string& item) const
    {
        const bool inside_braces = frames_[frames_.size() - 2].layout == Layout::braces;
        list.body += inside_braces ? fmt::format("{}{}", list.first ? "" : ", ", item) : fmt::format("    {},\n", item);
        list.first = false;
    }
    static std::string list_in(const Frame& parent, const Frame& list)
    {
        return parent.layout == Layout::braces ? "[" + list.body + "]" : "[\n" + list.body + "]";
    }

    /// True if a key is to be written: any key of a table that is written, or the wanted key of the case itself.
    [[nodiscard]] bool is_wanted(const Key& key) const
    {
        return only_.empty() || frames_.size() > 1 || only_ == key.name;
    }

    Frame& top() { return frames_.back(); }
    Frame take()
    {
        Frame frame = std::move(frames_.back());
        frames_.pop_back();
        return frame;
    }

    void emit(const Key& key, const std::string& value)
    {
        auto& frame = top();
        if (frame.layout == Layout::block) {
            frame.body += fmt::format("{} = {}\n", key_text(key.name), value);
        } else {
            frame.body += fmt::format("{}{} = {}", frame.first ? "" : ", ", key_text(key.name), value);
        }
        frame.first = false;
    }

    std::string only_;
    std::vector<Frame> frames_;
};

}  // namespace

std::string write_case(const Case& c)
{
    Case copy = c;
    return Writer().run(copy);
}

std::string case_hash(const Case& c) { return stable_hash(write_case(c)); }

std::string CaseTexts::text(const Case& c)
{
    Case copy = c;
    std::string result;
    const auto parts = case_parts(copy);
    const std::scoped_lock lock(mutex_);
    for (const auto& [path, bytes] : parts) {
        auto [table, is_new] = tables_.try_emplace(path);
        if (is_new || table->second.bytes != bytes) {
            table->second = {bytes, Writer(path).run(copy)};
        }
        result += table->second.text;
    }
    return result;
}

std::string CaseTexts::hash(const Case& c) { return stable_hash(text(c)); }

}  // namespace deadpoint::casefile
