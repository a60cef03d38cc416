// SPDX-License-Identifier: GPL-3.0-or-later
// Filters as a host calls them: progress rises to the end, the callback can cancel, and other
// versions' parameters are ignored.
#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <array>
#include <set>

#include "add_layer.h"
#include "filters.h"
#include "meshlab_host/field_attributes.h"
#include "registry.h"
#include "with_threads.h"

namespace {

enum FilterNumber { Compute, Polylines, Drawing };

class Plugin : public meshlab_host::FilterPluginBase {
public:
    Plugin() : FilterPluginBase("TestedFilters", make_filters()) {}

    RichParameterList defaults(FilterNumber filter, MeshDocument& document) {
        QAction* action = action_of(filter);
#if MESHLAB_API < 2022
        RichParameterList list;
        initParameterSet(action, document, list);
        return list;
#else
        return initParameterList(action, document);
#endif
    }

    /// The message for the user, if any.
    QString apply(FilterNumber filter, MeshDocument& document, const RichParameterList& list,
                  vcg::CallBackPos* callback) {
        QAction* action = action_of(filter);
#if MESHLAB_API < 2022
        return applyFilter(action, document, list, callback) ? QString() : errorMsg();
#else
        try {
            unsigned int changed = 0;
            applyFilter(action, list, document, changed, callback);
            return QString();
        } catch (const MLException& error) {
            return error.what();
        }
#endif
    }

#if MESHLAB_API >= 2022
    std::pair<std::string, bool> getMLVersion() const override {  // else what moc's plugins have
        return {};
    }
#endif

private:
    QAction* action_of(FilterNumber filter) const {
        const auto list = actions();
        return *std::next(list.begin(), filter);
    }
};

int layer_count(const MeshDocument& document) {
#if MESHLAB_API < 2022
    return document.size();
#else
    return int(document.meshNumber());
#endif
}

constexpr int kNever = 101;

/// The callback's log and when it cancels; a plain function cannot hold it.
struct Record {
    std::vector<int> percents;
    int cancel_from = kNever;  ///< percent; how many calls there are depends on the machine
    int calls_after = 0;       ///< since it said to stop
    bool has_cancelled = false;
} record;

bool callback(const int percent, const char*) {
    record.calls_after += record.has_cancelled;
    record.percents.push_back(percent);
    record.has_cancelled = record.has_cancelled || percent >= record.cancel_from;
    return !record.has_cancelled;
}

class FilterProgress : public testing::TestWithParam<FilterNumber> {
protected:
    FilterProgress() {
        add_layer(document, "bumpy_sphere", test_meshes::mesh_named("bumpy_sphere").mesh);
    }

    QString run(int cancel_from) {
        record = {{}, cancel_from};
        RichParameterList list = plugin.defaults(GetParam(), document);
        if (GetParam() == Drawing) list.setValue("file", StringValue(drawing()));
        return plugin.apply(GetParam(), document, list, callback);
    }
    QString drawing() const { return folder.filePath("drawing.svg"); }
    const CMeshO& mesh() { return document.mm()->cm; }

    QTemporaryDir folder;
    MeshDocument document;
    Plugin plugin;
};

/// All that a filter might leave in a layer.
struct LayerState {
    explicit LayerState(const CMeshO& mesh)
        : stamp(meshlab_host::geometry_stamp(mesh)),
          vertex_attributes(mesh.vert_attr.size()),
          mesh_attributes(mesh.mesh_attr.size()),
          field(meshlab_host::read_field(mesh, stamp)) {}

