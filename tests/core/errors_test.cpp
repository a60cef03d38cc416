// SPDX-License-Identifier: GPL-3.0-or-later
// Wrong options, indices and fields are refused with a sentence that names what is wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "helpers.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/field_columns.h"
#include "laplacian_lines/option_table.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;
using test_meshes::kInfinity;
using test_meshes::kNaN;

const TriangleMesh& small_mesh() {
    return test_meshes::mesh_named("single_triangle").mesh;
}

/// Returns the error's sentence.
std::string expect_error(ErrorCode code, const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        EXPECT_EQ(int(error.code()), int(code)) << error.what();
        const std::string message = error.what();
        EXPECT_GT(message.size(), 15u);
        EXPECT_EQ(message.back(), '.');
        return message;
    }
    ADD_FAILURE() << "no error";
    return {};
}

/// As far as the row's type can hold them.
template <class Options>
std::vector<double> bad_values(const OptionRow<Options>& row) {
    if (row.kind == OptionKind::Boolean) return {};
    if (row.kind == OptionKind::Choice) return {row.minimum - 1, row.maximum + 1};
    std::vector<double> values = {std::nextafter(row.minimum, -kInfinity), kNaN, -kInfinity,
                                  kInfinity};
    if (row.maximum < 1e300) values.push_back(std::nextafter(row.maximum, kInfinity));
    return values;
}

TEST(InvalidOption, NamesEachPrecomputeOption) {
    for (const auto& row : precompute_option_table())
        for (double value : bad_values(row)) {
            PrecomputeOptions options;
            row.set(options, value);
            for (const auto& call : std::vector<std::function<void()>>{
                     [&] { validate(options); }, [&] { precompute(small_mesh(), options); },
                     [&] { measure_scale(small_mesh(), options); }}) {
                const std::string message = expect_error(ErrorCode::InvalidOption, call);
                EXPECT_NE(message.find(row.label), std::string::npos) << message;
                for (const char* choice : row.choices)
                    EXPECT_NE(message.find(choice), std::string::npos) << message;
            }
        }
}

TEST(InvalidOption, NamesThoseForDrawings) {
    for (const double value : {-1., kNaN, kInfinity}) {
        PrecomputeOptions options;
        options.drawn_kernel_size = value;
        const std::string message =
            expect_error(ErrorCode::InvalidOption, [&] { precompute(small_mesh(), options); });
        EXPECT_NE(message.find("drawn_kernel_size"), std::string::npos) << message;
        options.drawn_kernel_size = 1;
        options.least_drawn_edges = value;
        const std::string other =
            expect_error(ErrorCode::InvalidOption, [&] { measure_scale(small_mesh(), options); });
        EXPECT_NE(other.find("least_drawn_edges"), std::string::npos) << other;
    }
}

TEST(InvalidOption, NamesEachStyleOption) {
    const LineExtractor extractor(small_mesh(), precompute(small_mesh()));
    for (const auto& row : line_style_table())
        for (double value : bad_values(row)) {
            LineStyle style;
            row.set(style, value);
            expect_error(ErrorCode::InvalidOption, [&] { validate(style); });
            const std::string message = expect_error(ErrorCode::InvalidOption, [&] {
                helpers::extract(extractor, View::orthographic(Eigen::Vector3d::UnitX()), style);
            });
            EXPECT_NE(message.find(row.label), std::string::npos) << message;
        }
}

TEST(InvalidOption, ViewsWhoseEyeOrLightIsZeroOrNotFinite) {
    const LineExtractor extractor(small_mesh(), precompute(small_mesh()));
    for (const View& view :
         {View::orthographic(Eigen::Vector3d::Zero()), View::perspective({0, kNaN, 0}),
          View::perspective({kInfinity, 0, 0}), View::orthographic({0, 0, kInfinity}),
          View{{1, 0, 0}, kNaN}, View{{1, 0, 0}, kInfinity},
          View{{1, 0, 0}, 1, Eigen::Vector3d(0, 0, 0)},
          View{{1, 0, 0}, 1, Eigen::Vector3d(0, kNaN, 1)}})
        expect_error(ErrorCode::InvalidOption,
                     [&] { helpers::extract(extractor, view, LineStyle()); });
}

TEST(InvalidMesh, VertexIndexOutOfRange) {
    const Field field = precompute(small_mesh());
    for (std::uint32_t bad : {3u, 0xffffffffu}) {
        TriangleMesh mesh = small_mesh();
        mesh.triangles.push_back({0, bad, 1});
        const std::string message = expect_error(ErrorCode::InvalidMesh, [&] { precompute(mesh); });
        EXPECT_NE(message.find(std::to_string(bad)), std::string::npos) << message;
        expect_error(ErrorCode::InvalidMesh, [&] { measure_scale(mesh); });
        expect_error(ErrorCode::InvalidMesh, [&] { LineExtractor(mesh, field); });
    }
}

TEST(FieldMismatch, ColumnOfAnotherMesh) {
    const std::size_t vertices = small_mesh().positions.size();
    for (const FieldColumn& column : kFieldColumns)
        for (const std::size_t entries : {vertices - 1, vertices + 1}) {
            SCOPED_TRACE(column.key);
            Field field = precompute(small_mesh());
            column.resize(field, entries);
            EXPECT_FALSE(has_entries(field, vertices));
            expect_error(ErrorCode::FieldMismatch, [&] { LineExtractor(small_mesh(), field); });
        }
}

}  // namespace
