// SPDX-License-Identifier: GPL-3.0-or-later
// Full disks, quotas and pipes, and files that are not regular.
#include "line_drawing/atomic_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <csignal>
#include <filesystem>
#include <iterator>

#include "laplacian_lines/error.h"
#include "test_paths.h"

using namespace line_drawing;
using test_paths::content;
namespace fs = std::filesystem;

namespace {

/// Limits files to this many bytes, like a full disk.
class FullDisk {
public:
    explicit FullDisk(std::size_t bytes) {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit now{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &now);
    }
    ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }

private:
    rlimit before_;
};

class AtomicFiles : public testing::Test {
protected:
    std::string path(const std::string& name) const {
        return folder_.path().toStdString() + '/' + name;
    }
    int file_count() const {
        return int(std::distance(fs::directory_iterator(path("")), fs::directory_iterator()));
    }

private:
    QTemporaryDir folder_;
};

/// The refusal's message, or nothing.
template <class Work>
std::string complaint_of(Work work) {
    try {
        work();
    } catch (const laplacian_lines::Error& error) {
        return error.what();
    }
    return {};
}

TEST_F(AtomicFiles, OldOnesStayWhereverTheDiskEnds) {
    const std::string file = path("sheet.svg"), data(2000, 'x');
    write_atomically(file, "old");
    for (std::size_t bytes = 0; bytes < data.size(); ++bytes) {
        const FullDisk disk(bytes);
        const std::string complaint = complaint_of([&] { write_atomically(file, data); });
        EXPECT_NE(complaint.find("sheet.svg"), complaint.npos) << bytes << ": " << complaint;
        EXPECT_NE(complaint.find("File too large"), complaint.npos) << bytes << complaint;
    }
    EXPECT_EQ(content(file), "old");
    EXPECT_EQ(file_count(), 1);
    const FullDisk disk(data.size());
    write_atomically(file, data);
    EXPECT_EQ(content(file), data);
}

TEST_F(AtomicFiles, NamesAreNotCut) {
    const std::string file = path("cut") + '\0' + "off.svg";
    for (const auto& complaint : {complaint_of([&] { check_writable(file); }),
                                  complaint_of([&] { write_atomically(file, "new"); })})
        EXPECT_NE(complaint.find("cut\\0off.svg\" cannot be written: the name"), complaint.npos)
            << complaint;
    EXPECT_EQ(file_count(), 0);
}

TEST_F(AtomicFiles, LinksAreFollowed) {
    const std::string file = path("real.svg"), link = path("link.svg");
    write_atomically(file, "old");
    fs::create_symlink(file, link);
    write_atomically(link, "new");
    EXPECT_EQ(content(file), "new");
    EXPECT_TRUE(fs::is_symlink(link));
}

TEST_F(AtomicFiles, DevicesAreWrittenIntoAndStay) {
    const std::string link = path("null.svg"), full = path("full.svg");
    fs::create_symlink("/dev/null", link);
    fs::create_symlink("/dev/full", full);
    check_writable(link);
    write_atomically(link, "new");
    EXPECT_TRUE(fs::is_symlink(link));
    const std::string complaint = complaint_of([&] { write_atomically(full, "new"); });
    EXPECT_NE(complaint.find("No space left on device"), complaint.npos) << complaint;
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(AtomicFiles, PipesGetAll) {
    const std::string pipe = path("pipe.svg");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    check_writable(pipe);
    write_atomically(pipe, "new");
    char read_back[8] = {};
    EXPECT_EQ(read(reader, read_back, sizeof read_back), 3);
    EXPECT_STREQ(read_back, "new");
    close(reader);
    EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(AtomicFiles, FoldersAreRefusedBefore) {
    fs::create_directory(path("sheet.svg"));
    const auto complaint = [&](const char* name) {
        return complaint_of([&] { check_writable(path(name)); });
    };
    EXPECT_NE(complaint("sheet.svg").find("folder"), std::string::npos);
    EXPECT_NE(complaint("none/sheet.svg"), "");
}

}  // namespace
