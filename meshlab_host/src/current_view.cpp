// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/current_view.h"

#include <QApplication>
#include <QMdiArea>
#include <QMdiSubWindow>

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

namespace {

// A unique name, since all receivers get each answer.
const char* const kRequest = "laplacian_lines_current_view";

/// The window of the current document, null without one.
QWidget* document_window() {
    for (QWidget* widget : QApplication::allWidgets())
        if (auto* area = qobject_cast<QMdiArea*>(widget))
            if (QWidget* window = area->currentSubWindow()) return window;
    return nullptr;
}

bool is_view(const QWidget* widget) {
    return widget && widget->inherits("GLArea");
}

/// MeshLab's current view: the one that had the focus last, or else the newest.
QWidget* view_in(QWidget& window) {
    QWidget* last = nullptr;
    for (QWidget* child : window.findChildren<QWidget*>()) {
        if (child->inherits("MultiViewer_Container") && is_view(child->focusWidget()))
            return child->focusWidget();
        if (is_view(child)) last = child;
    }
    return last;
}

Eigen::Vector3d vector(const Point3m& p) {
    return {double(p[0]), double(p[1]), double(p[2])};
}

}  // namespace

std::optional<Shotm> ShotReceiver::ask(QObject& view) {
    ShotReceiver receiver;
    if (!QObject::connect(&view, SIGNAL(transmitShot(QString, Shotm)), &receiver,
                          SLOT(receive(QString, Shotm)), Qt::DirectConnection))
        return std::nullopt;
    QMetaObject::invokeMethod(&view, "sendViewerShot", Qt::DirectConnection,
                              Q_ARG(QString, QString(kRequest)));
    return receiver.shot_;
}

void ShotReceiver::receive(QString name, Shotm shot) {
    if (name == kRequest) shot_ = shot;
}

std::optional<CurrentView> current_view() {
    QWidget* window = document_window();
    QWidget* view = window ? view_in(*window) : nullptr;
    const std::optional<Shotm> shot = view ? ShotReceiver::ask(*view) : std::nullopt;
    if (!shot) return std::nullopt;
    // Type 1 is orthographic, as in views that MeshLab copies as text.
    return CurrentView{shot->Intrinsics.cameraType == 1, vector(shot->GetViewPoint()),
                       vector(shot->Axis(2)).normalized(), vector(shot->Axis(1)).normalized()};
}

}  // namespace meshlab_host

#include "current_view.moc"
