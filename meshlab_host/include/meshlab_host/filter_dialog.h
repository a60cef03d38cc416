// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <optional>

class QObject;
class QWidget;

namespace meshlab_host {

/// The dialog of a filter, which MeshLab makes a list with a line for each parameter: a label and
/// an editor. This adds widgets and writes into the editors as a user does; what MeshLab does with
/// their values stays untouched. Fields are found by the labels that MeshLab was told; what is not
/// found is left alone. GUI thread only.
class FilterDialog {
public:
    /// MeshLab is about to open the dialog: calls `furnish` once it is there, and not at all if it
    /// does not come, or has been furnished.
    static void whenOpen(const QString& filter, std::function<void(FilterDialog)> furnish);
    static bool isOpen(const QString& filter);

    /// Holds all fields, as long as the dialog shows them.
    QWidget* frame() const { return frame_; }

    /// What a field shows, of a switch "on" or "off".
    std::optional<QString> text(const QString& label) const;
    /// Choices that are not there are ignored.
    void setText(const QString& label, const QString& text);
    /// Also when it is not the user who changes a field.
    void whenChanged(const QObject* receiver, const std::function<void()>& changed);

    /// The dialog grows by what is added. False if there is no such field.
    bool addBelow(const QString& label, QWidget* widget);
    bool addBeside(const QString& label, QWidget* widget);
    void addLine(QWidget* widget);
    /// Less room between fields than MeshLab leaves: for small screens.
    void tighten();

private:
    explicit FilterDialog(QWidget* frame) : frame_(frame) {}
    static QWidget* find(const QString& filter);
    bool addTo(const QString& label, QWidget* widget, bool below);
    void fit();
    int missingHeight() const;

    QWidget* frame_;
};

}  // namespace meshlab_host
