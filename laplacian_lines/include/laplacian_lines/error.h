// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace laplacian_lines {

/// Why a call of the core was refused. The arguments are unchanged.
enum class ErrorCode {
    InvalidOption,  ///< an option is outside its documented range
    InvalidMesh,    ///< a triangle's vertex or a vertex's normal is missing, or D is beyond 1e±15
    EmptyMesh,      ///< no triangle of positive area with finite corners is left
    FieldMismatch,  ///< a field and a mesh do not have the same vertices
    TooCostly,      ///< with these options, the mesh would take too long
    Cancelled,      ///< the progress callback asked to stop
};

/// The core throws nothing else but std::bad_alloc and what a declaration names. what() is a
/// sentence with what the user can do.
class Error : public std::runtime_error {
public:
    Error(ErrorCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    ErrorCode code() const noexcept { return code_; }

private:
    ErrorCode code_;
};

[[noreturn]] inline void refuse(const std::string& sentence,
                                ErrorCode code = ErrorCode::InvalidOption) {
    throw Error(code, sentence);
}

}  // namespace laplacian_lines
