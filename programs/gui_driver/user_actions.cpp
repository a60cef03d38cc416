// SPDX-License-Identifier: GPL-3.0-or-later
#include "user_actions.h"

#include <QRegularExpression>
#include <algorithm>

#include "decoration_table.h"
#include "laplacian_lines/option_table.h"

namespace driver {
namespace {

using laplacian_lines::OptionDescription;
using laplacian_lines::OptionKind;

// More would show nothing else, only slower.
constexpr std::size_t most_layers = 4;
constexpr int most_views = 3, most_documents = 3, most_faces = 4000;

/// What an action needs.
enum Need : unsigned {
    Layers = 1,
    Mesh = 2,      ///< a current layer
    Faces = 4,     ///< of the current layer
    FewFaces = 8,  ///< that they may be four times as many
    VisibleMesh =
        16,  ///< From 2022.02 on, a hidden layer is called visible after a reload, yet not drawn.
    Lines = 32,
    NoLines = 64,
    View = 128,
    OneView = 256,
    SeveralViews = 512,
    RoomForLayer = 1024,
    RoomForView = 2048,
    RoomForDocument = 4096,
    SeveralDocuments = 8192,
    LoosableFaces = 16384,  ///< faces that may be deleted
    SoundFaces = 32768,     ///< such as may be simplified
    NoPreview = 65536       ///< is offered
};

/// Lines of a driver's script. {1..3} is a number between, {a|b} one of these, {NAME} a value of
/// valueOf(); a line that begins with 1/4 comes in one of four cases. "filter NAME; SETTING; ..."
/// applies a filter from its dialog, which may stay open.
struct UserAction {
    int weight;  ///< how often
    unsigned needs;
    const char* lines;
};

constexpr UserAction open_mesh = {5, RoomForLayer, "open {mesh}\ncheck Laplacian Lines on"};
constexpr UserAction choose_layer = {6, Layers, "{select-layer|show-layer} {layer}"};
constexpr UserAction switch_on = {3, Mesh | NoLines,
                                  "check Laplacian Lines {on|on|on|on|on|on|off}"};

// Odd needs are what MeshLab itself does not survive: previews while a mesh is opened (2020.09);
// all faces deleted in several views (from 2022.02 on); the view closed from which the last dialog
// was opened (2020.09); the only project closed once more (up to 2022.02); a layer deleted that a
// dialog may have changed and then restores.
constexpr UserAction all_actions[] = {
    open_mesh,
    choose_layer,
    switch_on,
    {3, Lines, "check Laplacian Lines off"},
    {12, Lines, "{decoration}"},
    {10, Mesh, "filter Compute Laplacian Lines; {compute}"},
    {5, Mesh | RoomForLayer, "filter Generate Laplacian Lines Polylines; {polylines}"},
    {4, LoosableFaces,
     "filter Conditional Face Selection; boolean function = x0 > {-1.5..1.5}\n"
     "trigger Delete Selected Faces"},
    {1, LoosableFaces | OneView, "filter Delete ALL Faces"},
    {4, Mesh,
     "filter Per Vertex Geometric Function; func z = = {z + 0.1 * sin(5 * x)|z * 1000|z + 1000000|"
     "z * 1.1|z + 1|z / 0|z * 0.999}"},
    {3, Faces,
     "trigger Laplacian Smooth\nset Smoothing steps = 2\nset Preview = on\n1/3 {decoration}\n"
     "1/2 set Smoothing steps = 5\n1/2 set Preview = off\n1/2 apply\nclose"},
    {4, Faces, "filter Laplacian Smooth; Smoothing steps = {1|2|3}"},
    {3, Faces | FewFaces,
     "trigger Subdivision Surfaces: Loop\nset Iterations = 1\n"
     "set Edge Threshold (abs and %) = 1%\napply\nclose"},
    {3, LoosableFaces | SoundFaces,
     "filter Simplification: Quadric Edge Collapse Decimation; Target number of faces = {faces}"},
    {2, Faces, "filter Invert Faces Orientation; Force Flip = on"},
    {5, Mesh,
     "filter Matrix: Set from translation/rotation/scale; Freeze Matrix = {on|off}; "
     "X Translation = {-2..2}; Y Rotation = {-180..180}; X Scale = {1|0.5|-1|2|0|1000}"},
    {3, Mesh, "filter Matrix: Freeze Current Matrix"},
    {4, Mesh | VisibleMesh, "trigger Reload"},
    {3, Mesh, "stretch {0.8..1.2}"},  // as edit tools do, without a word to decorations
    {3, Mesh | RoomForLayer, "filter Duplicate Current layer"},
    {4, Layers | NoPreview, "delete-layer {layer}"},
    {4, Mesh | RoomForView, "trigger {Horizontally|Vertically}\ncheck Laplacian Lines on"},
    {3, SeveralViews | Faces,
     "view {other view}\ntrigger Laplacian Smooth\nclose\nview {view}\ntrigger Close current view"},
    {3, View, "view {view}"},
    {2, View, "look {-4..4} {-4..4} {0.1..4} 0 0 0"},
    {1, View, "look {-0.5..0.5} {-0.5..0.5} {0.1..0.5} 0 0 0"},  // perhaps inside
    {3, View, "wheel {-10..10}"},
    {3, View, "slot view resetTrackBall"},
    {3, View, "drag {0.2..0.8} {0.2..0.8} {0.2..0.8} {0.2..0.8} {left|middle}"},
    {3, View, "trigger Toggle Orthographic Camera"},
    {6, Mesh, "check {Points|Wireframe|Fill|Fill|Bounding Box} {on|off}"},
    {2, Mesh, "check {Show Normal|Show Box Corners|Show Trackball|Show Info Panel} {on|off}"},
    {2, View, "snapshot random.png {1|2}"},
    {2, RoomForDocument, "trigger New Empty Project...\nopen {mesh}\ncheck Laplacian Lines on"},
    {2, RoomForDocument, "slot window openProject scene.mlp\ncheck Laplacian Lines on"},
    {1, SeveralDocuments, "trigger Close Project"},
    {2, 0, "document {document}"},
};

/// MeshLab's own assertions may end it when faces are deleted that know their neighbours.
bool mayLoseFaces(const CMeshO& mesh) {
    return mesh.fn > 0 && !mesh.face.IsFFAdjacencyEnabled() && !mesh.vert.IsVFAdjacencyEnabled();
}

/// They also end it when it simplifies meshes with degenerate faces.
bool isSound(const CMeshO& mesh) {
    constexpr double least_area = 1e-8, largest = 1e4;
    return std::all_of(mesh.face.begin(), mesh.face.end(), [](const CFaceO& face) {
        if (face.IsD()) return true;
        const bool is_near = double(face.cP(0).Norm()) < largest &&
                             double(face.cP(1).Norm()) < largest &&
                             double(face.cP(2).Norm()) < largest;
        return is_near && vcg::DoubleArea(face) > least_area;
    });
}

// 2025.07 divides by the number of faces when it shows in a new view what had some until they were
// deleted.
bool mayBeShownAnew(const MeshModel* layer) {
    return layer->cm.fn > 0 || layer->cm.en > 0;
}

unsigned presentNeeds(const Situation& now) {
    unsigned needs = 0;
    const auto note = [&](unsigned need, bool is_there) { needs |= is_there ? need : 0; };
    note(Layers, !now.layers.empty());
    note(now.has_lines ? Lines : NoLines, true);
    note(View, now.views > 0);
    note(OneView, now.views == 1);
    note(SeveralViews, now.views > 1);
    note(RoomForLayer, now.layers.size() < most_layers);
    note(RoomForView, now.views < most_views &&
                          std::all_of(now.layers.begin(), now.layers.end(), mayBeShownAnew));
    note(RoomForDocument, now.documents < most_documents);
    note(SeveralDocuments, now.documents > 1);
    note(NoPreview, !now.has_preview);
    if (!now.current) return needs;
    const CMeshO& mesh = now.current->cm;
    note(Mesh, true);
    note(VisibleMesh, now.current->isVisible());
    note(Faces, mesh.fn > 0);
    note(FewFaces, mesh.fn <= most_faces / 4);
    note(LoosableFaces, mayLoseFaces(mesh));
    note(SoundFaces, isSound(mesh));
    return needs;
}

/// A field of a dialog and what a user may type into it.
struct Setting {
    QString label;
    OptionKind kind;
    double minimum, maximum, usual;

