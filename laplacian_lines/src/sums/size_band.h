// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace laplacian_lines {

/// A range of kernel sizes, whose sums are interpolated in log size between its Chebyshev nodes.
class SizeBand {
public:
    static constexpr int kMaxNodes = 8;

    SizeBand(double smallest, double largest, int node_count);

    const std::vector<double>& nodes() const { return nodes_; }  ///< √h, growing
    bool contains(double size) const { return size >= smallest_ && size <= largest_; }

    /// Σ_j weights[j] sum(nodes()[j]) is the sum for `size`. Interpolates sum / h², which changes
    /// little with h where f(q) − f(p) is summed.
    void weights(double size, double* weights) const;

private:
    double smallest_, largest_;
    std::vector<double> nodes_;
};

/// Bands that hold every kernel size once, with `node_count` nodes, or one node if all sizes are
/// equal.
std::vector<SizeBand> size_bands(const std::vector<float>& kernel_sizes, int node_count);

}  // namespace laplacian_lines
