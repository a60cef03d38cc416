// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing_parameters.h"

#include <QDir>
#include <QFileInfo>
#include <cmath>
#include <variant>

#include "laplacian_lines/option_rows.h"
#include "mesh_unit.h"
#include "meshlab_host/camera.h"
#include "meshlab_host/parameter_text.h"
#include "settings_choice.h"
#include "view_words.h"

namespace {

using Parameters = DrawingParameters;
using Row = laplacian_lines::OptionDescription<Parameters>;
namespace rows = laplacian_lines::option_rows;

const QString key_prefix;  // scripts use the keys as they are

struct TextRow {
    meshlab_host::TextDescription description;
    QString Parameters::*value;
};
using AnyRow = std::variant<Row, TextRow>;

/// Dialogs fit small screens.
Row folded(Row row) {
    row.for_experts = true;
    return row;
}

std::vector<const char*> paperChoices() {
    std::vector<const char*> names = line_drawing::paperNames();
    names.push_back("fit");
    return names;
}

std::vector<const char*> unitChoices() {
    std::vector<const char*> names;
    for (const MeshUnit& unit : mesh_units)
        names.push_back(unit.name);
    return names;
}

std::vector<AnyRow> makeRows() {
    return {
        TextRow{{"file", drawing_labels::file,
                 "The extension sets the format: .svg, .pdf, .dxf or .png. A file of this name is "
                 "replaced.",
                 drawing_files},
                &Parameters::file},
        TextRow{
            {"views", drawing_labels::views,
             "Several with commas: window, as in MeshLab, front, back, left, right, top, bottom, "
             "six (all of these), vessel (half section, half view), or two angles, azimuth and "
             "elevation, such as 30,15."},
            &Parameters::views},
        TextRow{{"scale", "Scale",
                 "Drawn to true length, such as 1:2 or 2:1; fit: the largest usual one that fits "
                 "the paper."},
                &Parameters::scale},
        rows::choice<&Parameters::paper>(
            "paper", "Paper", paperChoices(),
            "Upright or lying, whichever takes the drawing larger. fit: as large as the drawing."),
        rows::choice<&Parameters::unit>(
            "unit", "Unit of the Mesh", unitChoices(),
            "What a length of 1 is. The dialog begins with m below a size of 10, else mm."),
        rows::choice<&Parameters::up>("up", "Upward Axis", {"x", "y", "z"},
                                      "The axis of the world that points up in named views."),
        TextRow{{"sections", "Sections",
                 "What planes across the axes of the world cut: such as x=0.5 y=0.3, where 0 to 1 "
                 "runs from one end of the object to the other. Empty: none."},
                &Parameters::sections},
        TextRow{{"title", "Title", "Stands above the note of scale, size and file."},
                &Parameters::title},
        rows::choice<&Parameters::is_of_all_layers>(
            "layers", "Layers", {"Current Layer", "All Visible Layers"},
            "All Visible Layers: together, as they stand, hiding each other."),
        rows::choice<&Parameters::settings>(
            "settings", "Settings", settingsNames({"Defaults", "As the Decoration"}),
            "As the Decoration: lines and light as the decoration Laplacian Lines has drawn them "
            "last. Needs a window in which it has drawn. The others: lines of these kinds, with "
            "the outlines."),
        folded(rows::choice<&Parameters::arrangement>(
            "arrangement", "Arrangement", {"First Angle", "Third Angle"},
            "How views lie around the front view. First angle (Europe): what is seen from the left "
            "stands on the right; third angle (America): on the left.")),
        folded(rows::choice<&Parameters::strokes>(
            "strokes", "Strokes", {"Tapered", "Plain"},
            "Lines that swell and taper as in MeshLab's view, or of even width, for plotters and "
            "CAD; those of DXF are always plain.")),
        folded(rows::choice<&Parameters::wall>(
            "wall", "Walls", {"Hatched", "Filled", "None"},
            "What sections cut: hatched, black, or its outline alone.")),
        folded(
            rows::choice<&Parameters::hidden>("hidden", "Hidden Lines", {"None", "Dashed"},
                                              "Outlines, borders and creases behind the surface.")),
        folded(rows::choice<&Parameters::weights>(
            "weights", "Line Weights", {"Illustrator", "ISO 128"},
            "Illustrator: outlines are widest, edges within the form thin. ISO 128: edges that are "
            "seen are as wide as outlines, other lines half as wide.")),
        folded(rows::boolean<&Parameters::has_furniture>(
            "furniture", "Scale Bar and Notes",
            "Names of views, scale bar, symbol of the projection, notes of scale, size and "
            "file."))};
}

const std::vector<AnyRow>& allRows() {
    static const std::vector<AnyRow> all = makeRows();
    return all;
}

struct Lister {
    const Parameters& defaults;
    RichParameterList& list;

