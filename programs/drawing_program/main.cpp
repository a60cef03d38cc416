// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <csignal>
#include <new>

#include "drawings.h"
#include "laplacian_lines/version.h"
#include "line_drawing/make_sheet.h"
#include "line_drawing/whole_file.h"

namespace {

/// Scans come in metres, too, and files do not tell.
void saySize(const std::vector<ReadMesh>& meshes, const CommandLine& commands) {
    Eigen::AlignedBox3d box;
    for (const ReadMesh& read : meshes)
        box.extend(line_drawing::boundsOf(read.mesh));
    if (box.isEmpty()) return;
    const double unit = commands.options.mm_per_unit;
    const Eigen::Vector3d size = unit * box.sizes();
    const bool is_given =
        std::find(commands.words.begin(), commands.words.end(), "--unit") != commands.words.end();
    const char* advice = is_given              ? ""
                         : size.maxCoeff() < 1 ? "; if it is in metres, say --unit m"
                                               : "; --unit says otherwise";
    say(stdout, (meshes.size() > 1 ? "together the objects are " : "the object is ") +
                    line_drawing::sizeInWords(size, " x ") + " in size, with " +
                    line_drawing::inDigits(unit) + " mm to the unit of the mesh" + advice);
}

void drawOne(const CommandLine& commands) {
    line_drawing::checkWritable(commands.drawing);
    std::vector<ReadMesh> meshes;
    for (const std::string& file : commands.meshes)
        meshes.push_back(readAloud(file, commands));
    if (commands.like) sayWhatDiffers(*commands.like, sourcesOf(meshes));
    saySize(meshes, commands);
    drawInto(commands.drawing, meshes, commands);
    say(stdout, "the drawing is " + commands.drawing);
}

int run(const Words& arguments) {
    const CommandLine commands = parseCommandLine(arguments);
    if (commands.help)
        std::fputs(usage().c_str(), stdout);
    else if (commands.version)
        std::printf("laplacian-lines %s\n", laplacian_lines::version());
    else if (commands.is_collection)
        return drawCollection(commands) ? 0 : 1;
    else
        drawOne(commands);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    for (const int signal : {SIGXFSZ, SIGPIPE})  // where a quota or a pipe ends, writing says so
        std::signal(signal, SIG_IGN);
    try {
        return run({argv + std::min(argc, 1), argv + argc});
    } catch (const std::bad_alloc&) {
        say(stderr, "laplacian-lines: not enough memory");
    } catch (const std::exception& error) {
        say(stderr, std::string("laplacian-lines: ") + error.what());
    }
    return 1;
}
