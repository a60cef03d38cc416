// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "laplacian_lines/option_table.h"
#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

// Dialogs, scripts and settings from the core's option tables: a MeshLab parameter per row, named
// by its key, after a prefix. MeshLab's are floats; they are read back as the shortest decimal, so
// that 0.07 stays 0.07.

/// A row of an option table without its struct.
struct ParameterDescription {
    QString name;
    QString label;
    QString help;
    laplacian_lines::OptionKind kind;
    double minimum;
    double maximum;
    QStringList choices;
    QString allowed;  ///< values, after "It has to be"
};

template <class Options>
ParameterDescription describe(const laplacian_lines::OptionDescription<Options>& row,
                              const QString& prefix = QString()) {
    ParameterDescription result{prefix + row.key,
                                row.label,
                                row.help,
                                row.kind,
                                row.minimum,
                                row.maximum,
                                {},
                                QString::fromStdString(laplacian_lines::allowed_values(row))};
    for (const char* choice : row.choices)
        result.choices << choice;
    return result;
}

/// Help, HTML without paragraphs, so that MeshLab wraps it in a tool tip.
QString toolTip(const QString& help);

/// `diagonal` of the mesh's bounding box, for percentages of lengths; 0 without a mesh.
void addNumber(const ParameterDescription& description, double value, double diagonal,
               RichParameterList& list);

/// `fallback` if the list lacks it. @throws laplacian_lines::Error(InvalidOption) that names label,
/// value and range if the value is out of range or of another type
double readNumber(const ParameterDescription& description, double fallback,
                  const RichParameterList& list);

template <class Options>
void addParameter(const laplacian_lines::OptionDescription<Options>& row, const Options& defaults,
                  RichParameterList& list, double diagonal = 0) {
    addNumber(describe(row), row.get(defaults), diagonal, list);
}

/// Keeps the option if the list lacks it. @throws as readNumber()
template <class Options>
void readParameter(const laplacian_lines::OptionDescription<Options>& row, Options& options,
                   const RichParameterList& list) {
    row.set(options, readNumber(describe(row), row.get(options), list));
}

/// In world coordinates. Dialogs have a button that takes it from the view.
enum class PlaceKind { Position, Direction };
struct PlaceDescription {
    QString name;
    QString label;
    QString help;
    PlaceKind kind;
};

void addPlace(const PlaceDescription& description, const Eigen::Vector3d& value,
              RichParameterList& list);

/// `fallback` if the list lacks it. @throws laplacian_lines::Error(InvalidOption) for values that
/// are no finite points and directions of no length
Eigen::Vector3d readPlace(const PlaceDescription& description, const Eigen::Vector3d& fallback,
                          const RichParameterList& list);

/// A line of text, or a file to write, for which dialogs have a button from MeshLab 2022.02 on.
struct TextDescription {
    QString name;
    QString label;
    QString help;
    QString files = QString();  ///< "Drawings (*.svg *.pdf)"; empty: any text
};

void addText(const TextDescription& description, const QString& value, RichParameterList& list);

/// `fallback` if the list lacks it. @throws laplacian_lines::Error(InvalidOption) for other types
QString readText(const TextDescription& description, const QString& fallback,
                 const RichParameterList& list);

/// `fallback` if the list lacks it. Never throws.
QColor readColor(const QString& name, const QColor& fallback, const RichParameterList& list);

// Parameter values as people write and read them. Thread-safe.

/// A number; on, off, yes, no, true, false; or a choice, its number or an unambiguous beginning, in
/// any case. @throws laplacian_lines::Error(InvalidOption) that names label, text and allowed
/// values
double valueIn(const QString& text, const ParameterDescription& description);

/// As its field in a dialog shows it.
QString textOf(double value, const ParameterDescription& description);

/// @throws laplacian_lines::Error(InvalidOption) that names label, value and allowed values
[[noreturn]] void refuseValue(const QString& value, const QString& label, const QString& allowed);

}  // namespace meshlab_host
