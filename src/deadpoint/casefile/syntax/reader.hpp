#pragma once

#include "deadpoint/casefile/describe/library.hpp"
#include "deadpoint/casefile/describe/visitor.hpp"
#include "deadpoint/casefile/syntax/document.hpp"

namespace deadpoint::casefile {

/// Fills a described struct from a document; every mistake goes to the diagnostics, and reading
/// continues.
class Reader final : public Visitor {
public:
    /// @param library  may be null: then the key `library` is refused
    Reader(const Document& document, Diagnostics& diagnostics, const Library* library);

    /// Reads `value` from the root of the document.
    template <class T>
    void read(T& value)
    {
        push(document_.root, "");
        describe(*this, value);
        pop();
    }

    void expect(bool holds, std::string_view key, std::string_view message, std::string_view help) override;
    void from_library(Material& m) override;
    void from_library(Lubricant& l) override;
    void number(const Key& key, double& value, const Range& range) override;
    void integer(const Key& key, int& value, const Range& range) override;
    void flag(const Key& key, bool& value) override;
    void text(const Key& key, std::string& value) override;
    void path(const Key& key, std::string& value) override;
    void choice(const Key& key, std::string& value, std::span<const std::string_view> options) override;
    void quantity(const Key& key, double& value, Dimension dimension, const Range& range) override;
    void quantity(const Key& key, std::optional<double>& value, Dimension dimension, const Range& range) override;
    void vector(const Key& key, std::span<double> value, Dimension dimension) override;
    void vector(const Key& key, std::optional<Vec2>& value, Dimension dimension) override;
    void matrix(const Key& key, Matrix2& value, Dimension dimension) override;
    void matrix(const Key& key, std::optional<Matrix2>& value, Dimension dimension) override;
    void extent(const Key& key, double& from, double& to) override;
    void quantities(const Key& key, std::vector<double>& value, Dimension dimension, const Range& range) override;
    void quantities(const Key& key, std::map<std::string, double>& value, Dimension dimension) override;
    void texts(const Key& key, std::vector<std::string>& value) override;
    void setting(const Key& key, std::string& value) override;
    void settings(const Key& key, std::vector<std::vector<std::string>>& value) override;
    void points(const Key& key, std::vector<Vec2>& value) override;
    void loops(const Key& key, std::vector<std::vector<Vec2>>& value) override;
    void curve(const Key& key, Table& value, const CurveKeys& keys) override;
    void property(const Key& key, double& constant, Table& table, Dimension dimension, const Range& range) override;
    void course(const Key& key, std::optional<Course>& value, Dimension dimension, const Range& range) override;
    std::vector<std::size_t> tagged(std::span<const std::string_view> keys, std::size_t& key,
                                    std::span<const std::string_view> values, std::size_t value,
                                    std::string_view meaning) override;
    void laws(std::string_view tag, std::string_view chosen, std::span<const Law> laws) override;

protected:
    [[nodiscard]] bool replaces() const override { return true; }
    bool begin_table(const Key& key, bool present) override;
    void end_table() override { pop(); }
    bool begin_group(const Key& key, std::vector<std::string>& names, std::string_view placeholder) override;
    bool begin_member(const std::string& name) override;
    void end_member() override { pop(); }
    void end_group() override { pop(); }
    bool begin_list(const Key& key, std::size_t& count) override;
    bool begin_item(std::size_t index) override;
    void end_item() override { pop(); }
    void end_list() override { pop(); }

private:
    struct Frame {
        const Node* node;
        std::string path;
        std::vector<std::string> known;
        std::size_t errors = 0;   ///< in all, when the frame was opened
        bool open_ended = false;  ///< keys are names chosen by the user, or items
        std::string_view law;     ///< key that chose the law being described
    };

    void push(const Node& node, std::string path);
    void pop();
    [[nodiscard]] Frame& top() { return frames_.back(); }
    [[nodiscard]] std::string path_of(std::string_view key) const;
    const Node* take(const Key& key);
    void report_missing(const Key& key);
    [[nodiscard]] bool is_default(const Law& law, const std::string& key) const;
    void report_foreign(std::string_view tag, std::string_view chosen, const Node& node);
    const Node* take(const Key& key, Node::Kind kind, std::string_view help);
    void report(const Node& at, std::string code, std::string path, std::string message, std::string help);
    void report_key(const Node& at, std::string code, std::string path, std::string message, std::string help);
    bool is_a(const Node& node, Node::Kind kind, const std::string& path, std::string_view help);
    bool read_quantity(const Node& node, const std::string& path, Dimension dimension, const Range& range,
                       double& value);
    bool read_number(const Node& node, const std::string& path, const Range& range, double& value);
    bool in_range(const Node& node, const std::string& path, double value, Dimension dimension, const Range& range);
    bool read_setting(const Node& node, const std::string& path, std::string& value);
    bool read_list(const Node& node, const std::string& path, Dimension dimension, const Range& range,
                   std::vector<double>& values);
    void read_vector(const Node& node, const std::string& path, Dimension dimension, std::span<double> value);
    void read_matrix(const Node& node, const std::string& path, Dimension dimension, Matrix2& value);
    void read_points(const Node& node, const std::string& path, std::vector<Vec2>& value);
    void read_curve(const Node& node, const std::string& path, const CurveKeys& keys, Table& value);
    void read_daily(const Node& node, const std::string& path, const Range& range, DailyCourse& value);
    void report_library(std::string_view kind, const std::string& name, const std::vector<std::string>& names);

    const Document& document_;
    Diagnostics& diagnostics_;
    const Library* library_;
    std::vector<Frame> frames_;
};

}  // namespace deadpoint::casefile
