// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QVariant>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

using FilterInterface = MESHLAB_HOST_FILTER_INTERFACE;

struct FilterDescription {
    QString name;          ///< menu entry and name in scripts
    QString python_name;   ///< name in PyMeshLab (MeshLab 2022 and later)
    QString help;          ///< HTML
    int filter_class = 0;  ///< bits of FilterInterface::FilterClass; Generic (0) makes loading fail
    int preconditions = MeshModel::MM_NONE;
};

/// What a filter returns to its caller, a dictionary in PyMeshLab: numbers, booleans, texts and
/// MeshLab's points.
using FilterResults = std::map<std::string, QVariant>;

void addResult(const char* name, const Eigen::Vector3d& value, FilterResults& results);

struct FilterRun {
    MeshDocument& document;  ///< with a current mesh
    const RichParameterList& parameters;
    vcg::CallBackPos* progress;                    ///< may be null
    std::function<void(const QString& line)> say;  ///< adds a line to the log
    FilterResults& results;                        ///< empty; MeshLab 2020.09 asks for none
};

/// An entry of the Filters menu that works on the current mesh and changes nothing MeshLab draws of
/// it. GUI thread only.
class Filter {
public:
    virtual ~Filter() = default;

    virtual FilterDescription description() const = 0;

    /// Adds the parameters with defaults for this mesh, which may be null.
    virtual void listParameters(const MeshModel* mesh, RichParameterList& list) const = 0;

    /// May throw anything: the user reads what(), the caller gets a failed filter.
    virtual void run(const FilterRun& run) const = 0;
};
using FilterList = std::vector<std::unique_ptr<const Filter>>;

}  // namespace meshlab_host
