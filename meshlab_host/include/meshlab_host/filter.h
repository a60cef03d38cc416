// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QVariant>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "laplacian_lines/progress.h"
#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

using FilterInterface = MESHLAB_HOST_FILTER_INTERFACE;

struct FilterDescription {
    QString name;          ///< menu entry and name in scripts
    QString python_name;   ///< name in PyMeshLab (MeshLab 2022 and later)
    QString help;          ///< HTML
    int filter_class = 0;  ///< bits of FilterInterface::FilterClass; Generic (0) makes loading fail
};

/// What a filter returns to its caller, a dictionary in PyMeshLab: numbers, booleans, texts and
/// MeshLab's points.
using FilterResults = std::map<std::string, QVariant>;

/// Adds a point of MeshLab; in 2020.09, which discards results, a list of three numbers.
void add_result(const char* name, const Eigen::Vector3d& value, FilterResults& results);

struct FilterRun {
    MeshDocument& document;  ///< with a current mesh
    const RichParameterList& parameters;
    /// Runs the GUI's event loop: the document may have changed when it returns.
    laplacian_lines::Progress progress;
    std::function<void(const QString& line)> say;  ///< adds a line to the log
    FilterResults& results;                        ///< empty; MeshLab 2020.09 asks for none
};

/// An entry of the Filters menu that works on the current mesh and changes nothing MeshLab draws of
/// it. MeshLab offers it for meshes with faces only; run() refuses others. GUI thread only.
struct Filter {
    FilterDescription description;
    /// Adds the parameters with defaults for this mesh, which may be null.
    void (*list_parameters)(const MeshModel* mesh, RichParameterList& list);
    /// May throw anything: the user reads what(), UTF-8, the caller gets a failed filter.
    void (*run)(const FilterRun& run);
};
using FilterList = std::vector<Filter>;

/// A plugin of filters, the same in every version of MeshLab. A plugin class adds Q_OBJECT and
///     MESHLAB_PLUGIN_IID_EXPORTER(MESHLAB_HOST_FILTER_IID)
///     Q_INTERFACES(MESHLAB_HOST_FILTER_INTERFACE)
class FilterPluginBase : public QObject, public MESHLAB_HOST_FILTER_INTERFACE {
public:
    FilterPluginBase(const QString& plugin_name, FilterList filters);

private:
    const Filter& filter(ActionPointer action) const {
        return filters_.at(std::size_t(ID(action)));
    }
    void say(const QString& line) { MESHLAB_HOST_LOG(line.toStdString()); }
    /// Runs a filter; returns why it failed, or nothing.
    QString run_catching_all(const Filter& filter, MeshDocument& document,
                             const RichParameterList& parameters, vcg::CallBackPos* progress,
                             FilterResults& results);

    // MeshLab's interface, final here.
public:
    QString pluginName() const final { return plugin_name_; }
    QString filterName(int id) const final { return filters_.at(std::size_t(id)).description.name; }
    QString filterInfo(int id) const final { return filters_.at(std::size_t(id)).description.help; }
    using MESHLAB_HOST_FILTER_INTERFACE::filterInfo;
    using MESHLAB_HOST_FILTER_INTERFACE::filterName;
    int getPreConditions(ActionPointer) const final { return MeshModel::MM_FACENUMBER; }
    int getRequirements(ActionPointer) final { return MeshModel::MM_NONE; }
    int postCondition(ActionPointer) const final { return MeshModel::MM_NONE; }
#if MESHLAB_API < 2022
    FilterClass getClass(QAction* action) final {
        return FilterClass(filter(action).description.filter_class);
    }
    FILTER_ARITY filterArity(QAction*) const final {
        return SINGLE_MESH;
    }
    void initParameterSet(QAction*, MeshDocument&, RichParameterList&) final;
    using MeshFilterInterface::initParameterSet;
    bool applyFilter(QAction*, MeshDocument&, const RichParameterList&, vcg::CallBackPos*) final;
#else
    QString vendor() const final {
        return "Laplacian Lines";
    }
    QString pythonFilterName(int id) const final {
        return filters_.at(std::size_t(id)).description.python_name;
    }
    using FilterPlugin::pythonFilterName;
    FilterClass getClass(const QAction* action) const final {
        return FilterClass(filter(action).description.filter_class);
    }
    FilterArity filterArity(const QAction*) const final {
        return SINGLE_MESH;
    }
    RichParameterList initParameterList(const QAction*, const MeshDocument&) final;
    using FilterPlugin::initParameterList;
    std::map<std::string, QVariant> applyFilter(const QAction*, const RichParameterList&,
                                                MeshDocument&, unsigned int& post_condition,
                                                vcg::CallBackPos*) final;
#endif

private:
    const QString plugin_name_;
    const FilterList filters_;
};

}  // namespace meshlab_host
