#pragma once

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

/// Values as the bytes that they have in memory, to hand them from a child process to its parent: both are the same
/// program.
namespace deadpoint::machine {

class Packer {
public:
    template <class T>
    void put(const T& value)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    template <class T>
    void put(const std::vector<T>& values)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        put(values.size());
        bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    }
    void put(const std::string& text) { put(std::vector<char>(text.begin(), text.end())); }
    [[nodiscard]] std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
};

class Unpacker {
public:
    explicit Unpacker(const std::string& bytes) : at_(bytes.data()) {}
    template <class T>
    void get(T& value)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        std::memcpy(&value, at_, sizeof value);
        at_ += sizeof value;
    }
    template <class T>
    void get(std::vector<T>& values)
    {
        std::size_t count = 0;
        get(count);
        values.resize(count);
        if (count > 0) {
            std::memcpy(values.data(), at_, count * sizeof(T));
            at_ += count * sizeof(T);
        }
    }
    void get(std::string& text)
    {
        std::vector<char> letters;
        get(letters);
        text.assign(letters.begin(), letters.end());
    }

private:
    const char* at_;
};

}  // namespace deadpoint::machine