    void operator()(const Row& row) {
        meshlab_host::addParameter(meshlab_host::describe(row, key_prefix), row.get(defaults), 0,
                                   list);
    }
    void operator()(const TextRow& row) {
        meshlab_host::addText(row.description, defaults.*row.value, list);
    }
};

struct ParameterReader {
    Parameters& result;
    const RichParameterList& list;

    void operator()(const Row& row) {
        row.set(result, meshlab_host::readParameter(meshlab_host::describe(row, key_prefix),
                                                    row.get(result), list));
    }
    void operator()(const TextRow& row) {
        result.*row.value = meshlab_host::readText(row.description, result.*row.value, list);
    }
};

struct FieldWriter {
    const Parameters& parameters;

    DrawingField operator()(const Row& row) const {
        const meshlab_host::ParameterDescription d = meshlab_host::describe(row, key_prefix);
        return {d.name, d.label, meshlab_host::textOf(row.get(parameters), d)};
    }
    DrawingField operator()(const TextRow& row) const {
        return {row.description.name, row.description.label, parameters.*row.value};
    }
};

struct FieldReader {
    Parameters& result;
    const std::function<std::optional<QString>(const QString& label)>& text_of;

    void operator()(const Row& row) {
        const meshlab_host::ParameterDescription d = meshlab_host::describe(row, key_prefix);
        if (const auto text = text_of(d.label)) row.set(result, meshlab_host::valueIn(*text, d));
    }
    void operator()(const TextRow& row) {
        if (const auto text = text_of(row.description.label)) result.*row.value = *text;
    }
};

/// As the layer stands in the world.
double diagonalOf(const MeshModel& layer) {
    const Eigen::Matrix4d transform = meshlab_host::layerTransform(layer.cm);
    const double factor = std::cbrt(std::abs(transform.topLeftCorner<3, 3>().determinant()));
    return factor * double(layer.cm.bbox.Diag());
}

}  // namespace

DrawingParameters drawingDefaults(const MeshModel* mesh, bool has_window) {
    Parameters result;
    if (has_window) result.views = window_view;
    if (has_window && mesh) result.unit = likelyUnit(diagonalOf(*mesh));
    if (mesh && !mesh->fullName().isEmpty()) {
        const QFileInfo file(mesh->fullName());
        result.file = file.dir().filePath(file.completeBaseName() + "_drawing.svg");
    }
    return result;
}

void listDrawingParameters(const DrawingParameters& defaults, RichParameterList& list) {
    for (const AnyRow& row : allRows())
        std::visit(Lister{defaults, list}, row);
}

std::vector<DrawingField> fieldsOf(const DrawingParameters& parameters) {
    std::vector<DrawingField> fields;
    for (const AnyRow& row : allRows())
        fields.push_back(std::visit(FieldWriter{parameters}, row));
    return fields;
}

DrawingParameters drawingParametersIn(
    const std::function<std::optional<QString>(const QString& label)>& text_of) {
    Parameters result;
    for (const AnyRow& row : allRows())
        std::visit(FieldReader{result, text_of}, row);
    return result;
}

std::vector<meshlab_host::ParameterDescription> describeDrawingParameters() {
    std::vector<meshlab_host::ParameterDescription> result;
    for (const AnyRow& any : allRows())
        if (const Row* row = std::get_if<Row>(&any))
            result.push_back(meshlab_host::describe(*row, key_prefix));
    return result;
}

DrawingParameters readDrawingParameters(const RichParameterList& list) {
    Parameters result;
    for (const AnyRow& row : allRows())
        std::visit(ParameterReader{result, list}, row);
    return result;
}
