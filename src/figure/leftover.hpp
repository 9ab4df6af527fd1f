#pragma once

#include <atomic>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

// What is written aside until it is complete, and what becomes of it when the program ends before: nothing
// half-written is left, neither by an error nor by a signal.

namespace fresnel {

/// A file or a folder that a signal that ends the program must take with it, while this object lives. Removing it in
/// the ordinary course stays with its maker.
class leftover {
public:
    /// What to remove: the path with all that it holds, or a folder as long as nothing is in it.
    enum class extent { all, empty_folder };

    explicit leftover(std::string path, extent what = extent::all);
    ~leftover();
    leftover(const leftover&) = delete;
    leftover& operator=(const leftover&) = delete;

private:
    std::string path_;
    std::atomic<const char*>* slot_;
};

/// Has SIGINT, SIGTERM, SIGHUP, SIGPIPE and SIGXFSZ remove every leftover and then end the program, as they would have.
void remove_leftovers_on_signals();

/// For a child process: what is on its way is its parent's.
void leave_leftovers_to_the_parent();

/// Makes a folder and those above it. Those that were not there go again with a signal that ends the program, and by
/// `remove_empty_folders`, unless something is in them by then.
void make_folders(const std::filesystem::path& folder, std::error_code& error);
void remove_empty_folders();

/// Files on their way into a folder that is there: written below `path`, they take their places one after the other when
/// all are written.
class staged_folder {
public:
    explicit staged_folder(const std::filesystem::path& destination);
    ~staged_folder();
    staged_folder(const staged_folder&) = delete;
    staged_folder& operator=(const staged_folder&) = delete;

    /// Moves everything to the destination, over what is there. Throws bad_input before anything is moved where a folder
    /// is in the place of a file or a file in that of a folder, failure naming the file that cannot be moved.
    void finish() const;

    const std::filesystem::path path;

private:
    void require_places() const;

    std::filesystem::path destination_;
    leftover removed_on_signal_;
};

/// The path that a file in a staged folder will have; any other as it is.
std::string final_path(std::string path);

using file_handle = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// A file on its way to its place: written at `path` beside it, it takes its place when it is complete. A pipe or a device
/// that is there is written into as it is, and so is a descriptor of ours by its name, /dev/stdout or /dev/fd/3; a symbolic
/// link stays, and the file it names is replaced.
class staged_file {
public:
    explicit staged_file(const std::string& place);
    ~staged_file();
    staged_file(const staged_file&) = delete;
    staged_file& operator=(const staged_file&) = delete;

    /// Opens it for writing. Null if it cannot be.
    file_handle open() const;
    /// Moves it to its place. False if it cannot be.
    bool finish() const;
    /// Whether it is written beside its place.
    bool is_beside() const { return path != place_; }

    const std::string path;

private:
    std::optional<int> descriptor_;
    std::string place_;
    std::optional<leftover> removed_on_signal_;
};

} // namespace fresnel
