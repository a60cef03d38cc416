// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_answerer.h"

#include <QApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include "gui.h"

namespace driver {

constexpr int between_looks = 20;  // ms

BoxAnswerer::BoxAnswerer() {
    lookAgain();
}

QStringList BoxAnswerer::takeTexts() {
    QStringList taken;
    taken.swap(texts_);
    return taken;
}

// Always a fresh single shot, armed before the answer, which may bring up the next box.
void BoxAnswerer::lookAgain() {
    QTimer::singleShot(between_looks, this, [this] {
        lookAgain();
        if (QWidget* modal = QApplication::activeModalWidget()) answer(modal);
    });
}

void BoxAnswerer::answer(QWidget* modal) {
    if (acceptOptionsBox(modal)) return;
    texts_ << describeBox(modal);
    if (auto* box = qobject_cast<QMessageBox*>(modal)) {
        for (auto standard : {QMessageBox::Yes, QMessageBox::Ok})
            if (QAbstractButton* button = box->button(standard)) return button->click();
    }
    modal->close();
}

}  // namespace driver
