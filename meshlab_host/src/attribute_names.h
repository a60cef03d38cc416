// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace meshlab_host {

constexpr const char* normal_attribute = "ll_normal";
constexpr const char* laplacian_normal_attribute = "ll_laplacian_normal";
constexpr const char* shape_diagonal_attribute = "ll_shape_diagonal";
constexpr const char* shape_off_diagonal_attribute = "ll_shape_off_diagonal";
constexpr const char* kernel_size_attribute = "ll_kernel_size";
constexpr const char* record_attribute = "ll_record";

}  // namespace meshlab_host
