#include "deadpoint/report/folder/result_files.hpp"

#include "deadpoint/core/hash.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/read_file.hpp"
#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/folder/table_heads.hpp"

#include <fmt/format.h>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

namespace deadpoint::report {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Listed = std::map<std::string, ListedFile>;

constexpr const char* compute_again = "compute the case again; keep files that you edit in a folder of their own";

std::string hex(const StableHash& hash) { return fmt::format("{:016x}", hash.value()); }

ListedFile as_written(const fs::path& file)
{
    StableHash hash;
    const auto size = read_pieces(file, [&](std::string_view piece) { hash.add(piece); });
    return {size, hex(hash)};
}

/// Calls `visit` for everything below a folder but lists; folders below that have a list of their own go to `other`.
void walk(const fs::path& folder, const std::function<void(const fs::path&)>& visit,
          const std::function<void(const fs::path&)>& other)
{
    for (fs::recursive_directory_iterator entry(folder), end; entry != end; ++entry) {
        if (entry->is_directory() && !entry->is_symlink()) {
            if (fs::exists(entry->path() / manifest_name)) {
                other(entry->path());
                entry.disable_recursion_pending();
            }
        } else if (entry->path() != folder / manifest_name) {
            visit(entry->path());
        }
    }
}

std::string listed_name(const fs::path& file, const fs::path& folder)
{
    return file.lexically_relative(folder).generic_string();
}

Json files_json(const Listed& listed)
{
    Json json = Json::object();
    for (const auto& [name, file] : listed) {
        json[name] = {{"bytes", file.size}, {"checksum", file.checksum}};
    }
    return json;
}

/// Checksum of the list itself.
std::string own_checksum(const Json& files)
{
    return stable_hash(files.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void write_list(const fs::path& folder, const Listed& listed)
{
    const Json files = files_json(listed);
    write_json(folder / manifest_name, {{"written_by", "deadpoint"},
                                        {"format", result_format},
                                        {"version", version},
                                        {"checksum", own_checksum(files)},
                                        {"files", files}});
}

Json list_in(const fs::path& folder)
{
    std::error_code error;
    if (!fs::is_directory(folder, error)) {
        throw IoError(
            fmt::format("there is no folder '{}'\n  help: name a folder that deadpoint has written", folder.string()));
    }
    auto json = read_json(folder / manifest_name);
    if (!json) {
        throw InputError(fmt::format("'{}' holds no results of this version of deadpoint: there is no {}\n  help: give "
                                     "a folder that 'deadpoint run', 'loads' or 'sweep' wrote; results of older "
                                     "versions must be computed again",
                                     folder.string(), manifest_name));
    }
    return *std::move(json);
}

void require_format(const Json& json, const fs::path& file)
{
    if (const int format = json.at("format").get<int>(); format != result_format) {
        throw InputError(fmt::format("'{}' is of format {}, but this version of deadpoint reads format {}\n  help: use "
                                     "version {}, or compute the case again",
                                     file.string(), format, result_format, json.value("version", "?")));
    }
}

Listed parsed(const Json& json, const fs::path& file)
{
    try {
        require_format(json, file);
        if (json.contains(unfinished_mark)) {
            throw InputError(
                fmt::format("'{}' is not finished: deadpoint is still writing it, or was stopped\n  help: wait "
                            "for it, or compute the case again",
                            file.parent_path().string()));
        }
        const auto& files = json.at("files");
        Listed listed;
        for (const auto& [name, entry] : files.items()) {
            listed[name] = {entry.at("bytes").get<std::uintmax_t>(), entry.at("checksum").get<std::string>()};
        }
        if (own_checksum(files) == json.at("checksum").get<std::string>()) {
            return listed;
        }
    } catch (const Json::exception&) {
        // said below
    }
    throw InputError(
        fmt::format("'{}' was changed since deadpoint wrote it\n  help: {}", file.string(), compute_again));
}

}  // namespace

ResultFiles::ResultFiles(fs::path folder)
    : folder_(std::move(folder)), listed_(parsed(list_in(folder_), folder_ / manifest_name))
{}

const ListedFile* ResultFiles::find(const std::string& name) const
{
    const auto found = listed_.find(name);
    return found == listed_.end() ? nullptr : &found->second;
}

void ResultFiles::refuse_missing(const std::string& name) const
{
    throw IoError(fmt::format("'{}' is missing: it belongs to these results\n  help: {}", (folder_ / name).string(),
                              compute_again));
}

void ResultFiles::compare(const std::string& name, const ListedFile& found) const
{
    const auto* written = find(name);
    const auto file = (folder_ / name).string();
    if (written == nullptr) {
        throw InputError(fmt::format("'{}' does not belong to these results: it is not listed in {}\n  help: remove "
                                     "the file, or compute the case again",
                                     file, manifest_name));
    }
    if (written->size != found.size) {
        throw InputError(fmt::format("'{}' was changed since deadpoint wrote it: it has {} bytes, written were {}\n  "
                                     "help: {}",
                                     file, found.size, written->size, compute_again));
    }
    if (written->checksum != found.checksum) {
        throw InputError(fmt::format("'{}' was changed since deadpoint wrote it: its checksum does not fit that in "
                                     "{}\n  help: {}",
                                     file, manifest_name, compute_again));
    }
}

std::optional<std::string> ResultFiles::read(const std::string& name) const
{
    auto text = read_file(folder_ / name, largest_result);
    if (text) {
        compare(name, {text->size(), stable_hash(*text)});
        if (name.ends_with(".csv") && find(table_heads_name) != nullptr) {
            return usual_table(name, *text, read(table_heads_name).value_or(""));
        }
    } else if (find(name) != nullptr) {
        refuse_missing(name);
    }
    return text;
}

void ResultFiles::check(const std::string& name) const { compare(name, as_written(folder_ / name)); }

void ResultFiles::check_size(const std::string& name) const
{
    std::error_code error;
    const auto size = fs::file_size(folder_ / name, error);
    if (error) {
        refuse_missing(name);
    }
    const auto* written = find(name);
    compare(name, {size, written == nullptr ? "" : written->checksum});
}

void write_manifest(const fs::path& folder)
{
    Listed listed;
    walk(
        folder, [&](const fs::path& file) { listed[listed_name(file, folder)] = as_written(file); },
        [](const fs::path&) {});
    write_list(folder, listed);
}

void record_file(const fs::path& file)
{
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (!fs::exists(folder / manifest_name)) {
        return;
    }
    auto listed = ResultFiles(folder).listed();
    listed[file.filename().string()] = as_written(file);
    write_list(folder, listed);
}

std::vector<fs::path> foreign_files(const fs::path& folder)
{
    const auto listed = ResultFiles(folder).listed();
    std::vector<fs::path> foreign;
    walk(
        folder,
        [&](const fs::path& file) {
            if (!listed.contains(listed_name(file, folder))) {
                foreign.push_back(file);
            }
        },
        [&](const fs::path& below) {
            const auto more = foreign_files(below);
            foreign.insert(foreign.end(), more.begin(), more.end());
        });
    return foreign;
}

bool is_study(const fs::path& folder) { return fs::exists(folder / "sweep.json"); }

}  // namespace deadpoint::report
