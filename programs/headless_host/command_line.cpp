// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <wrap/io_trimesh/io_mask.h>

#include <QFileInfo>
#include <map>

namespace server {

using vcg::tri::io::Mask;

namespace {

/// Letters after -m, for bits of the mask.
const std::map<QString, int>& maskLetters() {
    static const std::map<QString, int> letters = {
        {"vc", Mask::IOM_VERTCOLOR},    {"vf", Mask::IOM_VERTFLAGS},
        {"vq", Mask::IOM_VERTQUALITY},  {"vn", Mask::IOM_VERTNORMAL},
        {"vt", Mask::IOM_VERTTEXCOORD}, {"vr", Mask::IOM_VERTRADIUS},
        {"fc", Mask::IOM_FACECOLOR},    {"ff", Mask::IOM_FACEFLAGS},
        {"fq", Mask::IOM_FACEQUALITY},  {"fn", Mask::IOM_FACENORMAL},
        {"wc", Mask::IOM_WEDGCOLOR},    {"wn", Mask::IOM_WEDGNORMAL},
        {"wt", Mask::IOM_WEDGTEXCOORD}, {"mp", Mask::IOM_BITPOLYGONAL}};
    return letters;
}

class ArgumentReader {
public:
    explicit ArgumentReader(const QStringList& arguments) : arguments_(arguments) {}

    bool atEnd() const { return next_ == arguments_.size(); }
    QString take() { return arguments_[next_++]; }
    bool takeIf(const QString& option) {
        if (atEnd() || arguments_[next_] != option) return false;
        ++next_;
        return true;
    }
    bool valueFollows() const { return !atEnd() && !arguments_[next_].startsWith('-'); }
    QString takeValue(const QString& option, const QString& what) {
        if (!valueFollows()) throw UsageError((option + " needs " + what).toStdString());
        return take();
    }
    QString takeFile(const QString& option) {
        return QFileInfo(takeValue(option, "the name of a file")).absoluteFilePath();
    }

private:
    const QStringList& arguments_;
    int next_ = 0;
};

void readLayer(const QString& text, OutputMesh& mesh) {
    bool is_number = false;
    mesh.layer_number = text.toInt(&is_number);
    if (text == "c")
        mesh.layer = Layer::Current;
    else if (text == "x")
        mesh.layer = Layer::Last;
    else if (is_number && mesh.layer_number >= 0)
        mesh.layer = Layer::Number;
    else
        throw UsageError("-l after -o needs a layer: a number from 0, c or x");
}

void readMask(ArgumentReader& reader, OutputMesh& mesh) {
    do {
        const QString letters = reader.takeValue("-m", "what to save, such as vn vq");
        const auto found = maskLetters().find(letters);
        if (found != maskLetters().end())
            mesh.mask |= found->second;
        else if (letters == "va")
            mesh.attributes = true;
        else if (letters == "sa")
            mesh.binary = false;
        else
            throw UsageError(("-m does not know " + letters).toStdString());
    } while (reader.valueFollows());
}

OutputMesh readOutputMesh(ArgumentReader& reader) {
    OutputMesh mesh;
    mesh.file = reader.takeFile("-o");
    if (reader.takeIf("-l")) readLayer(reader.takeValue("-l", "a layer"), mesh);
    if (reader.takeIf("-m")) readMask(reader, mesh);
    return mesh;
}

OutputProject readOutputProject(ArgumentReader& reader) {
    OutputProject project;
    project.file = reader.takeFile("-w");
    if (!project.file.endsWith(".mlp", Qt::CaseInsensitive)) project.file += ".mlp";
    project.overwrite_meshes = reader.takeIf("-x");
    return project;
}

void readOption(const QString& option, ArgumentReader& reader, CommandLine& commands) {
    if (option == "-h" || option == "--help") {
        commands.help = true;
    } else if (option == "--plugin") {
        commands.plugins << reader.takeFile(option);
    } else if (option == "-l") {
        commands.log = reader.takeFile(option);
    } else if (option == "-d") {
        commands.dump = reader.takeFile(option);
    } else if (option == "-p") {
        commands.inputs.push_back({reader.takeFile(option), true});
    } else if (option == "-i") {
        do
            commands.inputs.push_back({reader.takeFile(option), false});
        while (reader.valueFollows());
    } else if (option == "-s") {
        commands.scripts << reader.takeFile(option);
    } else if (option == "-w") {
        commands.projects.push_back(readOutputProject(reader));
    } else if (option == "-o") {
        commands.meshes.push_back(readOutputMesh(reader));
    } else {
        throw UsageError(("unknown argument " + option).toStdString());
    }
}

}  // namespace

CommandLine parseCommandLine(const QStringList& arguments) {
    CommandLine commands;
    ArgumentReader reader(arguments);
    while (!reader.atEnd())
        readOption(reader.take(), reader, commands);
    return commands;
}

const char* usage() {
    return "laplacian_lines_server [OPTION...]: runs MeshLab's filters on meshes, without a "
           "display\n"
           "\n"
           "  -i FILE...           opens meshes; the last one is current\n"
           "  -p FILE              opens a project\n"
           "  -s FILE.mlx          runs a filter script, after all is open\n"
           "  -o FILE              saves the current layer, after the scripts; then, if wanted,\n"
           "     -l LAYER          another layer: a number from 0, c (current) or x (last)\n"
           "     -m WHAT...        what else to save: vc vf vq vn vt vr (vertices' color, flags,\n"
           "                       quality, normals, texture, radius), fc ff fq fn, wc wn wt,\n"
           "                       mp (polygons), va (vertices' attributes), sa (as text)\n"
           "  -w FILE.mlp          saves all as a project, meshes as NAME_out; with -x as NAME\n"
           "  -l FILE              appends all messages to a log\n"
           "  -d FILE              writes a list of all filters and their parameters\n"
           "  --plugin FILE        loads one more plugin; replaces MeshLab's of the same name\n"
           "\n"
           "The arguments are those of meshlabserver 2020.09, va and --plugin apart. The exit code "
           "is 0 "
           "if all\nwent well, 1 after an error, 2 for wrong arguments.\n";
}

}  // namespace server
