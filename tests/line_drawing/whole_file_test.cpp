// SPDX-License-Identifier: GPL-3.0-or-later
// Full disks, quotas and pipes, and files that are not regular.
#include "line_drawing/whole_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <csignal>
#include <string>

#include "laplacian_lines/error.h"
#include "line_drawing/sheet_file.h"
#include "made_sheets.h"

using namespace line_drawing;

namespace {

std::string fileName(const QString& name) {
    return QFile::encodeName(name).toStdString();
}

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

QByteArray contentOf(const QString& file) {
    QFile input(file);
    EXPECT_TRUE(input.open(QIODevice::ReadOnly)) << file.toStdString();
    return input.readAll();
}

/// The refusal's message, or nothing.
template <class Work>
std::string complaintOf(Work work) {
    try {
        work();
    } catch (const laplacian_lines::Error& error) {
        return error.what();
    }
    return {};
}

void expectOldFile(const QTemporaryDir& folder, const QString& file) {
    EXPECT_EQ(contentOf(file), "old");
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
}

const Sheet& sheet() {
    static const Sheet made =
        made_sheets::sheetOf(made_sheets::cubeOf100(), made_sheets::plainViews("front", "a4"));
    return made;
}

void write(const QString& file) {
    const std::string name = fileName(file);
    writeWhole(name, writeSheet(sheet(), formatOf(name), 20));
}

class WholeFile : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override { writeWhole(fileName(file()), "old"); }

    QString file() const { return folder_.filePath(QString("sheet.") + GetParam()); }

    /// With room for this many bytes.
    void expectNothingLost(std::size_t bytes) {
        std::string complaint;
        {
            const FullDisk disk(bytes);
            complaint = complaintOf([&] { write(file()); });
        }
        EXPECT_NE(complaint.find("sheet."), std::string::npos) << bytes << ": " << complaint;
        EXPECT_NE(complaint.find("File too large"), std::string::npos) << bytes << complaint;
        expectOldFile(folder_, file());
    }

    QTemporaryDir folder_;
};

TEST_P(WholeFile, OldOneStaysWhereverTheDiskEnds) {
    const QString other = folder_.filePath(QString("other.") + GetParam());
    write(other);
    const auto size = std::size_t(contentOf(other).size());
    QFile::remove(other);
    for (std::size_t bytes = 0; bytes < size; bytes += std::max<std::size_t>(1, size / 200))
        expectNothingLost(bytes);
    expectNothingLost(size - 1);
    const FullDisk disk(size);
    write(file());
    EXPECT_EQ(std::size_t(contentOf(file()).size()), size);
}

INSTANTIATE_TEST_SUITE_P(Formats, WholeFile, testing::Values("svg", "pdf", "dxf", "png"),
                         [](const auto& info) { return std::string(info.param); });

TEST(WholeFiles, EndAtAnyByte) {
    const QTemporaryDir folder;
    const QString file = folder.filePath("sheet.svg");
    writeWhole(fileName(file), "old");
    const std::string data(2000, 'x');
    for (std::size_t bytes = 0; bytes < 2000; ++bytes) {
        const FullDisk disk(bytes);
        EXPECT_NE(complaintOf([&] { writeWhole(fileName(file), data); }), "") << bytes;
    }
    expectOldFile(folder, file);
}

TEST(WholeFiles, NamesAreNotCut) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QString("cut") + QChar(0) + "off.svg");
    for (const auto& complaint : {complaintOf([&] { checkWritable(fileName(file)); }),
                                  complaintOf([&] { writeWhole(fileName(file), "new"); })})
        EXPECT_NE(complaint.find("cut\\0off.svg\" cannot be written: the name"), std::string::npos)
            << complaint;
    EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST(WholeFiles, LinksAreFollowed) {
    const QTemporaryDir folder;
    const QString file = folder.filePath("real.svg"), link = folder.filePath("link.svg");
    writeWhole(fileName(file), "old");
    ASSERT_TRUE(QFile::link(file, link));
    writeWhole(fileName(link), "new");
    EXPECT_EQ(contentOf(file), "new");
    EXPECT_TRUE(QFileInfo(link).isSymLink());
}

TEST(WholeFiles, DevicesAreWrittenIntoAndStay) {
    const QTemporaryDir folder;
    const QString link = folder.filePath("null.svg"), full = folder.filePath("full.svg");
    ASSERT_TRUE(QFile::link("/dev/null", link) && QFile::link("/dev/full", full));
    checkWritable(fileName(link));
    writeWhole(fileName(link), "new");
    EXPECT_TRUE(QFileInfo(link).isSymLink());
    const std::string complaint = complaintOf([&] { writeWhole(fileName(full), "new"); });
    EXPECT_NE(complaint.find("No space left on device"), std::string::npos) << complaint;
    struct stat null = {};
    ASSERT_EQ(stat("/dev/null", &null), 0);
    EXPECT_TRUE(S_ISCHR(null.st_mode));
}

TEST(WholeFiles, PipesGetAll) {
    const QTemporaryDir folder;
    const std::string pipe = fileName(folder.filePath("pipe.svg"));
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    checkWritable(pipe);
    writeWhole(pipe, "new");
    char read_back[8] = {};
    EXPECT_EQ(read(reader, read_back, sizeof read_back), 3);
    EXPECT_STREQ(read_back, "new");
    close(reader);
    struct stat still = {};
    ASSERT_EQ(stat(pipe.c_str(), &still), 0);
    EXPECT_TRUE(S_ISFIFO(still.st_mode));
}

TEST(WholeFiles, FoldersAreRefusedBefore) {
    const QTemporaryDir folder;
    ASSERT_TRUE(QDir(folder.path()).mkdir("sheet.svg"));
    const QString file = folder.filePath("sheet.svg");
    EXPECT_NE(complaintOf([&] { checkWritable(fileName(file)); }).find("folder"),
              std::string::npos);
    EXPECT_NE(complaintOf([&] { checkWritable(fileName(folder.filePath("none/sheet.svg"))); }), "");
}

}  // namespace
