#include "figure/leftover.hpp"

#include "error.hpp"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <dirent.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace fresnel {

namespace {

/// Registered paths, and empty slots: few and fixed, because a signal handler may not allocate. What a slot is in says
/// what may be removed, so that a handler never reads half of an entry.
using slots = std::array<std::atomic<const char*>, 256>;
slots contents, empty_folders;

/// Where the path went, null if there are too many: only this one would stay.
std::atomic<const char*>* fill_slot(const char* path, leftover::extent what) {
    for (auto& slot : what == leftover::extent::all ? contents : empty_folders) {
        const char* none = nullptr;
        if (slot.compare_exchange_strong(none, path)) return &slot;
    }
    return nullptr;
}

// ---- in a signal handler, where only calls that are safe there are allowed --------------------------------------

void remove_all_at(int folder, const char* name);

// opendir would allocate.
void remove_content(int folder) {
    struct entry {
        std::uint64_t inode;
        std::int64_t offset;
        unsigned short size;
        unsigned char type;
        char name[256];
    };
    alignas(entry) char buffer[4096];
    for (long size = 1; size > 0;) {
        size = syscall(SYS_getdents64, folder, buffer, sizeof buffer);
        for (long at = 0; at < size;) {
            const entry* one = reinterpret_cast<const entry*>(buffer + at);
            at += one->size;
            if (std::strcmp(one->name, ".") != 0 && std::strcmp(one->name, "..") != 0)
                remove_all_at(folder, one->name);
        }
    }
}

void remove_all_at(int parent, const char* name) {
    const int folder = openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (folder < 0) {
        unlinkat(parent, name, 0);
        return;
    }
    // a program that we started may be writing still
    for (int attempt = 0; attempt < 3; ++attempt) {
        lseek(folder, 0, SEEK_SET);
        remove_content(folder);
        if (unlinkat(parent, name, AT_REMOVEDIR) == 0) break;
    }
    close(folder);
}

void remove_leftovers() {
    for (auto& slot : contents)
        if (const char* path = slot.exchange(nullptr)) remove_all_at(AT_FDCWD, path);
    // folders after what was in them, and after those that were in them
    for (bool removed = true; removed;) {
        removed = false;
        for (const auto& slot : empty_folders)
            if (const char* path = slot) removed = rmdir(path) == 0 || removed;
    }
}

// The default action is in force again: the signal, blocked until this returns, ends the program.
extern "C" void end_by_signal(int signal) {
    remove_leftovers();
    raise(signal);
}

} // namespace

leftover::leftover(std::string path, extent what)
    : path_(std::move(path)), slot_(fill_slot(path_.c_str(), what)) {}

leftover::~leftover() {
    if (slot_ == nullptr) return;
    // A handler on another thread has the path: the program is ending, and the text must stay for it.
    if (slot_->exchange(nullptr) == nullptr)
        for (;;)
            pause();
}

namespace {

constexpr std::array ending_signals = {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ};

} // namespace

void remove_leftovers_on_signals() {
    for (const int signal : ending_signals) {
        struct sigaction action{};
        sigaction(signal, nullptr, &action);
        if (action.sa_handler == SIG_IGN) continue; // nohup
        action.sa_handler = end_by_signal;
        action.sa_flags = static_cast<int>(SA_RESETHAND);
        sigfillset(&action.sa_mask);
        sigaction(signal, &action, nullptr);
    }
}

void leave_leftovers_to_the_parent() {
    for (const int signal : ending_signals) {
        struct sigaction action{};
        sigaction(signal, nullptr, &action);
        if (action.sa_handler == end_by_signal) std::signal(signal, SIG_DFL);
    }
}

// ---- files --------------------------------------------------------------------------------------------------

