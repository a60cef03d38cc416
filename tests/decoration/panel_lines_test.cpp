// SPDX-License-Identifier: GPL-3.0-or-later
#include "decoration_parameters.h"

#include <gtest/gtest.h>

#include <map>

#include "decoration_table.h"
#include "laplacian_lines/option_table.h"

namespace {

using line_renderer::SurfaceAppearance;
using meshlab_host::PanelField;
using meshlab_host::PanelLine;

const QString kPrefix = "MeshLab::Decoration::LaplacianLines_";

/// By key.
std::map<std::string, PanelField> fieldsFor(const ValidParameters& parameters) {
    std::map<std::string, std::string> keys;
    for (const DecorationField& field : decorationFields())
        keys[field.label.toStdString()] = field.key;
    std::map<std::string, PanelField> fields;
    for (const PanelLine& line : panelLines(parameters))
        for (const PanelField& field : line)
            EXPECT_TRUE(fields.emplace(keys.at(field.label.toStdString()), field).second)
                << field.label.toStdString();
    return fields;
}

TEST(PanelLines, HaveEachParameterOnce) {
    EXPECT_EQ(fieldsFor({}).size(), decorationFields().size());
}

TEST(PanelLines, ShowThoseForExpertsWhenAsked) {
    ValidParameters parameters;
    int hidden = 0;
    const auto basic = fieldsFor(parameters);
    parameters.chosen.shown = ShownParameters::All;
    for (const auto& [key, field] : fieldsFor(parameters)) {
        EXPECT_TRUE(field.is_shown) << key;
        if (!basic.at(key).is_shown) ++hidden;
    }
    EXPECT_GT(hidden, 20);
    EXPECT_LE(basic.size() - std::size_t(hidden), 12u) << "at first sight";
    EXPECT_LE(basic.size(), 60u);
    for (const char* key : {"drawing_style", "parameters", "hidden_lines", "line_color"})
        EXPECT_TRUE(basic.at(key).is_shown) << key;
    for (const DecorationField& field : decorationFields())
        EXPECT_EQ(basic.at(field.key).is_shown, !field.for_experts) << field.key;
    for (const char* key : {"lines", "contours", "laplacian_lines"})
        EXPECT_TRUE(basic.at(key).is_shown) << key;
}

/// As far as drawing styles and mixtures matter.
bool drawAlike(const DecorationParameters& a, const DecorationParameters& b) {
    bool looks_alike = true;
    for (const auto& kind : laplacian_lines::line_kinds) {
        const auto look = std::size_t(kind.kind);
        if (a.style.shows[kind.kind] &&
            a.appearance.looks[look].color != b.appearance.looks[look].color)
            looks_alike = false;
    }
    const bool is_lit = a.style.shows[laplacian_lines::LineKind::Laplacian] ||
                        a.style.shows[laplacian_lines::LineKind::PhoticExtremum];
    const bool is_toon = a.surface.style == SurfaceAppearance::Toon;
    for (const auto& kind : laplacian_lines::line_kinds)
        looks_alike = looks_alike && a.style.shows[kind.kind] == b.style.shows[kind.kind];
    return looks_alike && a.surface.style == b.surface.style &&
           a.surface.paper == b.surface.paper && a.background == b.background &&
           (!is_toon ||
            (a.surface.tones == b.surface.tones && a.surface.shade == b.surface.shade)) &&
           (!is_lit || a.light == b.light) &&
           (!is_lit || a.light == Light::AtTheEye ||
            (a.camera_light.azimuth == b.camera_light.azimuth &&
             a.camera_light.elevation == b.camera_light.elevation));
}

/// Changes each parameter of this kind.
std::vector<std::pair<std::string, RichParameterList>> changes(int drawing_style, int surface,
                                                               int lines) {
    const std::vector<std::pair<const char*, int>> numbers = {
        {"surface", (surface + 1) % 3}, {"background", 1}, {"light", 1}};
    std::vector<std::pair<std::string, RichParameterList>> result;
    const auto begin = [&](const char* key) -> RichParameterList& {
        RichParameterList list;
        list.addParam(RichEnum(kPrefix + "drawing_style", drawing_style, {"0", "1", "2"}, "", ""));
        list.addParam(RichEnum(kPrefix + "lines", lines, QStringList(), "", ""));
        if (std::string(key) != "surface")
            list.addParam(RichEnum(kPrefix + "surface", surface, {"0", "1", "2"}, "", ""));
        result.emplace_back(key, list);
        return result.back().second;
    };
    for (const auto& [key, value] : numbers)
        begin(key).addParam(RichEnum(kPrefix + key, value, {"0", "1", "2"}, "", ""));
    for (const char* key : {"line_color", "contour_color", "paper_color", "highlight_color"})
        begin(key).addParam(RichColor(kPrefix + key, Qt::green, "", ""));
    begin("tones").addParam(RichInt(kPrefix + "tones", 5, "", ""));
    for (const char* key : {"light_azimuth", "light_elevation"})
        begin(key).addParam(RichFloat(kPrefix + key, 11, "", ""));
    for (const auto& kind : laplacian_lines::line_kinds)
        begin(kind.key).addParam(RichBool(kPrefix + kind.key, !kind.shown, "", ""));
    return result;
}

void expectOffIsWithoutEffect(int style, int surface, int lines) {
    RichParameterList unchanged;
    unchanged.addParam(RichEnum(kPrefix + "drawing_style", style, {"0", "1", "2"}, "", ""));
    unchanged.addParam(RichEnum(kPrefix + "surface", surface, {"0", "1", "2"}, "", ""));
    unchanged.addParam(RichEnum(kPrefix + "lines", lines, QStringList(), "", ""));
    const ValidParameters before = readValidParameters(unchanged);
    const auto fields = fieldsFor(before);
    for (const auto& [key, list] : changes(style, surface, lines))
        EXPECT_EQ(fields.at(key).obstacle.isEmpty(),
                  !drawAlike(before.chosen, readValidParameters(list).chosen))
            << key << " in style " << style << " with surface " << surface << " and lines "
            << lines;
}

/// In every style, with every surface and choice of lines, a switched-off parameter changes
/// nothing.
TEST(PanelLines, SwitchOffWhatHasNoEffect) {
    for (int style : {0, 1, 2})
        for (int surface : {0, 1, 2})
            for (int lines = 0; lines <= int(laplacian_lines::line_mixtures.size()); ++lines)
                expectOffIsWithoutEffect(style, surface, lines);
}

TEST(PanelLines, SwitchOffWhatOtherKindsNeed) {
    RichParameterList list;
    list.addParam(RichEnum(kPrefix + "lines", 4, QStringList(), "", ""));  // apparent ridges
    const auto fields = fieldsFor(readValidParameters(list));
    for (const char* key : {"single_strokes", "ridge_angle", "crease_angle", "scale", "light"})
        EXPECT_FALSE(fields.at(key).obstacle.isEmpty()) << key;
    for (const char* key : {"detail", "whole_lines", "fading", "contour_color", "line_color"})
        EXPECT_TRUE(fields.at(key).obstacle.isEmpty()) << key;
}

TEST(PanelLines, ShowWhatIsOutOfRange) {
    ValidParameters parameters;
    parameters.refused = {{"tones", "too many"}, {"fading", "too faint"}};
    const auto fields = fieldsFor(parameters);
    EXPECT_TRUE(fields.at("fading").is_shown);
    EXPECT_TRUE(fields.at("tones").is_shown);
    EXPECT_TRUE(fields.at("tones").obstacle.isEmpty());
    EXPECT_EQ(fields.at("tones").fault, "too many");
    EXPECT_EQ(fields.at("surface").fault, "");
    EXPECT_FALSE(fields.at("paper_color").is_shown);
}

}  // namespace
