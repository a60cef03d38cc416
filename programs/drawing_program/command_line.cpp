// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <QFileInfo>
#include <functional>
#include <map>

#include "file_names.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/line_mixture.h"
#include "like.h"
#include "line_drawing/sheet_file.h"
#include "mesh_reading.h"

namespace {

using line_drawing::SheetOptions;
using line_drawing::UpAxis;

[[noreturn]] void refuse(const QString& sentence) {
    throw laplacian_lines::Error(laplacian_lines::ErrorCode::InvalidOption, sentence.toStdString());
}

/// One of the words that a choice has.
template <class Value>
Value chosen(const QString& option, const QString& word, const std::map<QString, Value>& choices) {
    const auto found = choices.find(word.toLower());
    if (found != choices.end()) return found->second;
    QStringList words;
    for (const auto& choice : choices)
        words << choice.first;
    refuse(QString("%1 is \"%2\". It has to be one of %3.").arg(option, word, words.join(", ")));
}

const std::map<QString, UpAxis> axes = {{"x", UpAxis::X}, {"y", UpAxis::Y}, {"z", UpAxis::Z}};
const std::map<QString, double> units = {{"mm", 1}, {"cm", 10}, {"m", 1000}, {"in", 25.4}};
const std::map<QString, line_drawing::Arrangement> arrangements = {
    {"first", line_drawing::Arrangement::FirstAngle},
    {"third", line_drawing::Arrangement::ThirdAngle}};
const std::map<QString, line_drawing::StrokeStyle> strokes = {
    {"tapered", line_drawing::StrokeStyle::Tapered}, {"plain", line_drawing::StrokeStyle::Plain}};
const std::map<QString, line_drawing::WallStyle> walls = {
    {"hatched", line_drawing::WallStyle::Hatched},
    {"filled", line_drawing::WallStyle::Filled},
    {"none", line_drawing::WallStyle::None}};
const std::map<QString, line_drawing::HiddenLines> hidden = {
    {"none", line_drawing::HiddenLines::LeftOut}, {"dashed", line_drawing::HiddenLines::Dashed}};
const std::map<QString, line_drawing::Weights> weights = {
    {"illustrator", line_drawing::Weights::Illustrator}, {"iso", line_drawing::Weights::Iso}};
const std::map<QString, line_drawing::OutlineArea> areas = {
    {"none", line_drawing::OutlineArea::None},
    {"filled", line_drawing::OutlineArea::Filled},
    {"objects", line_drawing::OutlineArea::Objects}};
const std::map<QString, Damaged> damaged = {{"refuse", Damaged::Refused}, {"draw", Damaged::Drawn}};
const std::map<QString, bool> furniture = {{"all", true}, {"none", false}};

const std::map<QString, QString> formats = {
    {"pdf", "pdf"}, {"svg", "svg"}, {"dxf", "dxf"}, {"png", "png"}};

double parseDpi(const QString& option, const QString& word) {
    bool is_number = false;
    const double dpi = word.toDouble(&is_number);
    if (!is_number || !(dpi >= 20 && dpi <= 2400))
        refuse(QString("%1 is \"%2\". It has to be a number from 20 to 2400.").arg(option, word));
    return dpi;
}

laplacian_lines::LineKindSet parseKinds(const QString& option, const QString& names) {
    const auto kinds = laplacian_lines::kinds_named(names.toStdString());
    if (!kinds)
        refuse(QString("%1 is \"%2\". It has to be some of %3, with commas between.")
                   .arg(option, names, QString::fromStdString(laplacian_lines::names_of_kinds())));
    return *kinds;
}

/// A folder of drawings is one that is there, or whose name ends like one.
void nameFiles(const QStringList& names, bool has_format, CommandLine& result) {
    if (names.size() < 2) refuse("name two files: the drawing and the mesh; see --help.");
    result.drawing = names[0];
    result.meshes = names.mid(1);
    result.is_collection = names[0].endsWith('/') || QFileInfo(names[0]).isDir();
    if (result.is_collection) return;
    result.meshes = meshesOf(result.meshes);
    if (has_format)
        refuse("--format is for a folder of drawings; the extension of a file sets its format.");
}

QString takeValue(QStringList& rest, const QString& option) {
    if (rest.isEmpty()) refuse(option + " needs a value; see --help.");
    return rest.takeFirst();
}

}  // namespace

