// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QValidator>

class QLineEdit;

namespace meshlab_host {

/// Corrects text in MeshLab's fields for numbers, which read as 0 what is not a number: a decimal
/// comma becomes a point, and what is not a number "nan", which is refused wherever it is read.
/// Anything can be typed; this is when the field is left.
class NumberValidator : public QValidator {
public:
    using QValidator::QValidator;

    State validate(QString& text, int& cursor) const override;
    void fixup(QString& text) const override;
};

}  // namespace meshlab_host
