// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawings.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include "collection_items.h"
#include "file_names.h"
#include "line_drawing/make_sheet.h"
#include "line_drawing/sheet_file.h"
#include "line_drawing/whole_file.h"

namespace {

const char* const contact_name = "contact_sheet";

void makeFolders(const CollectionFolder& folder) {
    if (!QDir().mkpath(folder.recordFolder()) || !QFileInfo(folder.recordFolder()).isWritable())
        refuse(QString("the folder \"%1\" cannot be written.").arg(folder.path));
}

/// Old records must not outlive a failure.
std::vector<Job> jobsFor(const std::vector<CollectionItem>& items, const CollectionFolder& folder,
                         const CommandLine& commands) {
    std::vector<Job> jobs;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (folder.isUpToDate(items[i])) {
            say(stdout, items[i].mesh + ": unchanged");
            continue;
        }
        folder.forget(items[i]);
        jobs.push_back({i, items[i].mesh,
                        QStringList{folder.drawingOf(items[i])} + commands.words +
                            QStringList{"--contact-view", folder.viewOf(items[i]), items[i].mesh}});
    }
    return jobs;
}

void writeContactSheet(const std::vector<CollectionItem>& items, const CollectionFolder& folder,
                       const CommandLine& commands) {
    std::vector<line_drawing::ContactEntry> entries;
    std::vector<line_drawing::SourceMesh> meshes;
    for (const CollectionItem& item : items)
        if (folder.isUpToDate(item)) {
            entries.push_back({readable(item.name).toStdString(), folder.readView(item)});
            meshes.push_back({readable(QFileInfo(item.mesh).fileName()).toStdString(),
                              item.hash.toHex().toStdString()});
        }
    if (entries.empty()) return;
    const QString file = QDir(folder.path).filePath(contact_name + ('.' + folder.format));
    const std::string& title = commands.options.title;
    line_drawing::Sheet sheet = line_drawing::makeContactSheet(
        entries, title.find("{name}") == title.npos ? title : std::string());
    if (commands.options.text == line_drawing::TextStyle::Outlines)
        line_drawing::outlineTexts(sheet);
    sheet.provenance = line_drawing::provenanceText(meshes, inUtf8(commands.words));
    line_drawing::writeWhole(
        fileName(file),
        writeSheet(sheet, line_drawing::formatOf(fileName(file)), commands.choices.dpi));
    say(stdout, QString("%1: %2 objects").arg(file, QString::number(entries.size())));
}

}  // namespace

bool drawCollection(const CommandLine& commands) {
    const CollectionFolder folder{commands.drawing, commands.format};
    const std::vector<CollectionItem> items =
        itemsOf(commands.meshes, commands.words, {contact_name});
    makeFolders(folder);
    const std::vector<Job> jobs = jobsFor(items, folder, commands);
    std::size_t failures = 0;
    runJobs(QCoreApplication::applicationFilePath(), jobs, [&](const Job& job, const QString& why) {
        if (why.isEmpty()) {
            folder.remember(items[job.number]);
            say(stdout, folder.drawingOf(items[job.number]) + ": drawn");
        } else {
            ++failures;
            say(stderr, QString("%1: not drawn: %2").arg(job.mesh, why));
        }
    });
    writeContactSheet(items, folder, commands);
    say(stdout, QString("%1 drawn, %2 unchanged, %3 not drawn")
                    .arg(jobs.size() - failures)
                    .arg(items.size() - jobs.size())
                    .arg(failures));
    return failures == 0;
}