    QString with(double value) const {
        const QString text = kind == OptionKind::Boolean ? (value > 0 ? "on" : "off")
                                                         : QString::number(value, 'g', 6);
        return label + (kind == OptionKind::Length ? " (abs and %) = " : " = ") + text;
    }
};

template <class Options>
Setting settingOf(const OptionDescription<Options>& row) {
    return {row.label, row.kind, row.minimum, row.maximum, row.get(Options())};
}

/// Values of all ranges, also extreme and illegal ones.
QString randomly(Dice& dice, const Setting& setting) {
    if (setting.kind == OptionKind::Length)
        return setting.label + " (abs and %) = " + QString::number(dice.between(0, 12)) + '%';
    const bool is_real = setting.kind == OptionKind::Real;
    if (!is_real && setting.kind != OptionKind::Integer)
        return setting.with(dice.below(1 + int(setting.maximum)));
    const double usual = setting.usual * dice.between(0, 2.5),
                 any = dice.between(setting.minimum, setting.maximum);
    const int sort = dice.below(16);
    if (sort == 4 && is_real) return setting.label + " = nan";
    const double odd[] = {setting.minimum, setting.maximum, setting.minimum - 1,
                          setting.maximum * 2 + 1, setting.usual};
    if (sort < 5) return setting.with(odd[sort]);
    const double value = sort < 8 ? any : usual;
    return setting.with(is_real ? value : double(int(value)));
}

std::vector<Setting> decorationSettings() {
    std::vector<Setting> settings;
    for (const ParameterGroup& group : decorationTable())
        for (const ParameterRow& row : group.rows) {
            if (const auto* own = std::get_if<DecorationRow>(&row))
                settings.push_back(settingOf(*own));
            if (const auto* of_style = std::get_if<StyleRow>(&row))
                settings.push_back(settingOf(*of_style));
        }
    return settings;
}

/// One to four of the fields of a filter's dialog.
template <class Table>
QStringList someOf(Dice& dice, const Table& table, bool with_experts) {
    std::vector<Setting> settings;
    for (const auto& row : table)
        if (with_experts || !row.for_experts) settings.push_back(settingOf(row));
    QStringList result;
    for (int i = 1 + dice.below(4); i > 0; --i)
        result << randomly(dice, dice.from(settings));
    return result;
}

}  // namespace

QString UserActions::valueOf(const QString& name, const Situation& now) {
    if (name.contains('|')) return dice_.from(name.split('|'));
    if (name.contains("..")) {
        const QStringList ends = name.split("..");
        return QString::number(dice_.between(ends[0].toDouble(), ends[1].toDouble()));
    }
    if (name == "mesh") return dice_.from(meshes_);
    if (name == "layer") return QString::number(dice_.from(now.layers)->id());
    if (name == "view") return QString::number(chosen_view_);
    if (name == "other view") return QString::number((chosen_view_ + 1) % now.views);
    if (name == "document") return QString::number(dice_.below(now.documents));
    if (name == "faces") return QString::number(dice_.below(now.current->cm.fn + 1));
    if (name == "compute")
        return someOf(dice_, laplacian_lines::precompute_option_table(), true).join("; ");
    if (name == "polylines") {
        QStringList some = someOf(dice_, laplacian_lines::line_style_table(), false);
        if (dice_.oneIn(2))
            some << expand(
                "View = {0|1|2|3|4|5|6|7|8}; Viewpoint = {-5..5} {-5..5} {-5..5}; "
                "View Direction = {-1..1} {-1..1} {0|1}; Settings = {0|1}; "
                "Visible Lines Only = {on|off}",
                now);
        return some.join("; ");
    }
    // "decoration"
    if (!now.has_lines) return {};
    const Setting setting = dice_.from(decorationSettings());
    to_mend_ << "setdeco " + setting.with(setting.usual);
    return "setdeco " + randomly(dice_, setting);
}

QString UserActions::expand(QString text, const Situation& now) {
    static const QRegularExpression place("\\{([^}]*)\\}");
    for (QRegularExpressionMatch found; (found = place.match(text)).hasMatch();)
        text.replace(found.capturedStart(), found.capturedLength(),
                     valueOf(found.captured(1), now));
    return text;
}

QStringList UserActions::linesOf(const char* action, const Situation& now) {
    chosen_view_ = dice_.below(std::max(1, now.views));
    QStringList lines;
    for (QString line : QString(action).split('\n')) {
        static const QRegularExpression chance("^1/(\\d) ");
        if (const auto found = chance.match(line); found.hasMatch()) {
            if (!dice_.oneIn(found.captured(1).toInt())) continue;
            line.remove(0, found.capturedLength());
        }
        line = expand(line, now);
        if (!line.startsWith("filter ")) {
            if (!line.isEmpty()) lines << line;
            continue;
        }
        const QStringList parts = line.mid(7).split("; ");
        lines << "trigger " + parts[0];
        for (const QString& setting : parts.mid(1))
            lines << "set " + setting;
        lines << "apply";
        if (dice_.oneIn(4)) lines << "apply";
        if (!dice_.oneIn(6)) lines << "close";
    }
    return lines;
}

QStringList UserActions::next(const Situation& now) {
    const unsigned present = presentNeeds(now);
    const auto is_possible = [&](const UserAction& a) { return (a.needs & ~present) == 0; };
    // little can be done without faces, without lines, or with lines that are refused
    if (now.has_lines && !to_mend_.isEmpty() && dice_.oneIn(4)) {
        QStringList lines;
        lines.swap(to_mend_);
        return lines;
    }
    for (const auto& [action, is_due] :
         {std::pair(switch_on, (present & Faces) && dice_.oneIn(3)),
          {dice_.oneIn(2) ? open_mesh : choose_layer, !(present & Faces) && dice_.oneIn(3)}})
        if (is_due && is_possible(action)) return linesOf(action.lines, now);
    int total = 0;
    for (const UserAction& action : all_actions)
        total += is_possible(action) ? action.weight : 0;
    int left = dice_.below(total);
    for (const UserAction& action : all_actions)
        if (is_possible(action) && (left -= action.weight) < 0) return linesOf(action.lines, now);
    return {};
}

}  // namespace driver
