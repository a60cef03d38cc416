// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

/// Receives the camera that a GL view sends. The signal is the same in all versions.
class ShotReceiver : public QObject {
    Q_OBJECT

public:
    /// Empty if the view does not answer.
    static std::optional<Shotm> ask(QObject& view);

public slots:
    void receive(QString name, Shotm shot);

private:
    std::optional<Shotm> shot_;
};

}  // namespace meshlab_host
