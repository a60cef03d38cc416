// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/filter.h"

#include <exception>
#include <new>

namespace meshlab_host {

void add_result(const char* name, const Eigen::Vector3d& value, FilterResults& results) {
#if MESHLAB_API >= 2022  // before, there were no results
    results[name] = QVariant::fromValue(point_of(value));
#else
    results[name] = QVariantList{value.x(), value.y(), value.z()};
#endif
}

namespace {

/// The given parameters that the filter does not have, without MeshLab's own, MeshLab::...
QStringList other_parameters(const Filter& filter, const MeshModel& mesh,
                             const RichParameterList& parameters) {
    RichParameterList known;
    filter.list_parameters(&mesh, known);
    QStringList names;
    for (const RichParameter& parameter : parameters)
        if (!known.hasParameter(parameter.name()) && !parameter.name().contains("::"))
            names << parameter.name();
    return names;
}

/// MeshLab's callback, which may be null, takes percent and text; false cancels.
laplacian_lines::Progress progress_to(vcg::CallBackPos* callback) {
    if (!callback) return {};
    return [=](double done, const char* stage) { return callback(int(100 * done), stage); };
}

}  // namespace

FilterPluginBase::FilterPluginBase(const QString& plugin_name, FilterList filters)
    : plugin_name_(plugin_name), filters_(std::move(filters)) {
    for (const Filter& filter : filters_) {
        typeList.push_back(int(typeList.size()));
        actionList.push_back(new QAction(filter.description.name, this));
    }
}

QString FilterPluginBase::run_catching_all(const Filter& filter, MeshDocument& document,
                                           const RichParameterList& parameters,
                                           vcg::CallBackPos* progress, FilterResults& results) {
    try {
        if (!document.mm()) return "There is no mesh. Open one first.";
        const QStringList others = other_parameters(filter, *document.mm(), parameters);
        if (!others.isEmpty())
            say("Parameters of another version are ignored: " + others.join(", ") + '.');
        filter.run({document, parameters, progress_to(progress),
                    [this](const QString& line) { say(line); }, results});
        return QString();
    } catch (const std::bad_alloc&) {
        return "Not enough memory. The mesh was not changed.";
    } catch (const std::exception& error) {
        return QString::fromUtf8(error.what());
    } catch (...) {
        return "An unknown error occurred.";
    }
}

#if MESHLAB_API < 2022

void FilterPluginBase::initParameterSet(QAction* action, MeshDocument& document,
                                        RichParameterList& list) {
    filter(action).list_parameters(document.mm(), list);
}

bool FilterPluginBase::applyFilter(QAction* action, MeshDocument& document,
                                   const RichParameterList& parameters,
                                   vcg::CallBackPos* progress) {
    FilterResults results;
    errorMessage = run_catching_all(filter(action), document, parameters, progress, results);
    if (errorMessage.isEmpty()) return true;
    say(errorMessage);  // meshlabserver prints the log but never errorMessage
    return false;
}

#else

RichParameterList FilterPluginBase::initParameterList(const QAction* action,
                                                      const MeshDocument& document) {
    RichParameterList list;
    filter(action).list_parameters(document.mm(), list);
    return list;
}

std::map<std::string, QVariant> FilterPluginBase::applyFilter(const QAction* action,
                                                              const RichParameterList& parameters,
                                                              MeshDocument& document,
                                                              unsigned int& post_condition,
                                                              vcg::CallBackPos* progress) {
    post_condition = MeshModel::MM_NONE;
    FilterResults results;
    const QString failure =
        run_catching_all(filter(action), document, parameters, progress, results);
    if (!failure.isEmpty()) throw MLException(failure);
    return results;
}

#endif

}  // namespace meshlab_host