namespace {

/// Where the content of a file must go: to the file that a symbolic link names, not in place of the link.
std::string link_target(const std::string& path) {
    std::filesystem::path target = path;
    std::error_code error;
    for (int links = 0; links < 40 && std::filesystem::is_symlink(target, error); ++links)
        target = target.parent_path() / std::filesystem::read_symlink(target, error);
    return target.string();
}

/// The descriptor of ours that a path names, as /dev/stdout names 1.
std::optional<int> descriptor_of(const std::string& path) {
    std::filesystem::path link = path;
    std::error_code error;
    for (int links = 0; links < 40 && std::filesystem::is_symlink(link, error); ++links) {
        const std::filesystem::path folder = link.parent_path();
        if (std::filesystem::equivalent(folder, "/proc/self/fd", error))
            return std::atoi(link.filename().c_str());
        link = folder / std::filesystem::read_symlink(link, error);
    }
    return {};
}

/// Whether it is there and no plain file, or an open one.
bool is_special(const std::string& path) {
    if (descriptor_of(path)) return true;
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
           !std::filesystem::is_directory(status);
}

} // namespace

staged_file::staged_file(const std::string& place)
    : path(is_special(place) ? place : fmt::format("{}.{}.part", link_target(place), getpid())),
      descriptor_(descriptor_of(place)), place_(is_special(place) ? place : link_target(place)) {
    if (is_beside()) removed_on_signal_.emplace(path);
}

staged_file::~staged_file() {
    if (is_beside()) std::remove(path.c_str());
}

file_handle staged_file::open() const {
    if (!descriptor_) return {std::fopen(path.c_str(), "wb"), std::fclose};
    std::fflush(stdout); // what was printed comes first
    return {fdopen(dup(*descriptor_), "wb"), std::fclose};
}

bool staged_file::finish() const { return !is_beside() || std::rename(path.c_str(), place_.c_str()) == 0; }

// ---- folders ------------------------------------------------------------------------------------------------

namespace {

// Deeper ones first, for as long as the program runs.
std::deque<std::pair<std::string, leftover>>& made_folders() {
    static std::deque<std::pair<std::string, leftover>> all;
    return all;
}

} // namespace

void make_folders(const std::filesystem::path& folder, std::error_code& error) {
    std::deque<std::string> missing;
    for (std::filesystem::path one = folder; !one.empty() && !std::filesystem::exists(one, error);
         one = one.parent_path())
        missing.push_back(one.string());
    std::filesystem::create_directories(folder, error);
    if (error) return;
    for (auto one = missing.rbegin(); one != missing.rend(); ++one)
        made_folders().emplace_front(std::piecewise_construct, std::forward_as_tuple(*one),
                                     std::forward_as_tuple(*one, leftover::extent::empty_folder));
}

void remove_empty_folders() {
    for (const auto& one : made_folders())
        rmdir(one.first.c_str());
}

namespace {

std::string staging_name() { return fmt::format(".fresnel.{}.part", getpid()); }

} // namespace

std::string final_path(std::string path) {
    const std::string staging = staging_name() + "/";
    const std::size_t at = path.find(staging);
    if (at != std::string::npos) path.erase(at, staging.size());
    return path;
}

staged_folder::staged_folder(const std::filesystem::path& destination)
    : path(destination / staging_name()), destination_(destination), removed_on_signal_(path.string()) {
    std::error_code error;
    std::filesystem::create_directory(path, error);
    if (error)
        throw failure(fmt::format("{}: cannot be written into: {}", destination.string(), error.message()));
}

staged_folder::~staged_folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
}

void staged_folder::require_places() const {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
        const std::string place = (destination_ / entry.path().lexically_relative(path)).string();
        std::error_code error;
        if (!std::filesystem::exists(place, error)) continue;
        const bool folder = std::filesystem::is_directory(place, error);
        if (folder == entry.is_directory()) continue;
        throw bad_input(fmt::format("{}: is a {} where a {} must go; move it away", place,
                                    folder ? "folder" : "file", folder ? "file" : "folder"));
    }
}

void staged_folder::finish() const {
    require_places();
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
        const std::filesystem::path place = destination_ / entry.path().lexically_relative(path);
        std::error_code error;
        if (entry.is_directory())
            make_folders(place, error);
        else
            std::filesystem::rename(entry.path(), link_target(place.string()), error);
        if (error) throw failure(fmt::format("{}: cannot be written: {}", place.string(), error.message()));
    }
}

} // namespace fresnel
