// SPDX-License-Identifier: GPL-3.0-or-later
// A file is there whole or not at all: it is written beside its place, to the disk, then renamed.
// Devices and pipes are written in place.
#include "line_drawing/atomic_file.h"

#include <fcntl.h>
#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <random>
#include <string_view>
#include <system_error>

#include "laplacian_lines/error.h"

namespace line_drawing {
namespace {

namespace fs = std::filesystem;

#ifdef _WIN32
constexpr int kFlags = O_WRONLY | O_BINARY | O_NOINHERIT;
int open_file(const fs::path& file, int flags) {
    return ::_wopen(file.c_str(), kFlags | flags, 0600);
}
int write_to_disk(int number) {
    return ::_commit(number);
}
bool may_write(const fs::path& file) {
    return ::_waccess(file.c_str(), 2) == 0;
}
#else
constexpr int kFlags = O_WRONLY | O_CLOEXEC;
int open_file(const fs::path& file, int flags) {
    return ::open(file.c_str(), kFlags | flags, 0666);
}
int write_to_disk(int number) {
    return ::fsync(number);
}
bool may_write(const fs::path& file) {
    return ::access(file.c_str(), W_OK) == 0;
}
#endif

[[noreturn]] void refuse_to_write(const std::string& file, const std::string& reason) {
    laplacian_lines::refuse("\"" + file + "\" cannot be written: " + reason);
}

[[noreturn]] void refuse_by_system(const std::string& file, int error = errno) {
    refuse_to_write(file, std::generic_category().message(error));
}

/// The system would end the name at a null character.
void refuse_null(std::string file) {
    const std::size_t place = file.find('\0');
    if (place == file.npos) return;
    refuse_to_write(file.replace(place, 1, "\\0"), "the name holds a null character");
}

/// A device, pipe or folder, or a link to one.
bool is_special(const fs::path& file) {
    std::error_code none;
    const fs::file_status status = fs::status(file, none);
    return fs::exists(status) && !fs::is_regular_file(status);
}

class OpenFile {
public:
    OpenFile(const std::string& name, const fs::path& place, int flags)
        : name_(name), number_(open_file(place, flags)) {
        if (number_ < 0) refuse_by_system(name);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() { close(); }

    /// A full disk takes a part; the next write then fails with the reason.
    void write(std::string_view data) {
        constexpr std::size_t most = 1 << 30;  // Windows takes less than twice as much at once
        while (!data.empty()) {
            const auto count = ::write(number_, data.data(), unsigned(std::min(data.size(), most)));
            if (count < 0 && errno != EINTR) refuse_by_system(name_);
            data.remove_prefix(count < 0 ? 0 : std::size_t(count));
        }
    }
    void keep() {
        if (write_to_disk(number_) != 0) refuse_by_system(name_);
    }
    void close() {
        if (number_ >= 0) ::close(number_);
        number_ = -1;
    }

private:
    const std::string name_;
    int number_;
};

/// Follows links, also to a file that is not there yet.
fs::path link_target(const std::string& file) {
    constexpr int most_links = 40;
    fs::path place = fs::u8path(file);
    std::error_code none;
    for (int links = 0; fs::is_symlink(place, none); ++links) {
        if (links == most_links) refuse_by_system(file, ELOOP);
        place = place.parent_path() / fs::read_symlink(place, none);
    }
    return place;
}

/// A temporary file beside the target, which replaces that once complete; else it is removed.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::string& file)
        : name_(file),
          place_(link_target(file)),
          beside_(fs::path(place_) += '.' + std::to_string(std::random_device()())),
          output_(file, beside_, O_CREAT | O_EXCL) {
        std::error_code error;
        const fs::file_status before = fs::status(place_, error);
        if (!fs::exists(before)) return;
        if (!may_write(place_)) give_up({errno, std::generic_category()});
        fs::permissions(beside_, before.permissions(), error);
        if (error) give_up(error);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (!is_complete_) remove();
    }

    void complete(const std::string& data) {
        output_.write(data);
        output_.keep();
        output_.close();  // Windows renames no open file
        std::error_code error;
        fs::rename(beside_, place_, error);
        if (error) refuse_to_write(name_, error.message());
        is_complete_ = true;
    }

private:
    void remove() {
        output_.close();
        std::error_code none;
        fs::remove(beside_, none);
    }
    [[noreturn]] void give_up(const std::error_code& error) {
        remove();
        refuse_to_write(name_, error.message());
    }

    const std::string name_;
    const fs::path place_, beside_;
    OpenFile output_;
    bool is_complete_ = false;
};

}  // namespace

void write_atomically(const std::string& file, const std::string& data) {
    refuse_null(file);
    if (const fs::path place = fs::u8path(file); is_special(place))
        OpenFile(file, place, 0).write(data);
    else
        TemporaryFile(file).complete(data);
}

void check_writable(const std::string& file) {
    refuse_null(file);
    const fs::path place = fs::u8path(file);
    if (!is_special(place)) return void(TemporaryFile(file));
    if (fs::is_directory(place)) refuse_to_write(file, "it is a folder");
    if (!may_write(place)) refuse_to_write(file, "you have no permission to write it");
}

}  // namespace line_drawing
