// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <list>
#include <memory>
#include <string>
#include <vector>

#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute_options.h"
#include "laplacian_lines/progress.h"
#include "line_drawing/object.h"
#include "line_drawing/sheet_options.h"

namespace line_drawing {

/// Whether the nearest cached kernel will do.
enum class Kernel { Exact, Nearest };

/// The lines within objects' faces, from fields whose kernel suits the scale. Objects outlive this.
class ObjectLines {
public:
    /// Caches up to `most_bytes` of extractors that are not in use.
    explicit ObjectLines(const Objects& objects, std::size_t most_bytes = 0);

    /// Computes the fields for `scale`, mm on paper per mm of the object, unless given or cached.
    /// Returns whether the kernel is that of this scale.
    /// @throws laplacian_lines::Error, naming the object
    bool prepare(const SheetOptions& options, double scale, Kernel kernel,
                 const laplacian_lines::Progress& progress);

    /// One set per object, for LineVisibility.
    std::vector<laplacian_lines::LineSet> extract(const laplacian_lines::View& view,
                                                  const laplacian_lines::LineStyle& style);

    /// What users should know of the objects' meshes.
    std::vector<std::string> remarks() const { return in_use().remarks; }

    /// The largest √h, mesh units.
    double kernel_size() const { return largest(&Extractor::kernel); }
    /// The largest √h or mean edge, mesh units: no mesh has finer detail.
    double detail() const { return largest(&Extractor::detail); }

private:
    struct Extractor {
        std::shared_ptr<const laplacian_lines::LineExtractor> extractor;
        double kernel;  ///< √h, mesh units
        double detail;  ///< that or the mean edge, if known, the larger one
        bool is_given;  ///< from the object's own field
    };
    struct Extractors {
        laplacian_lines::PrecomputeOptions made;  ///< options of the fields that are not given
        bool is_exact;                            ///< these fields are computed by `made`
        std::vector<Extractor> extractors;        ///< by object
        std::vector<std::string> remarks;
    };

    static Extractor given_extractor(const Object& object);
    static std::size_t bytes_of(const Extractors& kept);
    /// 0 if `kept` has the kernels of `wanted`, else the largest factor between kernels, or
    /// infinite if these cannot be used instead.
    static double distance(const Extractors& kept,
                           const laplacian_lines::PrecomputeOptions& wanted);

    const Extractors& in_use() const { return kept_.front(); }
    double largest(double Extractor::*size) const;
    Extractors compute(const SheetOptions& options, double mm,
                       const laplacian_lines::PrecomputeOptions& wanted,
                       const laplacian_lines::Progress& progress) const;

    const Objects& objects_;
    const std::size_t most_bytes_;
    std::list<Extractors> kept_;  ///< the last used ones first
    laplacian_lines::ExtractionScratch scratch_;
};

}  // namespace line_drawing
