// SPDX-License-Identifier: GPL-3.0-or-later
// Objects of a share group are made once, used by all its contexts, and forgotten with it.
#include "gl_functions.h"
#include "line_renderer/surface_renderer.h"
#include "line_test.h"
#include "per_share_group.h"

namespace {

using line_renderer::PerShareGroup;

/// Numbered objects.
class Numbers {
public:
    int current() {
        return group_.current([this] { return ++made_; });
    }
    int made() const { return made_; }
    int known() {
        int count = 0;
        group_.forEach([&count](int) { ++count; });
        return count;
    }

private:
    PerShareGroup<int> group_;
    int made_ = 0;
};

TEST(PerShareGroup, HasOneObjectForContextsThatShare) {
    Numbers numbers;
    GlContext first;
    EXPECT_EQ(numbers.current(), 1);
    EXPECT_EQ(numbers.current(), 1);
    GlContext other;
    EXPECT_EQ(numbers.current(), 2);
    GlContext partner(&first);
    EXPECT_EQ(numbers.current(), 1);
    other.makeCurrent();
    EXPECT_EQ(numbers.current(), 2);
    EXPECT_EQ(numbers.known(), 2);
}

TEST(PerShareGroup, ForgetsAnObjectWithTheLastContext) {
    Numbers numbers;
    auto first = std::make_unique<GlContext>();
    numbers.current();
    auto partner = std::make_unique<GlContext>(first.get());
    first.reset();
    partner->makeCurrent();
    EXPECT_EQ(numbers.current(), 1) << "the group has still a context";
    partner.reset();
    EXPECT_EQ(numbers.known(), 0);
    const GlContext next;
    EXPECT_EQ(numbers.current(), 2);
}

TEST(PerShareGroup, MayBeGoneBeforeTheContext) {
    auto context = std::make_unique<GlContext>();
    auto numbers = std::make_unique<Numbers>();
    EXPECT_EQ(numbers->current(), 1);
    numbers.reset();
    context.reset();
}

TEST(PerShareGroup, RefusesAgainWithoutAnotherTry) {
    PerShareGroup<int> group;
    int tries = 0;
    const auto make = [&tries]() -> int {
        ++tries;
        throw std::runtime_error("Not here.");
    };
    auto context = std::make_unique<GlContext>();
    for (int call = 0; call < 3; ++call) {
        try {
            group.current(make);
            FAIL() << "there is nothing to give";
        } catch (const std::runtime_error& refusal) {
            EXPECT_STREQ(refusal.what(), "Not here.");
        }
    }
    EXPECT_EQ(tries, 1);
    group.forEach([](int) { FAIL() << "there is none"; });
    context = std::make_unique<GlContext>();
    EXPECT_EQ(group.current([] { return 7; }), 7) << "another group is another try";
}

TEST(PerShareGroup, TriesAgainAfterALackOfMemory) {
    PerShareGroup<int> group;
    const GlContext context;
    EXPECT_THROW(group.current([]() -> int { throw std::bad_alloc(); }), std::bad_alloc);
    EXPECT_EQ(group.current([] { return 7; }), 7);
}

/// After other contexts have come and gone.
TEST(Renderers, DrawInAnyShareGroup) {
    line_renderer::SurfaceDepth depth;
    line_renderer::SurfaceBuffers buffers;
    line_renderer::SurfaceRenderer surfaces;
    line_renderer::LineRenderer lines;
    Rectangles rectangles;
    rectangles.add(20, 20, 90, 70, 0);
    const line_renderer::SurfacePointer surface = rectangles.surface();
    line_renderer::SurfaceAppearance paper;
    paper.paper = Qt::yellow;
    const auto picture = [&] {
        const Canvas canvas;
        line_renderer::LinePlacement placement = Canvas::placement();
        depth.forgetDepthBuffer();
        placement.depths = depth.copy();
        surfaces.paint(layerOf(surface), paper, placement.to_eye, placement.depths, buffers);
        line_renderer::RedrawClock clock;
        lines.upload(oneLine({{9, 9, 0}, {90, 80, 0}}), blackLines(3), placement);
        lines.draw(blackLines(3), placement, clock);
        return canvas.picture();
    };
    auto first = std::make_unique<GlContext>();
    const QImage expected = picture();
    ASSERT_EQ(colorAt(expected, 100, 30), QColor(Qt::yellow));
    ASSERT_LT(colorAt(expected, 9, 9).greenF(), 0.1);
    auto partner = std::make_unique<GlContext>(first.get());
    EXPECT_EQ(picture(), expected) << "shared";
    GlContext other;
    EXPECT_EQ(picture(), expected) << "not shared";
    first.reset();
    partner->makeCurrent();
    EXPECT_EQ(picture(), expected) << "shared with one that is gone";
    partner.reset();
    other.makeCurrent();
    EXPECT_EQ(picture(), expected) << "beside a group that is gone";
    const GlContext next;
    EXPECT_EQ(picture(), expected) << "after a group that is gone";
}

class SurfaceBuffersTest : public GlTest {
protected:
    static void GLAPIENTRY note(GLsizei n, GLuint* buffers) {
        original(n, buffers);
        names.insert(names.end(), buffers, buffers + n);
    }
    static inline std::vector<GLuint> names;
    static inline PFNGLGENBUFFERSPROC original = nullptr;
};

TEST_F(SurfaceBuffersTest, AreFreedWhenTheirSurfaceIsGone) {
    names.clear();
    const Replaced<PFNGLGENBUFFERSPROC> replaced(line_renderer::glGenBuffers.pointer(), note);
    original = replaced.before();
    Rectangles rectangles;
    rectangles.add(20, 20, 90, 70, 0);
    line_renderer::SurfaceBuffers buffers;
    line_renderer::SurfacePointer gone = rectangles.surface();
    const line_renderer::SurfacePointer kept = rectangles.surface();
    buffers.draw(layerOf(gone));
    buffers.draw(layerOf(gone));
    ASSERT_EQ(names.size(), 2u) << "vertices and triangles, handed over once";
    gone.reset();
    buffers.draw(layerOf(kept));
    buffers.draw(layerOf(kept));
    ASSERT_EQ(names.size(), 4u);
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    EXPECT_EQ(
        std::count_if(names.begin(), names.end(), [](GLuint name) { return glIsBuffer(name); }), 2);
}

}  // namespace
