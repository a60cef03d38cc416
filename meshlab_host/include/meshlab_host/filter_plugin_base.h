// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/filter.h"
#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

/// A plugin of filters, the same in every version of MeshLab. A plugin class adds Q_OBJECT and
///     MESHLAB_PLUGIN_IID_EXPORTER(MESHLAB_HOST_FILTER_IID)
///     Q_INTERFACES(MESHLAB_HOST_FILTER_INTERFACE)
class FilterPluginBase : public QObject, public MESHLAB_HOST_FILTER_INTERFACE {
public:
    FilterPluginBase(const QString& plugin_name, FilterList filters);

private:
    struct Entry {
        std::unique_ptr<const Filter> filter;
        FilterDescription description;
    };

    const Entry& entry(ActionPointer action) const { return entries_.at(std::size_t(ID(action))); }
    void say(const QString& line);
    /// Runs a filter; returns an exception's sentence, or nothing.
    QString runCatchingAll(const Filter& filter, MeshDocument& document,
                           const RichParameterList& parameters, vcg::CallBackPos* progress,
                           FilterResults& results);

    // MeshLab's interface, final here.
public:
    QString pluginName() const final { return plugin_name_; }
    QString filterName(int id) const final { return entries_.at(std::size_t(id)).description.name; }
    QString filterInfo(int id) const final { return entries_.at(std::size_t(id)).description.help; }
    using MESHLAB_HOST_FILTER_INTERFACE::filterInfo;
    using MESHLAB_HOST_FILTER_INTERFACE::filterName;
    int getPreConditions(ActionPointer action) const final {
        return entry(action).description.preconditions;
    }
    int getRequirements(ActionPointer) final { return MeshModel::MM_NONE; }
    int postCondition(ActionPointer) const final { return MeshModel::MM_NONE; }
#if MESHLAB_API < 2022
    FilterClass getClass(QAction* action) final {
        return FilterClass(entry(action).description.filter_class);
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
        return entries_.at(std::size_t(id)).description.python_name;
    }
    using FilterPlugin::pythonFilterName;
    FilterClass getClass(const QAction* action) const final {
        return FilterClass(entry(action).description.filter_class);
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
    QString plugin_name_;
    std::vector<Entry> entries_;
};

}  // namespace meshlab_host
