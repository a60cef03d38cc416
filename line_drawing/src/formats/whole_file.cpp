// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/whole_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <random>
#include <string_view>
#include <system_error>

#include "laplacian_lines/error.h"

namespace line_drawing {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_to_write(const std::string& file, const std::string& reason) {
    laplacian_lines::refuse("\"" + file + "\" cannot be written: " + reason);
}

[[noreturn]] void refuse_by_system(const std::string& file, int error = errno) {
    refuse_to_write(file, std::generic_category().message(error));
}

/// The system would truncate the name there.
void refuse_null(std::string file) {
    const std::size_t place = file.find('\0');
    if (place == file.npos) return;
    refuse_to_write(file.replace(place, 1, "\\0"), "the name holds a null character");
}

/// A device, pipe or folder, or a link to one.
bool is_special(const std::string& file) {
    std::error_code none;
    const fs::file_status status = fs::status(file, none);
    return fs::exists(status) && !fs::is_regular_file(status);
}

class OpenFile {
public:
    OpenFile(const std::string& name, const std::string& place, int flags)
        : name_(name), number_(::open(place.c_str(), flags | O_WRONLY | O_CLOEXEC, 0666)) {
        if (number_ < 0) refuse_by_system(name);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() { ::close(number_); }

    int number() const { return number_; }

    /// A full disk takes a part; the next write then fails with the reason.
    void write(std::string_view data) {
        while (!data.empty()) {
            const ssize_t count = ::write(number_, data.data(), data.size());
            if (count < 0 && errno != EINTR) refuse_by_system(name_);
            data.remove_prefix(std::size_t(std::max<ssize_t>(0, count)));
        }
    }

private:
    const std::string name_;
    const int number_;
};

/// Follows links, also to a file that is not there yet.
std::string place_of(const std::string& file) {
    constexpr int most_links = 40;
    fs::path place = file;
    std::error_code none;
    for (int links = 0; fs::is_symlink(place, none); ++links) {
        if (links == most_links) refuse_by_system(file, ELOOP);
        place = place.parent_path() / fs::read_symlink(place, none);
    }
    return place.string();
}

/// A temporary file beside the target, which replaces that once complete; else it is removed.
class NewFile {
public:
    explicit NewFile(const std::string& file)
        : name_(file),
          place_(place_of(file)),
          beside_(place_ + '.' + std::to_string(std::random_device()())),
          output_(file, beside_, O_CREAT | O_EXCL) {
        struct stat before = {};
        if (::stat(place_.c_str(), &before) != 0) return;
        if (::access(place_.c_str(), W_OK) != 0) give_up();
        if (::fchmod(output_.number(), before.st_mode & 07777) != 0) give_up();
    }
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;
    ~NewFile() {
        if (!is_complete_) ::unlink(beside_.c_str());
    }

    void complete(const std::string& data) {
        output_.write(data);
        if (::fsync(output_.number()) != 0 || ::rename(beside_.c_str(), place_.c_str()) != 0)
            refuse_by_system(name_);
        is_complete_ = true;
    }

private:
    [[noreturn]] void give_up() const {
        const int error = errno;
        ::unlink(beside_.c_str());
        refuse_by_system(name_, error);
    }

    const std::string name_, place_, beside_;
    OpenFile output_;
    bool is_complete_ = false;
};

}  // namespace

void write_whole(const std::string& file, const std::string& data) {
    refuse_null(file);
    if (is_special(file))
        OpenFile(file, file, 0).write(data);
    else
        NewFile(file).complete(data);
}

void check_writable(const std::string& file) {
    refuse_null(file);
    if (!is_special(file)) {
        const NewFile could_be(file);
        return;
    }
    if (fs::is_directory(file)) refuse_to_write(file, "it is a folder");
    if (::access(file.c_str(), W_OK) != 0)
        refuse_to_write(file, "you have no permission to write it");
}

}  // namespace line_drawing