    meshlab_host::GeometryStamp stamp;
    std::size_t vertex_attributes, mesh_attributes;
    std::optional<laplacian_lines::Field> field;
};

void expect_same(const LayerState& a, const LayerState& b) {
    EXPECT_EQ(a.stamp, b.stamp);
    EXPECT_EQ(a.vertex_attributes, b.vertex_attributes);
    EXPECT_EQ(a.mesh_attributes, b.mesh_attributes);
    ASSERT_EQ(a.field.has_value(), b.field.has_value());
    if (!a.field) return;
    EXPECT_EQ(a.field->normals, b.field->normals);
    EXPECT_EQ(a.field->laplacian_normals, b.field->laplacian_normals);
}

TEST_P(FilterProgress, RisesFromTheBeginningToTheEnd) {
    const LayerState before(mesh());
    ASSERT_EQ(run(kNever).toStdString(), "");
    if (GetParam() == Drawing) expect_same(before, LayerState(mesh()));
    ASSERT_GE(record.percents.size(), 5u);
    EXPECT_TRUE(std::is_sorted(record.percents.begin(), record.percents.end()));
    EXPECT_GE(record.percents.front(), 0);
    EXPECT_LE(record.percents.front(), 10);
    EXPECT_EQ(record.percents.back(), 100);
}

TEST_P(FilterProgress, MovesWithEachStepOfAnyWork) {
    // One thread: only the calling one reports.
    const test_meshes::WithThreads scope(1);
    ASSERT_EQ(run(kNever).toStdString(), "");
    const std::set<int> from_the_mesh(record.percents.begin(), record.percents.end());
    EXPECT_GE(from_the_mesh.size(), 20u);
    document.setCurrentMesh(0);  // not the lines
    const RichParameterList list = plugin.defaults(Compute, document);
    ASSERT_EQ(plugin.apply(Compute, document, list, nullptr).toStdString(), "");
    ASSERT_EQ(run(kNever).toStdString(), "");
    const std::set<int> from_its_attributes(record.percents.begin(), record.percents.end());
    EXPECT_GE(from_its_attributes.size(), 5u);
}

TEST_P(FilterProgress, StopsAtOnceAndLeavesNothingBehind) {
    const LayerState before(mesh());
    for (const int percent : {0, 1, 5, 12, 25, 37, 50, 75, 90, 99, 100}) {
        SCOPED_TRACE(percent);
        EXPECT_NE(run(percent).toStdString().find("Cancelled"), std::string::npos);
        EXPECT_EQ(record.calls_after, 0);
        expect_same(before, LayerState(mesh()));
        EXPECT_EQ(layer_count(document), 1);
        EXPECT_FALSE(QFile::exists(drawing()));
    }
}

TEST_P(FilterProgress, KeepsEarlierResultsWhenCancelled) {
    RichParameterList list = plugin.defaults(Compute, document);
    ASSERT_EQ(plugin.apply(Compute, document, list, nullptr).toStdString(), "");
    const LayerState before(mesh());
    ASSERT_TRUE(before.field);
    EXPECT_NE(run(30).toStdString(), "");
    expect_same(before, LayerState(mesh()));
}

/// But for MeshLab's own, which it adds.
TEST_P(FilterProgress, ParametersOfOtherVersionsAreIgnoredAndNamed) {
    GLLogStream log;
    plugin.setLog(&log);
    RichParameterList list = plugin.defaults(GetParam(), document);
    if (GetParam() == Drawing) list.setValue("file", StringValue(drawing()));
    for (const char* name : {"accuracy", "MeshLab::Appearance::x", "strokes"})
        list.addParam(RichFloat(name, 1, "", ""));
    ASSERT_EQ(plugin.apply(GetParam(), document, list, nullptr).toStdString(), "");
    int found = 0;
    for (const auto& line : log.logStringList())
        found += line.second == "Parameters of another version are ignored: accuracy, strokes.";
    EXPECT_EQ(found, 1);
}

std::string name_of(const testing::TestParamInfo<FilterNumber>& info) {
    const std::array<const char*, 3> names = {"Compute", "Polylines", "Drawing"};
    return names.at(std::size_t(info.param));
}

INSTANTIATE_TEST_SUITE_P(Filters, FilterProgress, testing::Values(Compute, Polylines, Drawing),
                         name_of);

}  // namespace
