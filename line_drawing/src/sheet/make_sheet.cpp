// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing, step by step; 2 and 3 never hold their large data of the objects at the same time:
//  1. Views and sections are laid out on the page, which may refuse, before any long work.
//  2. Lines of the surface are found at the scale of the page.
//  3. What of them is seen is found view by view, and outlines are checked against the silhouette.
//  4. Strokes are drawn, then the page's annotations.
#include "line_drawing/make_sheet.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <set>
#include <thread>

#include "laplacian_lines/threads.h"
#include "line_drawing/words.h"
#include "options/paper_and_pens.h"
#include "planes/lettering.h"
#include "sheet/sheet_annotations.h"
#include "sheet/sheet_layout.h"
#include "sheet/view_drawing.h"
#include "sight/object_lines.h"
#include "sight/view_builder.h"

namespace line_drawing {
namespace {

using laplacian_lines::part;
using laplacian_lines::Progress;

constexpr double kCheckPixel = 0.25;  // mm on the sheet
// Of the diagonal: the largest √h of drawings, see PrecomputeOptions::drawn_kernel_size, and a
// rounding. Meshes with longer edges have no detail so fine: no √h is noted.
constexpr double kLargestDetail = 0.0401;
// Progress at which lines are found, and visibility is prepared.
constexpr double kLinesShare = 0.4, kSightShare = 0.55;
constexpr std::size_t kMostTrianglesAtOnce = 2000000;  // for views in parallel

void check(const SheetOptions& options) {
    if (options.views.empty() && options.sections.empty()) refuse("A drawing needs a view.");
    if (!(options.mm_per_unit > 0) || !std::isfinite(options.mm_per_unit))
        refuse("The unit of the mesh has to be a positive length.");
    for (const double pen : options.pens)
        if (!(pen > 0 && pen <= 10))
            refuse("The width of a pen has to be more than 0, up to 10 mm.");
}

/// Names sections like their marks, if any view has these.
void name_sections(std::vector<DrawnView>& views) {
    const bool has_marks = std::any_of(views.begin(), views.end(),
                                       [](const DrawnView& view) { return !view.marks.empty(); });
    std::size_t number = 0;
    for (DrawnView& view : views)
        if (view.is_section && has_marks) {
            const std::string letter = letter_of(number++);
            view.frame.name = letter + "–" + letter;
        }
}

/// Makes keys unique, since a view may be given twice.
void make_keys_unique(std::vector<SheetGroup>& groups) {
    std::set<std::string> keys;
    for (SheetGroup& group : groups) {
        const std::string key = group.key;
        for (int number = 2; !keys.insert(group.key).second; ++number)
            group.key = key + '-' + std::to_string(number);
    }
}

constexpr double kLeastMissing = 0.05;  // mm: less would be reported as 0.0 mm

std::string remark_on(const DrawnView& view, double missing) {
    return view.frame.name + ": " + in_decimals(missing, 1) +
           " mm of the outline were missing and have been drawn from the mesh's edges. Please "
           "report this with the mesh.";
}

std::string remark_on(const std::string& note) {
    return "Vessel: " + note +
           ". That is how far the rim goes around the axis, and how much the vessel leans, if "
           "known.";
}

/// Progress of equal tasks on several threads, reported only by the thread that made this, since
/// windows may show it.
class SharedProgress {
public:
    SharedProgress(Progress all, std::size_t tasks) : all_(std::move(all)), done_(tasks) {}

