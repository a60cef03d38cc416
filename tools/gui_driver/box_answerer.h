// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

namespace driver {

/// While it lives, modal boxes are answered as soon as they appear: options accepted, questions
/// answered with yes, other dialogs closed.
class BoxAnswerer : public QObject {
public:
    BoxAnswerer();
    QStringList takeTexts();  ///< of the boxes answered since the last call

private:
    void lookAgain();
    void answer(QWidget* modal);

    QStringList texts_;
};

}  // namespace driver
