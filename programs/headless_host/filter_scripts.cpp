// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_plugins.h"

#include <GL/glew.h>

#include <common/ml_document/mesh_document.h>
#include <common/mlexception.h>
#include <common/plugins/interfaces/filter_plugin.h>

#include <QDomDocument>
#include <QFile>

namespace server {

namespace {

QDomElement readXml(const QString& file, QDomDocument& xml) {
    QFile input(file);
    if (!input.open(QIODevice::ReadOnly))
        throw MLException("The script " + file + " cannot be read: " + input.errorString());
    QString problem;
    int line = 0;
    if (!xml.setContent(&input, &problem, &line))
        throw MLException(QString("The script %1 is not XML: line %2, %3")
                              .arg(file, QString::number(line), problem));
    const QDomElement root = xml.documentElement();
    if (root.tagName() != "FilterScript")
        throw MLException("The script " + file + " is not a MeshLab filter script: its root is <" +
                          root.tagName() + "> instead of <FilterScript>");
    if (root.firstChildElement("filter").isNull())
        throw MLException("The script " + file + " has no filter");
    return root;
}

bool isNumberType(const QString& type) {
    return type == "RichFloat" || type == "RichInt" || type == "RichEnum" ||
           type == "RichAbsPerc" || type == "RichDynamicFloat" || type == "RichMesh";
}

/// MeshLab reads other text than numbers as 0 and skips parameters of unknown types.
void checkParameter(const QDomElement& element, const RichParameterList& read) {
    const QString name = element.attribute("name"), type = element.attribute("type"),
                  value = element.attribute("value");
    bool is_number = true;
    if (isNumberType(type)) value.toDouble(&is_number);
    if (!is_number) throw MLException("Parameter " + name + ": \"" + value + "\" is not a number");
    if (!read.hasParameter(name))
        throw MLException("Parameter " + name + ": the type " + type + " cannot be read");
}

QString parameterNames(const RichParameterList& list) {
    QStringList names;
    for (const RichParameter& parameter : list)
        names << parameter.name();
    return names.isEmpty() ? "none" : names.join(", ");
}

void checkChoice(const RichEnum& parameter, int value) {
    if (value >= 0 && value < parameter.enumvalues.size()) return;
    QStringList choices;
    for (const QString& choice : parameter.enumvalues)
        choices << QString("%1 (%2)").arg(choices.size()).arg(choice);
    throw MLException(QString("\"%1\" is %2. It has to be one of %3.")
                          .arg(parameter.fieldDescription())
                          .arg(value)
                          .arg(choices.join(", ")));
}

void setParameter(const RichParameter& given, const MeshDocument& document,
                  RichParameterList& list) {
    if (!list.hasParameter(given.name()))
        throw MLException("There is no parameter " + given.name() +
                          ". There are: " + parameterNames(list));
    const RichParameter& wanted = list.getParameterByName(given.name());
    if (wanted.value().typeName() != given.value().typeName())
        throw MLException("Parameter " + given.name() + " has the type " + wanted.stringType() +
                          ", not " + given.stringType());
    if (wanted.isOfType<RichEnum>())
        checkChoice(static_cast<const RichEnum&>(wanted), given.value().getInt());
    if (wanted.isOfType<RichMesh>() && !document.getMesh(given.value().getInt()))
        throw MLException(QString("Parameter %1: there is no layer %2")
                              .arg(given.name())
                              .arg(given.value().getInt()));
    list.setValue(given.name(), given.value());
}

void checkApplicable(const LoadedFilter& filter, MeshDocument& document) {
    if (filter.plugin->requiresGLContext(filter.action))
        throw MLException("It needs OpenGL, which is not available here. Run it in MeshLab.");
    if (filter.plugin->filterArity(filter.action) != FilterPlugin::SINGLE_MESH) return;
    if (!document.mm()) throw MLException("There is no mesh. Open one with -i.");
    QStringList missing;
    if (!filter.plugin->isFilterApplicable(filter.action, *document.mm(), missing))
        throw MLException("The mesh lacks: " + missing.join(", "));
}

void afterFilter(MeshDocument& document) {
    for (MeshModel& mesh : document.meshIterator()) {
        vcg::tri::Allocator<CMeshO>::CompactEveryVector(mesh.cm);
        vcg::tri::UpdateBounding<CMeshO>::Box(mesh.cm);
    }
}

bool goOn(const int, const char*) {
    return true;
}

void runFilter(const LoadedFilter& filter, const RichParameterList& given, MeshDocument& document) {
    RichParameterList parameters = filter.plugin->initParameterList(filter.action, document);
    for (const RichParameter& parameter : given)
        setParameter(parameter, document, parameters);
    checkApplicable(filter, document);
    if (document.mm()) document.mm()->updateDataMask(filter.plugin->getRequirements(filter.action));
    filter.plugin->setLog(&document.Log);
    unsigned int changed = MeshModel::MM_UNKNOWN;
    filter.plugin->applyFilter(filter.action, parameters, document, changed, goOn);
    afterFilter(document);
}

void runFilter(const QDomElement& element, MeshDocument& document) {
    const LoadedFilter filter = filterNamed(element.attribute("name"));
    try {
        RichParameterList given;
        for (QDomElement parameter = element.firstChildElement("Param"); !parameter.isNull();
             parameter = parameter.nextSiblingElement("Param")) {
            given.pushFromQDomElement(parameter);
            checkParameter(parameter, given);
        }
        runFilter(filter, given, document);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw MLException(
            QString("The filter \"%1\" failed: %2").arg(element.attribute("name"), error.what()));
    }
}

}  // namespace

void runScript(const QString& file, MeshDocument& document, Report& report) {
    QDomDocument xml;
    QDomElement element = readXml(file, xml).firstChildElement("filter");
    for (; !element.isNull(); element = element.nextSiblingElement("filter")) {
        report.say("filter " + element.attribute("name"));
        runFilter(element, document);
        report.sayNewLines(document.Log);
    }
}

}  // namespace server
