// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

/// What MeshLab asks about a filter before it runs.
struct FilterDescription {
    QString plugin_name;
    QString filter_name;   ///< menu entry and name in scripts
    QString python_name;   ///< name in PyMeshLab (MeshLab 2022 and later)
    QString help;          ///< HTML
    int filter_class = 0;  ///< bits of FilterClass; Generic (0) makes loading fail
    int preconditions = MeshModel::MM_NONE;
};

/// A plugin with one filter that works on the current mesh and changes nothing MeshLab draws: the
/// same virtual functions for every version of MeshLab. A plugin class adds Q_OBJECT and
///     MESHLAB_PLUGIN_IID_EXPORTER(MESHLAB_HOST_FILTER_IID)
///     Q_INTERFACES(MESHLAB_HOST_FILTER_INTERFACE)
/// Everything here is called from MeshLab's GUI thread.
class FilterPluginBase : public QObject, public MESHLAB_HOST_FILTER_INTERFACE {
public:
    explicit FilterPluginBase(FilterDescription description);

protected:
    /// Adds the parameters with their defaults for this mesh, the null pointer if there is none.
    virtual void listParameters(const MeshModel* mesh, RichParameterList& list) const = 0;

    /// Runs the filter on the current mesh of the document, which exists. May throw anything: the
    /// user then reads what() and the caller gets a failed filter. `progress` may be null.
    virtual void run(MeshDocument& document, const RichParameterList& parameters,
                     vcg::CallBackPos* progress) = 0;

    /// Adds a line to the log.
    void say(const QString& line);

private:
    /// run(), with every exception turned into a sentence. Empty: success.
    QString runCatchingAll(MeshDocument& document, const RichParameterList& parameters,
                           vcg::CallBackPos* progress);

    // MeshLab's interface, not meant to be overridden further.
public:
    QString pluginName() const final { return description_.plugin_name; }
    QString filterName(int) const final { return description_.filter_name; }
    QString filterInfo(int) const final { return description_.help; }
    using MESHLAB_HOST_FILTER_INTERFACE::filterInfo;
    using MESHLAB_HOST_FILTER_INTERFACE::filterName;
    int getPreConditions(ActionPointer) const final { return description_.preconditions; }
    int getRequirements(ActionPointer) final { return MeshModel::MM_NONE; }
    int postCondition(ActionPointer) const final { return MeshModel::MM_NONE; }
#if MESHLAB_API < 2022
    FilterClass getClass(QAction*) final {
        return FilterClass(description_.filter_class);
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
    QString pythonFilterName(int) const final {
        return description_.python_name;
    }
    using FilterPlugin::pythonFilterName;
    FilterClass getClass(const QAction*) const final {
        return FilterClass(description_.filter_class);
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
    FilterDescription description_;
};

}  // namespace meshlab_host