    Progress of(std::size_t task) {
        if (!all_) return {};
        return [this, task](double done, const char* stage) {
            done_[task] = done;
            const double sum = std::accumulate(done_.begin(), done_.end(), 0.);
            if (std::this_thread::get_id() == teller_ && !is_stopped_)
                is_stopped_ = !all_(sum / double(done_.size()), stage);
            return !is_stopped_;
        };
    }

private:
    const Progress all_;
    const std::thread::id teller_ = std::this_thread::get_id();
    std::vector<std::atomic<double>> done_;  // by task
    std::atomic<bool> is_stopped_{false};
};

struct Draft {
    SheetOptions options;
    std::vector<DrawnView> views;  ///< sections follow the views
    SheetLayout layout;
    std::vector<std::vector<laplacian_lines::LineSet>> lines = {};  ///< within faces, by view
    std::vector<std::string> remarks = {};                          ///< of the objects' meshes
    double kernel = 0;                                              ///< as Sheet's
};

Draft lay_out(ViewBuilder& builder, const SheetOptions& options) {
    std::vector<DrawnView> views;
    for (const ViewFrame& frame : options.views)
        views.push_back(builder.empty_view(frame, options));
    for (const Section& section : options.sections)
        views.push_back(builder.section_view(section, options));
    name_sections(views);
    SheetLayout layout = lay_out(views, options);
    double size = 0;
    for (std::size_t i = 0; i < views.size(); ++i)
        size = std::max(size, layout.placements[i].on_sheet(views[i].bounds).sizes().maxCoeff());
    SheetOptions with_pens = options;
    with_pens.pens = pens_for(size, options.pens);
    return {std::move(with_pens), std::move(views), std::move(layout)};
}

void find_lines(const ViewBuilder& builder, ObjectLines& lines, Draft& draft,
                const Progress& progress) {
    SheetOptions& options = draft.options;
    if (options.views.empty()) return;  // sections have their lines already
    const double scale = draft.layout.placements[0].scale;
    lines.prepare(options, scale, Kernel::Exact, progress);
    draft.remarks = lines.remarks();
    const bool is_given = options.kernel.size > 0,
               is_detail = lines.detail() <= kLargestDetail * builder.object_size().norm();
    options.kernel = {lines.kernel_size() * options.mm_per_unit * scale, false};
    if (is_given || is_detail) draft.kernel = options.kernel.size;
    for (std::size_t i = 0; i < options.views.size(); ++i)
        draft.lines.push_back(
            lines.extract(builder.view_of(draft.views[i], options), options.style));
}

/// Adds the visible lines of all views. Returns the length of missing outlines by view, mm.
std::vector<double> add_lines(const ViewBuilder& builder, Draft& draft, const Progress& progress) {
    const std::size_t count = draft.options.views.size();
    std::vector<double> missing(count);
    SharedProgress shared(progress, count);
    const auto add_lines_of = [&](std::size_t i) {
        builder.add_lines(draft.views[i], draft.lines[i], draft.options, shared.of(i));
        draft.lines[i].clear();
    };
    const auto check = [&](std::size_t i) {
        missing[i] = builder.check_outlines(draft.views[i], draft.options,
                                            kCheckPixel / draft.layout.placements[i].scale);
    };
    if (builder.triangle_count() <= kMostTrianglesAtOnce)
        laplacian_lines::in_parallel(count, [&](std::size_t i) { add_lines_of(i), check(i); });
    else  // one after the other, for memory; the one before is checked meanwhile
        for (std::size_t i = 0; i <= count; ++i)
            laplacian_lines::in_parallel(2, [&](std::size_t is_check) {
                if (is_check ? i > 0 : i < count) is_check ? check(i - 1) : add_lines_of(i);
            });
    laplacian_lines::report(progress, 1, "Finding what is seen");
    return missing;
}

Sheet draw(const ViewBuilder& builder, Draft& draft, const Progress& progress) {
    const SheetOptions& options = draft.options;
    const SheetLayout& layout = draft.layout;
    std::vector<DrawnView>& views = draft.views;
    Sheet sheet{layout.size, options.title, {}, layout.scale, draft.kernel};
    sheet.remarks = draft.remarks;
    const std::vector<double> missing = add_lines(builder, draft, progress);
    for (std::size_t i = 0; i < missing.size(); ++i) {
        if (missing[i] >= kLeastMissing) sheet.remarks.push_back(remark_on(views[i], missing[i]));
        if (!views[i].note.empty()) sheet.remarks.push_back(remark_on(views[i].note));
    }
    sheet.groups.resize(views.size());
    laplacian_lines::in_parallel(views.size(), [&](std::size_t i) {
        sheet.groups[i] = draw_view(views[i], i + 1, layout.placements[i], options);
    });
    make_keys_unique(sheet.groups);
    SheetGroup annotations =
        draw_annotations(views, layout, options.mm_per_unit * builder.object_size(), sheet.kernel,
                         options, sheet.remarks);
    if (!annotations.layers.empty()) sheet.groups.push_back(std::move(annotations));
    if (options.text == TextStyle::Outlines) outline_texts(sheet);
    return sheet;
}

/// Of one of tasks that take the same time.
Progress part_of(std::size_t task, std::size_t tasks, const Progress& all) {
    return part(all, double(task) / double(tasks), double(task + 1) / double(tasks));
}

}  // namespace

void outline_texts(Sheet& sheet) {
    for (SheetGroup& group : sheet.groups)
        for (SheetLayer& layer : group.layers) {
            for (const SheetText& text : layer.texts)
                layer.paths.push_back(outlines_of(text));
            layer.texts.clear();
        }
}

std::vector<Sheet> make_sheets(const Objects& objects, const std::vector<SheetOptions>& options,
                               const Progress& progress) {
    if (objects.empty()) refuse("A drawing needs an object.");
    for (const SheetOptions& o : options)
        check(o);
    ViewBuilder builder(objects);
    const std::size_t count = options.size();
    std::vector<Draft> drafts;
    for (SheetOptions o : options) {
        o.title = one_line(o.title);
        o.source = one_line(o.source);
        drafts.push_back(lay_out(builder, o));  // before much work, since it may refuse
    }
    {
        ObjectLines lines(objects);  // freed before visibility is prepared: both are large
        const Progress all = part(progress, 0, kLinesShare);
        for (std::size_t i = 0; i < count; ++i)
            find_lines(builder, lines, drafts[i], part_of(i, count, all));
    }
    builder.prepare(options, part(progress, kLinesShare, kSightShare));
    std::vector<Sheet> sheets;
    const Progress all = part(progress, kSightShare, 1);
    for (std::size_t i = 0; i < count; ++i)
        sheets.push_back(draw(builder, drafts[i], part_of(i, count, all)));
    return sheets;
}

}  // namespace line_drawing
