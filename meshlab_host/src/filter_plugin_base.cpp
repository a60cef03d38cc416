// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/filter_plugin_base.h"

#include <exception>
#include <new>

namespace meshlab_host {

FilterPluginBase::FilterPluginBase(FilterDescription description)
    : description_(std::move(description)) {
    typeList.push_back(0);
    actionList.push_back(new QAction(description_.filter_name, this));
}

void FilterPluginBase::say(const QString& line) {
#if MESHLAB_API < 2022
    Log(line.toStdString());
#else
    log(line.toStdString());
#endif
}

QString FilterPluginBase::runCatchingAll(MeshDocument& document,
                                         const RichParameterList& parameters,
                                         vcg::CallBackPos* progress) {
    try {
        if (!document.mm()) return "There is no mesh. Open one first.";
        run(document, parameters, progress);
        return QString();
    } catch (const std::bad_alloc&) {
        return "Not enough memory. The mesh was not changed.";
    } catch (const std::exception& error) {
        return QString::fromLocal8Bit(error.what());
    } catch (...) {
        return "An unknown error occurred.";
    }
}

#if MESHLAB_API < 2022

void FilterPluginBase::initParameterSet(QAction*, MeshDocument& document, RichParameterList& list) {
    listParameters(document.mm(), list);
}

bool FilterPluginBase::applyFilter(QAction*, MeshDocument& document,
                                   const RichParameterList& parameters,
                                   vcg::CallBackPos* progress) {
    errorMessage = runCatchingAll(document, parameters, progress);
    if (errorMessage.isEmpty()) return true;
    say(errorMessage);  // meshlabserver prints the log but never errorMessage
    return false;
}

#else

RichParameterList FilterPluginBase::initParameterList(const QAction*,
                                                      const MeshDocument& document) {
    RichParameterList list;
    listParameters(document.mm(), list);
    return list;
}

std::map<std::string, QVariant> FilterPluginBase::applyFilter(const QAction*,
                                                              const RichParameterList& parameters,
                                                              MeshDocument& document,
                                                              unsigned int& post_condition,
                                                              vcg::CallBackPos* progress) {
    post_condition = MeshModel::MM_NONE;
    const QString failure = runCatchingAll(document, parameters, progress);
    if (!failure.isEmpty()) throw MLException(failure);
    return {};
}

#endif

}  // namespace meshlab_host
