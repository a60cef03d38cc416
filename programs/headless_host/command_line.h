// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <stdexcept>
#include <vector>

namespace server {

struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

enum class Layer { Current, Last, Number };

/// -o FILE [-l LAYER] [-m WHAT...]
struct OutputMesh {
    QString file;
    Layer layer = Layer::Current;
    int layer_number = 0;
    int mask = 0;             ///< bits of vcg::tri::io::Mask
    bool attributes = false;  ///< also the vertices' attributes
    bool binary = true;
};

/// -w FILE [-x]
struct OutputProject {
    QString file;
    bool overwrite_meshes = false;
};

/// -i FILE... or -p FILE
struct Input {
    QString file;
    bool is_project = false;
};

struct CommandLine {
    bool help = false;
    QStringList plugins;        ///< beside MeshLab's own
    QString log;                ///< empty: none
    QString dump;               ///< empty: none
    std::vector<Input> inputs;  ///< in their order
    QStringList scripts;
    std::vector<OutputProject> projects;
    std::vector<OutputMesh> meshes;
};

/// Takes the arguments of meshlabserver 2020.09, without the program's name; makes file names
/// absolute. @throws UsageError
CommandLine parseCommandLine(const QStringList& arguments);

const char* usage();

}  // namespace server