CommandLine parseCommandLine(const QStringList& arguments) {
    CommandLine result;
    SheetOptions& options = result.options;
    QString views, sections;
    UpAxis up = UpAxis::Y;
    const std::map<QString, std::function<void(const QString&, const QString&)>> readers = {
        {"--views", [&](const QString&, const QString& v) { views = v; }},
        {"--section", [&](const QString&, const QString& v) { sections += ' ' + v; }},
        {"--up", [&](const QString& o, const QString& v) { up = chosen(o, v, axes); }},
        {"--scale",
         [&](const QString&, const QString& v) { options.scale = line_drawing::parseScale(v); }},
        {"--paper", [&](const QString&, const QString& v) { options.paper = v; }},
        {"--unit",
         [&](const QString& o, const QString& v) { options.mm_per_unit = chosen(o, v, units); }},
        {"--arrangement",
         [&](const QString& o, const QString& v) {
             options.arrangement = chosen(o, v, arrangements);
         }},
        {"--strokes",
         [&](const QString& o, const QString& v) { options.strokes = chosen(o, v, strokes); }},
        {"--wall", [&](const QString& o, const QString& v) { options.wall = chosen(o, v, walls); }},
        {"--kinds",
         [&](const QString& o, const QString& v) { options.style.shows = parseKinds(o, v); }},
        {"--kernel", [&](const QString&,
                         const QString& v) { options.kernel = line_drawing::parseDetailSize(v); }},
        {"--smoothing",
         [&](const QString&, const QString& v) {
             options.smoothing = line_drawing::parseDetailSize(v);
         }},
        {"--hidden",
         [&](const QString& o, const QString& v) { options.hidden = chosen(o, v, hidden); }},
        {"--weights",
         [&](const QString& o, const QString& v) {
             options.pens = line_drawing::pensOf(chosen(o, v, weights));
         }},
        {"--area", [&](const QString& o, const QString& v) { options.area = chosen(o, v, areas); }},
        {"--furniture",
         [&](const QString& o, const QString& v) {
             options.has_view_names = options.has_scale_bar = options.has_notes =
                 chosen(o, v, furniture);
         }},
        {"--damaged",
         [&](const QString& o, const QString& v) { result.damaged = chosen(o, v, damaged); }},
        {"--format",
         [&](const QString& o, const QString& v) { result.format = chosen(o, v, formats); }},
        {"--dpi", [&](const QString& o, const QString& v) { result.dpi = parseDpi(o, v); }},
        {"--contact-view", [&](const QString&, const QString& v) { result.contact_view = v; }},
        {"--title", [&](const QString&, const QString& v) { options.title = v; }}};
    QStringList rest = arguments, names;
    bool has_format = false;
    while (!rest.isEmpty()) {
        const QString word = rest.takeFirst();
        if (word == "-h" || word == "--help") {
            result.help = true;
        } else if (word == "--version") {
            result.version = true;
        } else if (word == "--like") {
            result.like = likeOf(takeValue(rest, word));
            rest = *result.like->options + rest;
        } else if (const auto reader = readers.find(word); reader != readers.end()) {
            const QString value = takeValue(rest, word);
            reader->second(word, value);
            has_format = has_format || word == "--format";
            if (word != "--format" && word != "--contact-view") result.words << word << value;
        } else if (word == "--") {
            names << rest;
            rest.clear();
        } else if (word.startsWith("--")) {
            refuse("unknown option " + word + "; see --help.");
        } else {
            names << word;
        }
    }
    if (result.help || result.version) return result;
    nameFiles(names, has_format, result);
    options.up = up;
    options.sections = line_drawing::parseSections(sections);
    if (views.isEmpty() && options.sections.empty()) views = "front";
    if (!views.isEmpty()) options.views = line_drawing::parseViews(views, up);
    if (result.is_collection) return result;
    QStringList mesh_names;
    for (const QString& mesh : result.meshes)
        mesh_names << readable(QFileInfo(mesh).completeBaseName());
    options.title.replace("{name}", mesh_names.join(", "));
    options.strokes = line_drawing::strokesIn(result.drawing, options.strokes);
    return result;
}

const char* usage() {
    return "laplacian-lines FILE.svg|.pdf|.dxf|.png [OPTION...] MESH|FOLDER...\n"
           "                       a measured drawing of a mesh, or of several that hide each "
           "other\n"
           "laplacian-lines FOLDER/ [OPTION...] MESH|FOLDER...\n"
           "                       one of each, and a contact sheet; what is there and unchanged "
           "is\n"
           "                       not drawn again\n"
           "\n"
           "  --views VIEWS        front, back, left, right, top, bottom, six (all of these), "
           "vessel\n"
           "                       (half section, half view), or AZIMUTH,ELEVATION in degrees;\n"
           "                       several with commas (front)\n"
           "  --section x|y|z=0..1 a section across an axis, 0 and 1 being the object's ends;\n"
           "                       more than one if repeated\n"
           "  --wall hatched|filled|none  what sections cut (hatched)\n"
           "  --kinds NAMES        of lines, with the outlines: usual, laplacian_lines, ridges,\n"
           "                       apparent_ridges and so on, with commas; a wrong one lists all\n"
           "  --kernel auto|1mm|0.9%      detail of inner lines: a length on paper, or a share of "
           "the\n"
           "                       object's diagonal; auto: four pens of inner lines (auto)\n"
           "  --smoothing auto|0.3mm|0.2% of the surface before lines are found (auto)\n"
           "  --hidden none|dashed outlines and creases behind the surface (none)\n"
           "  --weights illustrator|iso   outlines widest, or edges as wide as they (illustrator)\n"
           "  --area none|filled|objects  what the outline of all, or of each object alone,\n"
           "                       encloses, as areas besides (none)\n"
           "  --up x|y|z           the axis of the mesh that points up (y)\n"
           "  --unit mm|cm|m|in    the unit of the mesh (mm)\n"
           "  --scale 1:2|fit      drawn to true length; fit: the largest usual one (fit)\n"
           "  --paper a5..a0|fit   fit: as large as the drawing (a4)\n"
           "  --arrangement first|third   of the views: first or third angle (first)\n"
           "  --strokes tapered|plain     lines that swell and taper, or of even width (tapered)\n"
           "  --damaged refuse|draw       files that are not whole; what is drawn of them is "
           "called\n"
           "                       incomplete on the sheet (refuse)\n"
           "  --title TEXT         above the note of scale, size and file; {name}: the mesh's\n"
           "  --furniture all|none names of views, scale bar, projection symbol, notes (all)\n"
           "  --dpi 20..2400       of PNG files (300)\n"
           "  --format pdf|svg|dxf|png    of the drawings in FOLDER (pdf)\n"
           "  --like FILE          with the options that a drawing (SVG, PDF, DXF) was made with;\n"
           "                       others that follow count more\n"
           "  --version            of this program\n"
           "  --help               this text\n";
}
